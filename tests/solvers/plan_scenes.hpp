#pragma once

#include "solvers/plan.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

// What tests of plans start from.

namespace searle::solvers::testing {

inline rheometry::ProtocolSpeed rate(double value) {
    return {value, rheometry::SpeedKind::shear_rate};
}
inline rheometry::ProtocolSpeed drive(double value) { return {value, rheometry::SpeedKind::drive}; }

inline Scene water_ramp() {
    Scene scene;
    scene.instrument = geometry::ConcentricCylinders{0.014, 0.015, 0.042};
    scene.fluid = {laws::flow::Newtonian{1.0016e-3}, 998.2};
    scene.protocol.program = rheometry::Ramp{rate(0.0), rate(100.0), 35.0, 100};
    return scene;
}

inline const PlanItem& item(const Plan& plan, const std::string& what) {
    const auto found =
        std::find_if(plan.items.begin(), plan.items.end(),
                     [&](const PlanItem& candidate) { return candidate.what == what; });
    if (found == plan.items.end()) {
        throw std::out_of_range("no item " + what);
    }
    return *found;
}

inline bool warns_of(const Plan& plan, const std::string& word) {
    return std::any_of(plan.warnings.begin(), plan.warnings.end(), [&](const std::string& warning) {
        return warning.find(word) != std::string::npos;
    });
}

} // namespace searle::solvers::testing
