#pragma once

namespace searle::geometry {

/// Single gap: a bob turning about its vertical axis inside a fixed cup; bob and cup have one axis
/// unless there is an offset.
/// All lengths in metres; valid when 0 < bob_radius < cup_radius and height > 0. z = 0 is the bob's
/// lower edge.
struct ConcentricCylinders {
    double bob_radius{};
    double cup_radius{};
    /// Wetted length that the torque is for.
    double height{};
    /// The fluid below and above the bob is part of the instrument; else a slice without ends.
    bool ends = false;
    double bottom_gap{};   ///< m, from the bob's flat bottom to the cup's floor; > 0 with ends
    double top_gap{};      ///< m, from the bob's top to the free surface; 0: not covered
    double shaft_radius{}; ///< m, where the top is covered
    /// Distance of the bob's axis, about which it turns, from the cup's, m, 0 <= offset < gap;
    /// above 0 a slice without ends alone. Conversions do not know of it, as instruments do not.
    double offset{};

    /// Width of the annular gap, m.
    [[nodiscard]] constexpr double gap() const { return cup_radius - bob_radius; }
    /// delta = cup_radius / bob_radius, > 1.
    [[nodiscard]] constexpr double radius_ratio() const { return cup_radius / bob_radius; }
};

} // namespace searle::geometry
