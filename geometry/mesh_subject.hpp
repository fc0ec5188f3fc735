#pragma once

#include "geometry/instrument.hpp"
#include "geometry/mesh_settings.hpp"
#include "geometry/outline.hpp"
#include "geometry/profile.hpp"
#include "geometry/slice.hpp"

#include <array>
#include <optional>
#include <variant>
#include <vector>

namespace searle::geometry {

/// What can be meshed.
using MeshSubject = std::variant<ConcentricCylinders, DoubleGap, DinBob, Box, Profile>;

/// A single gap with ends = true is a bob with a flat bottom.
[[nodiscard]] MeshSubject subject_of(const Instrument& instrument);

/// Distance from a double gap's rotor down to the floor, m; none: two gaps cut off at the rotor's
/// edge. With ends = true the instrument says where its floor is, unless a slice is asked for.
/// Throws MeshError where the settings contradict that.
[[nodiscard]] std::optional<double> floor_clearance_of(const DoubleGap& gap,
                                                       const MeshSettings& settings);

/// The fluid that a mesh fills, before it is cut into cells.
struct MeshDomain {
    std::vector<Outline> outlines{}; ///< of the section; several where the gaps are not connected
    bool revolved = true;            ///< false: drawn out along the flow (box)
    double length{};                 ///< of a box along the flow, m
    double gap{};    ///< narrowest distance between rotor and cup, m; of an eccentric bob the mean
    double offset{}; ///< of the rotor's axis, which the sweep is about, from the cup's, m
    Slice slice;     ///< angle 2 pi; the extent is not yet in it
};

/// Names of a double gap's rotor walls: beside the post, beside the cup.
[[nodiscard]] std::array<const char*, 2> rotor_patches(const MeshSettings& settings);

/// The section that the settings ask for. Throws MeshError where they do not fit the instrument.
[[nodiscard]] MeshDomain domain_of(const MeshSubject& subject, const MeshSettings& settings);

} // namespace searle::geometry
