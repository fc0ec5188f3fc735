#include "solvers/suspension/claimed_error.hpp"

#include "solvers/suspension/overdamped_motion.hpp"
#include "solvers/suspension/step_limits.hpp"

#include <algorithm>

namespace searle::solvers::suspension {
namespace {

bool has_films(const SuspensionInput& input) {
    return input.settings.hydrodynamics == Hydrodynamics::lubrication;
}

/// The step that the case forces over the longest that the accuracy would take; 1 without one.
double lengthened_steps(const SuspensionInput& input) {
    if (!input.settings.time_step)
        return 1.0;
    const double rate = input.fastest_wall_speed / input.box.length_y;
    if (has_films(input))
        return *input.settings.time_step / overdamped_step(input.accuracy, rate);
    const StepLimits limits(input);
    return *input.settings.time_step / std::min(limits.free(), limits.touching(0.0));
}

} // namespace

ClaimedError claimed_error(const SuspensionInput& input) {
    const double lengthened = lengthened_steps(input);
    if (has_films(input)) {
        const double accuracy = lengthened * std::clamp(input.accuracy, 2e-4, 1e-2);
        return {.forces = 1.5 * accuracy, .films = 0.15 * accuracy};
    }
    return {.forces = 2e-3 * lengthened * step_scale(input.accuracy), .films = 0.0};
}

} // namespace searle::solvers::suspension
