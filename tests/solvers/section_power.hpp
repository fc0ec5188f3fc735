#pragma once

#include "rheometry/fields/section_fields.hpp"

#include <cstddef>
#include <numbers>

namespace searle::solvers {

/// The power that the fluid takes up: the integral of stress times rate over the section, by the
/// trapezoidal rule on the cells, with 2 pi r.
inline double dissipation(const rheometry::fields::SectionFields& section) {
    const auto& rate = section.find("shear_rate")->values;
    const auto& stress = section.find("shear_stress")->values;
    double sum = 0.0;
    for (const auto& cell : section.cells) {
        double area = 0.0;
        double mean = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto& a = section.points[cell[k]];
            const auto& b = section.points[cell[(k + 1) % 4]];
            area += 0.5 * (a.r * b.z - b.r * a.z);
            mean += 0.25 * rate[cell[k]] * stress[cell[k]] * a.r;
        }
        sum += 2.0 * std::numbers::pi * area * mean;
    }
    return sum;
}

} // namespace searle::solvers
