#pragma once

#include "geometry/concentric_cylinders.hpp"

#include <array>

namespace searle::geometry {

/// Double gap: a thin cylindrical rotor between a fixed central post and a fixed cup.
/// radii = {post, rotor inside, rotor outside, cup}, metres, strictly increasing.
struct DoubleGap {
    std::array<double, 4> radii{};
    /// Wetted length of the rotor that the torque is for, m.
    double height{};
    /// The fluid under the rotor is part of the instrument; else a slice without ends.
    bool ends = false;
    double bottom_gap{}; ///< m, from the rotor's lower edge to the floor; > 0 with ends

    /// Width of the gap between post and rotor, m.
    [[nodiscard]] constexpr double inner_gap() const { return radii[1] - radii[0]; }
    /// Width of the gap between rotor and cup, m.
    [[nodiscard]] constexpr double outer_gap() const { return radii[3] - radii[2]; }
    /// delta = R4/R3, the radius ratio that the conversion is defined with.
    [[nodiscard]] constexpr double radius_ratio() const { return radii[3] / radii[2]; }
};

} // namespace searle::geometry
