#pragma once

#include <algorithm>

namespace searle::solvers {

/// How long a step towards a stop of the drive may be. The stress of a fluid that is not Newtonian
/// changes within the last instant there, and a step over the whole of it may be accepted by
/// accident, on every level: so steps halve what is left, until it is so little that their error
/// alone decides.
/// @param left     time to the stop, > 0
/// @param stretch  time that the drive's slowing down, or the part of it up to a row, takes
/// @param longest  without a stop
[[nodiscard]] inline double longest_before_stop(double left, double stretch, double longest) {
    constexpr double first_left_to_error = 1e-4; // of the stretch
    return left > first_left_to_error * stretch ? std::min(longest, 0.5 * left) : longest;
}

} // namespace searle::solvers
