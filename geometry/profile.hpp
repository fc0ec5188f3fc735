#pragma once

#include <string>
#include <vector>

namespace searle::geometry {

/// A corner of a rotor's or a cup's outline in the meridional half plane.
struct ProfilePoint {
    double r{}; ///< m, >= 0
    double z{}; ///< m
    /// Name of the patch from here to the next corner; empty: "bob" of a rotor, "cup" of a cup.
    std::string patch{};
};

/// A rotor and a cup of any axisymmetric shape. Both polylines start at their lowest point (on the
/// axis, or, for a part that is cut off below, both at the same height) and end at the free
/// surface.
struct Profile {
    std::vector<ProfilePoint> rotor;
    std::vector<ProfilePoint> cup;
};

} // namespace searle::geometry
