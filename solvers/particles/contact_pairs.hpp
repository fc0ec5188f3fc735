#pragma once

#include "laws/contact/contact_law.hpp"
#include "solvers/particles/neighbour_list.hpp"
#include "solvers/particles/pair_forces.hpp"
#include "solvers/particles/particle_store.hpp"
#include "solvers/particles/shear_box.hpp"

namespace searle::solvers::particles {

/// Where one thread adds forces and torques: the particles' own columns or a copy.
struct ForceColumns {
    double *fx, *fy, *fz, *tx, *ty, *tz;
};

struct ContactBlock;

/// The contacts that one thread sums. The ways differ in what they read, not in a digit of what
/// they add: a pair that does not touch adds 0.
class ContactPairs {
public:
    /// What an evaluation works with. The springs in `list` move by `step`.
    struct Scene {
        const laws::contact::AnyContact& law;
        const ParticleStore& particles;
        const ShearBox& box;
        NeighbourList& list;
        ForceColumns forces;
        double step; ///< s
        bool sampling;
    };
    /// Adds the contacts of `touching`, places in the list, to forces, torques and `sums`. Pairs
    /// are summed in the order given.
    void add(const Scene& scene, const AlignedVector<int>& touching, PairSums& sums);
    /// Looks for contacts in the list's places begin ... end - 1; pays where most of them touch.
    void add(const Scene& scene, int begin, int end, PairSums& sums);

private:
    /// What contacts need of a particle side by side, and where its forces are summed, so that a
    /// pair costs a few whole registers instead of two dozen places in memory. Pays where most
    /// particles touch.
    struct Rows {
        /// 16 a particle, as for sums and differences of a pair: x y z vx vy vz r wx, then
        /// wy wz wx wy wz r 1/m 0.
        Column state;
        Column force;       ///< 8 a particle: force, torque, 0, 0
        int begin{}, end{}; ///< the particles that have rows
    };
    Rows rows_;

    void start_rows(const ParticleStore& particles, int begin);
    void fill_rows(const ParticleStore& particles, const ForceColumns& forces, int until);
    void return_forces(const ForceColumns& forces) const;
    void read(ContactBlock& block, const int* first, const int* second, int count) const;
    void write(const ContactBlock& block, const int* first, const int* second, int count);

    template <bool friction, bool rolling, class Law>
    void add_with(const Scene& scene, const Law& law, const AlignedVector<int>* touching, int begin,
                  int end, PairSums& sums);
    void add_of(const Scene& scene, const AlignedVector<int>* touching, int begin, int end,
                PairSums& sums);
};

/// Adds (vector) (x) (force) of `count` pairs, one after the other: pairs without a force do not
/// change a digit.
void add_virial(Virial& virial, const double* rx, const double* ry, const double* rz,
                const double* fx, const double* fy, const double* fz, int count);

} // namespace searle::solvers::particles
