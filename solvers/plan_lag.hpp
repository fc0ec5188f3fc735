#pragma once

#include "rheometry/speed_history.hpp"
#include "solvers/plan_steady_curve.hpp"

#include <span>
#include <vector>

namespace searle::solvers {

/// Estimated inertia at one row.
struct LagForecast {
    double share{};   ///< |inertial torque| / (|steady torque| + |inertial torque|), 0 ... 1
    double largest{}; ///< the same from an upper estimate: every disturbance decays as slowly as at
                      ///< any speed since, and the fluid below and above a bob counts, too; for
                      ///< the decision whether inertia may be left out
};

/// Inertial torque of every row: the sum over the history's jumps and ramps of the response of the
/// flow linearised about the row's steady flow, each gap with the memory of a plane gap scaled to
/// the annulus' inertia and slowest decay (docs/plan.md). Exact for a Newtonian fluid long after
/// the last kink; within a few percent of it elsewhere. Cost: about a microsecond a row, whatever
/// the number of pieces.
[[nodiscard]] std::vector<LagForecast> forecast_lag(const rheometry::SpeedHistory& history,
                                                    SteadyCurve& curve);

/// See settling_times in solvers/plan.hpp.
[[nodiscard]] std::vector<double> settling_times(SteadyCurve& curve, double start_speed,
                                                 std::span<const double> speeds, double accuracy);

} // namespace searle::solvers
