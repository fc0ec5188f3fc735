#pragma once

#include "laws/contact/hooke.hpp"
#include "solvers/particles/neighbour_list.hpp"
#include "solvers/particles/pair_forces.hpp"
#include "solvers/particles/particle_store.hpp"
#include "solvers/particles/shear_box.hpp"

namespace searle::solvers::particles {

/// Where one thread adds forces and torques: the particles' own columns or a copy.
struct ForceColumns {
    double *fx, *fy, *fz, *tx, *ty, *tz;
};

/// Adds the contacts of `touching`, places in the list, to forces, torques and `sums`, and moves
/// their springs by `step`. Pairs are summed in the order given.
void add_contact_forces(const laws::contact::Hooke& law, const ParticleStore& particles,
                        const ShearBox& box, NeighbourList& list,
                        const AlignedVector<int>& touching, const ForceColumns& forces, double step,
                        bool sampling, PairSums& sums);

/// Adds (vector) (x) (force) of `count` pairs.
void add_virial(Virial& virial, const double* rx, const double* ry, const double* rz,
                const double* fx, const double* fy, const double* fz, int count);

} // namespace searle::solvers::particles
