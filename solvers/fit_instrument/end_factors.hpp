#pragma once

#include "geometry/din_bob.hpp"
#include "rheometry/fit/model.hpp"
#include "solvers/progress.hpp"

#include <span>
#include <vector>

namespace searle::solvers::fit_instrument {

/// c_L of a DIN bob at a list of speeds for one law, and how it changes with the law's parameters.
struct EndFactors {
    std::vector<double> values; ///< per speed
    /// d ln c_L / d parameter, speed by speed, in the search's coordinates.
    std::vector<double> slopes;
    std::vector<double> search; ///< the parameters that all this belongs to
    double relative_error{};    ///< of `values`: the solutions' own, and between the solutions
    int solutions{};
    bool reached = true; ///< false: a solution is less accurate than asked
};

/// Solves the creeping flow around the bob (docs/axisymmetric.md) at Chebyshev points of ln(speed),
/// doubled until ln c_L moves by less than `accuracy` between them. The slopes follow from
///  - c_L does not change when all stresses scale: sum of slopes times d parameter / d ln(stress)
///    is 0;
///  - a time scale of the law acts as the speed does: the same sum with d parameter / d ln(time) is
///    d ln c_L / d ln(speed);
///  - solutions with one parameter moved at a time, for the others (a flow index).
/// Solutions run side by side on all processors.
/// @param law     one with Model::for_solvers
/// @param speeds  rad/s, > 0, at least one
/// May throw Interrupted, from `progress`.
[[nodiscard]] EndFactors end_factors_of(const geometry::DinBob& bob,
                                        const rheometry::fit::Model& law,
                                        std::span<const double> search,
                                        std::span<const double> speeds, double accuracy,
                                        const ProgressSink& progress);

} // namespace searle::solvers::fit_instrument
