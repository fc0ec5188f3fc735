#include "solvers/suspension/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace searle::solvers::suspension {

void StepControl::adapt(double error) {
    // The error is of second order in the step. Growing slowly keeps one quiet step from deciding.
    const double wanted = error > 0.0 ? 0.9 * std::sqrt(allowed_ / error) : 2.0;
    step_ = std::min(step_ * std::clamp(wanted, 0.3, 1.05), longest_);
}

} // namespace searle::solvers::suspension
