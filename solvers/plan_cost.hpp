#pragma once

#include "solvers/plan_forecast.hpp"

namespace searle::solvers {

struct Cost {
    double seconds{};
    long unknowns{};
};

/// What a radial solve will take on one core, from the measured times of such solves: right within
/// a factor of about five.
[[nodiscard]] Cost radial_cost(const Scene& scene, const Forecast& forecast, bool transient);

/// The same for the flow around a DIN bob.
[[nodiscard]] Cost axisymmetric_cost(const Scene& scene, const Forecast& forecast, bool transient,
                                     bool secondary_flow);

} // namespace searle::solvers
