#pragma once

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <functional>

namespace searle::rheometry {

/// Steady flow in a gap with the cup at rest, for tests: adaptive quadrature of
/// omega = 1/2 integral of rate(q) dq / q from max(yield stress, tau/delta^2) to tau, and bisection
/// for its inverse. Shares no code with what it tests.
struct IndependentGapFlow {
    std::function<double(double)> rate; ///< 1/s at a stress in Pa
    double yield_stress{};
    double delta{};

    [[nodiscard]] double speed(double bob_stress) const {
        const double lowest = std::max(yield_stress, bob_stress / (delta * delta));
        if (!(bob_stress > lowest))
            return 0.0;
        const double range = std::log(bob_stress / lowest);
        const auto integrand = [&](double s) {
            return 3.0 * s * s * range * rate(lowest * std::exp(s * s * s * range));
        };
        return 0.5 * boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, 0.0,
                                                                                   1.0, 12, 1e-13);
    }
    [[nodiscard]] double bob_stress(double omega) const {
        double low = yield_stress > 0.0 ? std::log(yield_stress) : -40.0;
        double high = 40.0;
        for (int i = 0; i < 64; ++i) {
            const double middle = 0.5 * (low + high);
            (speed(std::exp(middle)) > omega ? high : low) = middle;
        }
        return std::exp(0.5 * (low + high));
    }
    [[nodiscard]] bool is_partly_sheared(double bob_stress) const {
        return bob_stress / (delta * delta) < yield_stress;
    }
};

inline IndependentGapFlow herschel_bulkley_flow(double yield_stress, double consistency,
                                                double flow_index, double delta) {
    return {[=](double q) {
                return q > yield_stress
                           ? std::pow((q - yield_stress) / consistency, 1.0 / flow_index)
                           : 0.0;
            },
            yield_stress, delta};
}

inline IndependentGapFlow casson_flow(double yield_stress, double plastic_viscosity, double delta) {
    return {[=](double q) {
                const double excess = std::sqrt(q) - std::sqrt(yield_stress);
                return excess > 0.0 ? excess * excess / plastic_viscosity : 0.0;
            },
            yield_stress, delta};
}

/// Carreau: viscosity = infinite + (zero - infinite) (1 + (time rate)^2)^((n - 1)/2), time = 1 s.
inline IndependentGapFlow carreau_flow(double zero, double infinite, double flow_index,
                                       double delta) {
    return {[=](double q) {
                double low = -60.0;
                double high = 60.0;
                for (int i = 0; i < 64; ++i) {
                    const double middle = 0.5 * (low + high);
                    const double rate = std::exp(middle);
                    const double viscosity =
                        infinite +
                        (zero - infinite) * std::pow(1.0 + rate * rate, 0.5 * (flow_index - 1.0));
                    (viscosity * rate > q ? high : low) = middle;
                }
                return std::exp(0.5 * (low + high));
            },
            0.0, delta};
}

} // namespace searle::rheometry
