#pragma once

#include "geometry/mesh_build.hpp"

#include <string>
#include <utility>
#include <vector>

namespace searle::geometry::testing {

/// One of each kind, of the size of laboratory instruments.
inline std::vector<std::pair<std::string, MeshSubject>> laboratory_subjects() {
    const Profile spindle{{{0, -3e-3, "bob_cone"},
                           {10e-3, 0, "bob"},
                           {10e-3, 20e-3, "bob_top"},
                           {3e-3, 22e-3, "shaft"},
                           {3e-3, 30e-3}},
                          {{0, -8e-3, "cup_floor"}, {12e-3, -8e-3}, {12e-3, 30e-3}}};
    return {{"single-gap", ConcentricCylinders{14e-3, 15e-3, 42e-3}},
            {"double-gap", DoubleGap{{20e-3, 20.38e-3, 21.96e-3, 22.38e-3}, 55e-3}},
            {"din-bob", DinBob{.bob_radius = 14e-3, .cup_radius = 1.0847 * 14e-3}},
            {"sharp bob", DinBob{.bob_radius = 14e-3,
                                 .cup_radius = 15.2e-3,
                                 .bottom_ratio = 2.2,
                                 .cone_angle = 1.0471975511965976}},
            {"box", Box{1e-3, 88e-3, 42e-3}},
            {"profile", spindle}};
}

} // namespace searle::geometry::testing
