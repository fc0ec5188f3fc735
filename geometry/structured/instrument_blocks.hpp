#pragma once

#include "geometry/mesh_subject.hpp"
#include "geometry/structured/block_layout.hpp"

namespace searle::geometry {

/// The blocks of an instrument's section. Its memory is that of one row of nodes per edge, whatever
/// the number of cells. Throws MeshError for a profile, which has no blocks, and where the settings
/// do not fit.
[[nodiscard]] BlockLayout blocks_of(const MeshSubject& subject, const MeshSettings& settings);

/// The same for the DIN bob down to its cup's floor.
[[nodiscard]] BlockLayout din_bob_blocks(const DinBob& bob, const MeshSettings& settings);

} // namespace searle::geometry
