#pragma once

#include "laws/flow/flow_law.hpp"
#include "rheometry/speed_history.hpp"
#include "solvers/progress.hpp"
#include "solvers/radial/rotor_gaps.hpp"

#include <span>
#include <vector>

namespace searle::solvers::radial {

/// Drive torque at every row, with the error found by comparing two resolutions.
struct TransientTorque {
    std::vector<double> torque; ///< N m (N for the box); fewer than asked when cut short
    std::vector<double> error;  ///< estimate, same unit
    bool reached{};             ///< every row meets the asked accuracy by its own estimate
    bool interrupted{};
    double worst_relative_error{}; ///< largest error over the row's scale, see `torque_scale`
    double momentum_defect{};      ///< see GapRun
    std::vector<bool> rests;       ///< rheometry::TorqueRow::rests; may be shorter than `torque`
    int levels{};
    int elements{};
    long steps{};
    long linear_solves{};
};

/// What an error is measured against at each row: the torque there; the torque of the steady flow
/// at that speed where inertia takes the actual one below it (it may pass through zero, and then
/// has no relative error); and at least a thousandth of the largest torque so far.
[[nodiscard]] std::vector<double> torque_scale(std::span<const double> torque,
                                               std::span<const double> steady);

/// Drive torque of the steady flow at the speed of each row, of all gaps.
[[nodiscard]] std::vector<double> steady_torque(std::span<const RotorGap> gaps,
                                                const laws::flow::AnyFlowLaw& law,
                                                const rheometry::SpeedHistory& history);

/// Drive torque at which all gaps are on the point of yielding, >= 0.
[[nodiscard]] double yield_torque(std::span<const RotorGap> gaps,
                                  const laws::flow::AnyFlowLaw& law);

/// Thickness of the momentum layer at the first row after each kink or jump; the smallest of them,
/// m.
[[nodiscard]] double thinnest_layer(const GapShape& shape, const laws::flow::AnyFlowLaw& law,
                                    const rheometry::SpeedHistory& history);

/// Solves all gaps on finer and finer levels, at least three (elements doubled, step tolerance by
/// sixteen, the order of the scheme), until the error bars are within `accuracy` at every row. The
/// finest level's torque is the result. Its bar is the difference from the level before, widened by
/// the neighbouring rows' and by a share of the difference one level earlier, so that two levels
/// that agree by accident are not believed; for a converging level it is several times the true
/// error.
[[nodiscard]] TransientTorque solve_levels(std::span<const RotorGap> gaps,
                                           const laws::flow::AnyFlowLaw& law,
                                           const rheometry::SpeedHistory& history, double accuracy,
                                           const ProgressSink& progress);

} // namespace searle::solvers::radial
