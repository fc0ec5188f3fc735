#pragma once

#include "geometry/concentric_cylinders.hpp"

namespace searle::geometry {

/// Bob with a conical tip after ISO 3219 / DIN 53019, in a flat-bottomed cup.
/// Lengths in metres; every ratio is to bob_radius. z = 0 is the lower edge of the cylinder.
struct DinBob {
    double bob_radius{};
    double cup_radius{};
    /// Length of the cylindrical part, which the torque is for.
    double length_ratio = 3.0;
    /// Cup floor below the LOWER EDGE OF THE CYLINDER (not below the tip).
    double bottom_ratio = 1.0;
    /// Free surface above the bob's top face.
    double top_ratio = 1.0;
    double shaft_ratio = 0.3;
    /// Full apex angle of the cone, rad; ISO: 120 degrees.
    double cone_angle = 2.0943951023931953;

    [[nodiscard]] constexpr double gap() const { return cup_radius - bob_radius; }
    [[nodiscard]] constexpr double radius_ratio() const { return cup_radius / bob_radius; }
    /// Length of the cylindrical part, m.
    [[nodiscard]] constexpr double height() const { return length_ratio * bob_radius; }
    /// Height of the cone, m: R / tan(cone_angle / 2).
    [[nodiscard]] double cone_height() const;
    /// Distance between the cone's tip and the cup floor, m; must be > 0.
    [[nodiscard]] double tip_clearance() const;
    /// Volume of fluid up to the free surface, m^3; 8.1695 R^3 for the ISO proportions.
    [[nodiscard]] double fill_volume() const;
};

/// A single gap with ends = true: its bob is a DIN bob with a flat bottom.
[[nodiscard]] DinBob with_flat_bottom(const ConcentricCylinders& gap);

} // namespace searle::geometry
