#pragma once

namespace searle::geometry {

/// The unrolled single gap: two parallel plates, one moving in its own plane.
/// Lengths in metres, all > 0.
struct Box {
    /// Distance between the walls (velocity gradient direction).
    double gap{};
    /// Extent along the flow.
    double length{};
    /// Extent along the vorticity.
    double width{};

    /// Area of the moving wall, m^2.
    [[nodiscard]] constexpr double wall_area() const { return length * width; }
};

} // namespace searle::geometry
