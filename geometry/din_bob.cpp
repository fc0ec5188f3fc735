#include "geometry/din_bob.hpp"

#include <cmath>
#include <numbers>

namespace searle::geometry {

double DinBob::cone_height() const { return bob_radius / std::tan(0.5 * cone_angle); }

double DinBob::tip_clearance() const { return bottom_ratio * bob_radius - cone_height(); }

double DinBob::fill_volume() const {
    const double filled_height = (bottom_ratio + length_ratio + top_ratio) * bob_radius;
    const double cup = filled_height * cup_radius * cup_radius;
    const double cone = cone_height() * bob_radius * bob_radius / 3.0;
    const double cylinder = height() * bob_radius * bob_radius;
    const double shaft_radius = shaft_ratio * bob_radius;
    const double shaft = top_ratio * bob_radius * shaft_radius * shaft_radius;
    return std::numbers::pi * (cup - cone - cylinder - shaft);
}

} // namespace searle::geometry
