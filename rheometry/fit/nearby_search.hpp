#pragma once

#include "rheometry/fit/least_squares.hpp"

#include <span>

namespace searle::rheometry::fit {

/// Levenberg-Marquardt with bounds for the many short searches of a fit, first looks and profiles:
/// the same minimum as `minimise`, without what a general solver sets up for each search. Works on
/// normal equations, so that it is good for a relative decrease down to some 1e-12, not for the
/// last digits. Steps follow the damped equations of the parameters that are not pressed against a
/// bound (projected search; Kanzow, Yamashita & Fukushima 2004, J. Comput. Appl. Math. 172, 375);
/// damping as in Nielsen 1999, report IMM-REP-1999-05.
/// @param start  at most 12 parameters; outside the bounds it is moved to them
[[nodiscard]] Minimum minimise_nearby(const LeastSquaresProblem& problem,
                                      std::span<const double> start, const SearchEffort& effort);

} // namespace searle::rheometry::fit
