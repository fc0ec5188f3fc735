#pragma once

#include "rheometry/speed_history.hpp"

#include <span>
#include <vector>

namespace searle::solvers::radial {

/// What each row of a history tells of the rows beside it.
struct RowLinks {
    std::vector<bool> smooth; ///< no jump of the speed separates it from the row before
    /// The drive stands still; there the stress is singular in time for every law but Newton's,
    /// for which no row is marked.
    std::vector<bool> stops;
};

[[nodiscard]] RowLinks row_links(const rheometry::SpeedHistory& history, bool newtonian);

/// Differences of two levels relative to each row's scale, widened by the neighbours' on this side
/// of a jump: two levels can agree at a row by accident. A row that stops says nothing of one that
/// does not.
/// @param fine, coarse  torques of the history's first rows
/// @param scale         of the rows of `fine`, >= 0
/// @param rests         rows whose torque is left open: no difference
[[nodiscard]] std::vector<double> level_differences(std::span<const double> fine,
                                                    std::span<const double> coarse,
                                                    std::span<const double> scale,
                                                    const RowLinks& links,
                                                    const std::vector<bool>& rests);

} // namespace searle::solvers::radial
