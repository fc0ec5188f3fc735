#pragma once

#include "solvers/particles/particle_store.hpp"
#include "solvers/particles/shear_box.hpp"

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace searle::solvers::particles {

/// One size of a mixture. share: of the particles' volume, the shares of all sizes sum to 1.
struct SizeShare {
    double diameter{}; ///< m
    double share{};
};

struct PackingRequest {
    std::vector<SizeShare> sizes; ///< at least one
    /// Standard deviation of ln(diameter) by number; 0: none. Each size is then the median of its
    /// class.
    double spread{};
    double volume_fraction{}; ///< of the box, > 0
    double density{};         ///< kg/m^3
    double gap{};             ///< surface distance that is kept where there is room, m, >= 0
    std::uint64_t seed{};
};

/// The generator could not place the particles without overlap.
struct PackingError : std::runtime_error {
    PackingError(const std::string& message, double reached)
        : std::runtime_error(message), reached_fraction(reached) {}
    double reached_fraction; ///< volume fraction at which what was found has no overlap
};

/// Radii of the particles whose volume comes next to volume_fraction of the box from below, largest
/// first; drawn from the seed where the sizes are spread.
[[nodiscard]] std::vector<double> radii_for(const PackingRequest& request, const ShearBox& box);

/// Spheres at random without overlap, at rest. Points drawn from the seed push each other apart
/// until nothing overlaps (as Lubachevsky & Stillinger's packings, without dynamics). Throws
/// PackingError beyond what it reaches, about 0.62 for equal spheres in a periodic box.
[[nodiscard]] ParticleStore random_packing(const PackingRequest& request, ShearBox box);

} // namespace searle::solvers::particles
