#pragma once

#include <cstddef>
#include <functional>

namespace searle::solvers::fit_instrument {

/// Runs `count` independent pieces of work on all processors. Which thread does which piece does
/// not matter to the results, so that runs repeat. An exception of a piece is thrown here once all
/// threads have stopped; no further piece is started after it.
/// @param between  called on the calling thread between its pieces; may throw to stop the work
void side_by_side(std::size_t count, const std::function<void(std::size_t)>& piece,
                  const std::function<void()>& between);

} // namespace searle::solvers::fit_instrument
