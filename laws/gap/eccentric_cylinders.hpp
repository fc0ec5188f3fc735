#pragma once

#include <cmath>
#include <numbers>

namespace searle::laws::gap {

/// Creeping flow of a Newtonian fluid between two cylinders with parallel axes, the inner one
/// turning about its own axis, the outer one at rest: Stokes flow in bipolar coordinates (Jeffery
/// 1922, Proc. R. Soc. A 101, 169; Wannier 1950, Quart. Appl. Math. 8, 1), per length of cylinder.
///
/// With k = r_1 / r_2, e the distance of the axes, T the difference of the two circles' bipolar
/// coordinates, cosh T = (r_1^2 + r_2^2 - e^2) / (2 r_1 r_2), and
///     G = T (1 - k)^2 - 2 k (sinh T - T):
///     torque on the inner cylinder about its own axis  4 pi eta omega r_1^2 [T coth T - 1 +
///     (e/r_2)^2] / G force that holds it, across the line of axes     4 pi eta omega k^2 e / G
/// docs/eccentric-bob.md derives them. Limits: e = 0 gives 4 pi eta omega r_1^2 / (1 - k^2) and no
/// force; a narrow gap c = r_2 - r_1 with eps = e / c gives Sommerfeld's journal bearing (1904),
///     4 pi eta omega r^3 / c (1 + 2 eps^2) / ((2 + eps^2) sqrt(1 - eps^2)) and
///     12 pi eta omega r^3 / c^2 eps / ((2 + eps^2) sqrt(1 - eps^2)).
struct EccentricCylinders {
    double inner_radius{}; ///< r_1, m, > 0
    double outer_radius{}; ///< r_2, m, > r_1
    double offset{};       ///< e, m, 0 <= e < r_2 - r_1

    /// sinh T; without the difference of near numbers that cosh T - 1 is in a narrow gap.
    [[nodiscard]] double sinh_of_distance() const {
        const double gap = outer_radius - inner_radius;
        const double sum = outer_radius + inner_radius;
        return std::sqrt((gap - offset) * (gap + offset) * (sum - offset) * (sum + offset)) /
               (2.0 * inner_radius * outer_radius);
    }
    /// T > 0, without unit; ln(r_2 / r_1) where the axes meet.
    [[nodiscard]] double distance() const { return std::asinh(sinh_of_distance()); }

    /// Torque of the drive over eta omega, per length, m^2.
    [[nodiscard]] double torque_factor() const {
        const double eccentric = offset / outer_radius;
        return 4.0 * std::numbers::pi * inner_radius * inner_radius *
               (curl_term() + eccentric * eccentric) / denominator();
    }
    /// Torque over that of the same cylinders with one axis, >= 1: by this much a rheometer that
    /// knows nothing of the offset reads a Newtonian fluid too thick.
    [[nodiscard]] double torque_ratio() const {
        const double ratio = inner_radius / outer_radius;
        return torque_factor() * (1.0 - ratio) * (1.0 + ratio) /
               (4.0 * std::numbers::pi * inner_radius * inner_radius);
    }
    /// Force that the bearing holds the inner cylinder with over eta omega, per length, m; at right
    /// angles to the line of axes.
    [[nodiscard]] double force_factor() const {
        const double ratio = inner_radius / outer_radius;
        return 4.0 * std::numbers::pi * ratio * ratio * offset / denominator();
    }

private:
    /// sum over n >= 1 of weight(n) T^(2n+1) / (2n+1)!
    template <class Weight>
    [[nodiscard]] static double series(double t, const Weight& weight) {
        double power = t;
        double sum = 0.0;
        for (int n = 1; n < 12; ++n) {
            power *= t * t / (2.0 * n * (2.0 * n + 1.0));
            sum += weight(n) * power;
        }
        return sum;
    }
    static constexpr double series_limit = 1.0; ///< its terms then end below 1e-22
    /// T coth T - 1
    [[nodiscard]] double curl_term() const {
        const double t = distance();
        if (t > series_limit)
            return t / std::tanh(t) - 1.0;
        return series(t, [](int n) { return 2.0 * n; }) / std::sinh(t); // T cosh T - sinh T
    }
    [[nodiscard]] double denominator() const {
        const double t = distance();
        const double ratio = inner_radius / outer_radius;
        const double narrow = (outer_radius - inner_radius) / outer_radius;
        const double excess =
            t > series_limit ? std::sinh(t) - t : series(t, [](int) { return 1.0; });
        return t * narrow * narrow - 2.0 * ratio * excess;
    }
};

} // namespace searle::laws::gap
