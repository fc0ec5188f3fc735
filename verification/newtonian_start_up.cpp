#include "verification/newtonian_start_up.hpp"

#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/bessel_prime.hpp>
#include <boost/math/tools/roots.hpp>

#include <cmath>
#include <numbers>

namespace searle::verification {
namespace {

using boost::math::cyl_bessel_j;
using boost::math::cyl_bessel_j_prime;
using boost::math::cyl_neumann;
using boost::math::cyl_neumann_prime;

} // namespace

double annulus_lag(double inner, double outer, double kinematic_viscosity, bool outer_wall_moves) {
    // v = beta (t f + g), f = A r + B/r with f = r at the moving wall and 0 at the other;
    // nu (g'' + g'/r - g/r^2) = f, g = 0 at both. In long double, for the narrow gap cancels.
    using Real = long double;
    const Real a = inner;
    const Real b = outer;
    const Real squares = (b - a) * (b + a);
    const Real B = (outer_wall_moves ? -1 : 1) * a * a * b * b / squares;
    const Real A = outer_wall_moves ? b * b / squares : -a * a / squares;
    const auto particular = [&](Real r) { return A * r * r * r / 8 + B * r * std::log(r / a) / 2; };
    // C r + D / r cancels the particular solution at both walls.
    const Real pa = particular(a);
    const Real pb = particular(b);
    const Real C = (pa * a - pb * b) / squares;
    const Real D = -(pa + C * a) * a;
    // The stress goes with r d(v/r)/dr = v' - v/r, and g = 0 at the walls.
    const Real r = outer_wall_moves ? b : a;
    const Real slope = 3 * A * r * r / 8 + B * (std::log(r / a) + 1) / 2 + C - D / (r * r);
    return static_cast<double>(slope / (-2 * B / (r * r)) / kinematic_viscosity);
}

NewtonianStartUp NewtonianStartUp::annulus(double inner, double outer, double kinematic_viscosity,
                                           int modes) {
    NewtonianStartUp result;
    result.lag_ = annulus_lag(inner, outer, kinematic_viscosity);
    const double spacing = std::numbers::pi / (outer - inner);
    const auto mode = [&](double kappa, double r) {
        return cyl_bessel_j(1, kappa * r) * cyl_neumann(1, kappa * outer) -
               cyl_neumann(1, kappa * r) * cyl_bessel_j(1, kappa * outer);
    };
    // F of the steady flow per unit speed and viscosity: r^3 w' = -2 a^2 b^2 / (b^2 - a^2).
    const double steady = 2.0 * inner * inner * outer * outer / ((outer - inner) * (outer + inner));
    for (int k = 1; k <= modes; ++k) {
        std::uintmax_t iterations = 100;
        const auto bracket = boost::math::tools::toms748_solve(
            [&](double kappa) { return mode(kappa, inner); }, (k - 0.5) * spacing,
            (k + 0.5) * spacing, boost::math::tools::eps_tolerance<double>(52), iterations);
        const double kappa = 0.5 * (bracket.first + bracket.second);
        const double slope_inner =
            cyl_bessel_j_prime(1, kappa * inner) * cyl_neumann(1, kappa * outer) -
            cyl_neumann_prime(1, kappa * inner) * cyl_bessel_j(1, kappa * outer);
        const double slope_outer = -2.0 / (std::numbers::pi * kappa * outer);
        // integral of r Z^2 dr between two zeros of Z.
        const double norm = 0.5 * (outer * outer * slope_outer * slope_outer -
                                   inner * inner * slope_inner * slope_inner);
        const double decay = kinematic_viscosity * kappa * kappa;
        // c_k = -a^6 phi'(a)^2 nu / (lambda N) per unit viscosity, phi'(a) = kappa Z' / a.
        const double wall = inner * inner * kappa * slope_inner;
        const double amplitude = wall * wall * kinematic_viscosity / (decay * norm);
        result.decay_.push_back(decay);
        result.share_.push_back(amplitude / (steady * decay));
    }
    return result;
}

NewtonianStartUp NewtonianStartUp::plane(double gap, double kinematic_viscosity, int modes) {
    NewtonianStartUp result;
    result.lag_ = gap * gap / (3.0 * kinematic_viscosity);
    for (int k = 1; k <= modes; ++k) {
        const double kappa = k * std::numbers::pi / gap;
        result.decay_.push_back(kinematic_viscosity * kappa * kappa);
        result.share_.push_back(2.0 / result.decay_.back());
    }
    return result;
}

double NewtonianStartUp::viscosity_ratio(double time) const {
    double remaining = 0.0;
    for (std::size_t k = share_.size(); k-- > 0;) {
        remaining += share_[k] * std::exp(-decay_[k] * time);
    }
    return 1.0 + (lag_ - remaining) / time;
}

} // namespace searle::verification
