#include "solvers/fit_instrument/geometry_candidates.hpp"

#include "rheometry/conversion/conversion.hpp"
#include "rheometry/fit/prediction.hpp"
#include "solvers/fit_instrument/instrument_forward.hpp"
#include "solvers/plan_forecast.hpp"
#include "solvers/stability/taylor_threshold.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace searle::solvers::fit_instrument {
namespace {

namespace fit = rheometry::fit;

constexpr std::size_t points = 81;
constexpr DriveLimits box_limits{1e-6, 0.1, 1e-3, 50.0};

struct Describe {
    std::string operator()(const geometry::ConcentricCylinders& gap) const {
        return fmt::format("single-gap, {:g}/{:g} mm, {:g} mm high", 1e3 * gap.bob_radius,
                           1e3 * gap.cup_radius, 1e3 * gap.height);
    }
    std::string operator()(const geometry::DinBob& bob) const {
        return fmt::format("din-bob, {:g}/{:g} mm", 1e3 * bob.bob_radius, 1e3 * bob.cup_radius);
    }
    std::string operator()(const geometry::DoubleGap& gaps) const {
        return fmt::format("double-gap, {:g}/{:g}/{:g}/{:g} mm", 1e3 * gaps.radii[0],
                           1e3 * gaps.radii[1], 1e3 * gaps.radii[2], 1e3 * gaps.radii[3]);
    }
    std::string operator()(const geometry::Box& box) const {
        return fmt::format("box, {:g} mm", 1e3 * box.gap);
    }
};

/// Secondary flow at a DIN bob's ends may have this share of a torque.
constexpr double most_end_flow = 0.01;

/// Beyond the onset of Taylor vortices, or with secondary flow at the ends, for the viscosity that
/// the torque shows.
bool is_disturbed(const geometry::Instrument& instrument, const rheometry::Conversion& conversion,
                  double density, double speed, double torque) {
    double radius = 0.0;
    double width = 0.0;
    const auto* bob = std::get_if<geometry::DinBob>(&instrument);
    if (const auto* gap = std::get_if<geometry::ConcentricCylinders>(&instrument)) {
        radius = gap->bob_radius;
        width = gap->gap();
    } else if (bob != nullptr) {
        radius = bob->bob_radius;
        width = bob->gap();
    } else if (const auto* gaps = std::get_if<geometry::DoubleGap>(&instrument)) {
        radius = gaps->radii[2];
        width = gaps->outer_gap();
    } else {
        return false;
    }
    const double viscosity = conversion.shear_stress(torque) / conversion.shear_rate(speed);
    const double momentum = speed * density / viscosity;
    return radius * width * momentum > stability::taylor_threshold(width / radius).reynolds ||
           (bob != nullptr && end_flow_share(bob->radius_ratio(), bob->length_ratio,
                                             radius * radius * momentum) > most_end_flow);
}

} // namespace

std::vector<GeometryChoice> usual_geometries(const std::vector<geometry::Instrument>& own) {
    const std::vector<geometry::Instrument> usual{
        geometry::ConcentricCylinders{0.014, 0.015, 0.042},
        geometry::DoubleGap{{0.020, 0.02038, 0.02196, 0.02238}, 0.05},
        geometry::DinBob{.bob_radius = 0.014, .cup_radius = 0.0152},
        geometry::Box{0.001, 0.05, 0.05}};
    std::vector<GeometryChoice> choices;
    for (const geometry::Instrument& instrument : own) {
        std::string name = std::visit(Describe{}, instrument) + " (the case's)";
        if (std::ranges::find(choices, name, &GeometryChoice::name) == choices.end())
            choices.push_back({std::move(name), instrument});
    }
    for (const geometry::Instrument& instrument : usual) {
        const bool there = std::ranges::any_of(own, [&](const geometry::Instrument& each) {
            return each.index() == instrument.index();
        });
        if (!there)
            choices.push_back({std::visit(Describe{}, instrument), instrument});
    }
    return choices;
}

fit::Candidates candidates_of(const GeometryChoice& choice, const fit::Model& law,
                              const fit::FitResult& result, double density, bool stress_results) {
    const bool turns = geometry::rotates(choice.instrument);
    const DriveLimits limits = turns ? DriveLimits{} : box_limits;
    const rheometry::Conversion conversion = rheometry::conversion_for(choice.instrument, {});
    const bool slip = result.search.size() > law.size();
    const std::vector<double> all = fit::spread_rates(limits.slowest, limits.fastest, points);
    const auto forward_at = [&](const std::vector<double>& speeds) {
        return InstrumentForward(law,
                                 {{.instrument = choice.instrument,
                                   .end_factors = {conversion.end_factor},
                                   .speeds = speeds,
                                   .torques = {}}},
                                 slip);
    };
    fit::Candidates found;
    found.name = choice.name;
    for (const double speed : all) {
        double torque = 0.0;
        if (!forward_at({speed}).predict(result.search, std::span(&torque, 1), {}) ||
            torque < limits.least_torque || torque > limits.largest_torque)
            continue;
        if (std::isfinite(density) &&
            is_disturbed(choice.instrument, conversion, density, speed, torque))
            break;
        found.speeds.push_back(speed);
        found.rates.push_back(conversion.shear_rate(speed));
    }
    if (!found.speeds.empty())
        found.sensitivities =
            fit::sensitivities(forward_at(found.speeds), result,
                               stress_results ? 1.0 / conversion.stress_per_torque : 1.0);
    return found;
}

} // namespace searle::solvers::fit_instrument
