#include "solvers/suspension/stable_step.hpp"

#include <cmath>

namespace searle::solvers::suspension {
namespace {

bool is_stable(double step, double tau, double kappa) {
    const double lost = -std::expm1(-step / tau);
    const double kept = 1.0 - lost;
    const double a = step - tau * lost;
    const double b = tau * lost * lost;
    return kappa * (a * (1.0 + kept) - b) < 2.0 * (1.0 + kept) && kappa * (b - kept * a) < lost;
}

} // namespace

double longest_stable_step(double stiffness, double mass, double drag) {
    const double tau = mass / drag;
    const double kappa = stiffness / drag;
    // The limit lies between those without mass and without drag, or a little beyond them.
    double low = 0.0;
    double high = 4.0 / kappa + 4.0 * std::sqrt(mass / stiffness);
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (is_stable(middle, tau, kappa) ? low : high) = middle;
    }
    return low;
}

} // namespace searle::solvers::suspension
