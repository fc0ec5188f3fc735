#pragma once

#include "casefile/keys.hpp"
#include "geometry/instrument.hpp"
#include "geometry/mesh_settings.hpp"
#include "geometry/profile.hpp"

#include <optional>
#include <variant>

namespace searle::geometry {

/// A DIN bob as a case file says it: the cup by its radius or by its ratio to the bob.
struct DinBobAsWritten {
    DinBob bob;
    std::optional<double> cup_radius;
    std::optional<double> radius_ratio;
};

/// The section [geometry].
struct GeometryAsWritten {
    std::variant<ConcentricCylinders, DoubleGap, DinBobAsWritten, Box, Profile> instrument;
};

[[nodiscard]] casefile::Keys<ConcentricCylinders> concentric_cylinders_keys();
[[nodiscard]] casefile::Keys<DoubleGap> double_gap_keys();
[[nodiscard]] casefile::Keys<DinBobAsWritten> din_bob_keys();
[[nodiscard]] casefile::Keys<Box> box_keys();
[[nodiscard]] casefile::Keys<Profile> profile_keys();
[[nodiscard]] casefile::Keys<GeometryAsWritten> geometry_keys();
[[nodiscard]] casefile::Keys<MeshSettings> mesh_keys();

/// The instrument that a section without faults describes; for a profile the cylinders that its
/// stress and rate refer to.
[[nodiscard]] Instrument instrument_of(const GeometryAsWritten& written);

} // namespace searle::geometry
