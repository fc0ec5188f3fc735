#pragma once

#include "geometry/outline.hpp"

namespace searle::geometry {

/// What was found about an outline that is in order.
struct OutlineFindings {
    double clearance{};        ///< narrowest distance between a rotor's edge and a fixed one, m
    double smallest_feature{}; ///< shortest edge, or distance of edges that are not neighbours, m
};

/// Checks that the outline is a simple polygon, anticlockwise, in r >= 0, with exact predicates.
/// Throws MeshError; it names both edges where two of them cross or touch.
[[nodiscard]] OutlineFindings check_outline(const Outline& outline);

/// A patch that turns with the rotor (bob, bob_..., shaft).
[[nodiscard]] bool is_rotor_patch(std::string_view patch);

} // namespace searle::geometry
