#pragma once

namespace searle::geometry {

/// Single gap: a bob turning inside a fixed cup, about their common vertical axis.
/// All lengths in metres; valid when 0 < bob_radius < cup_radius and height > 0.
struct ConcentricCylinders {
    double bob_radius{};
    double cup_radius{};
    /// Wetted length that the torque is for.
    double height{};

    /// Width of the annular gap, m.
    [[nodiscard]] constexpr double gap() const { return cup_radius - bob_radius; }
    /// delta = cup_radius / bob_radius, > 1.
    [[nodiscard]] constexpr double radius_ratio() const { return cup_radius / bob_radius; }
};

} // namespace searle::geometry
