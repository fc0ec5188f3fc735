#pragma once

#include "solvers/particles/particle_store.hpp"
#include "solvers/particles/shear_box.hpp"

#include <cstddef>

namespace searle::solvers::particles {

/// From the centre of one particle to the nearest image of another, m. For loops over pairs that
/// are not vectorised; those that are read the columns themselves.
struct PairVector {
    double x, y, z;

    PairVector(const ParticleStore& particles, const NearestImage& nearest, std::size_t from,
               std::size_t to)
        : x(particles.x[to] - particles.x[from]), y(particles.y[to] - particles.y[from]),
          z(particles.z[to] - particles.z[from]) {
        nearest(x, y, z);
    }

    [[nodiscard]] double squared_length() const { return x * x + y * y + z * z; }
};

} // namespace searle::solvers::particles
