#pragma once

#include "solvers/particles/particle_store.hpp"
#include "solvers/particles/shear_box.hpp"

#include <span>

namespace searle::solvers::particles {

/// Pairs whose surfaces are closer than a reach plus a skin (Verlet 1967), found through cells
/// (Quentrec & Brot 1973). The list stays complete while particles move: the mean shear, which
/// deforms it, and what they move beside it are counted apart, so that a fast wall alone does not
/// make it stale. Steps are counted by their upper bounds; when these use the skin up, the way
/// since the rebuild is measured, which is far shorter where particles tremble in place.
///
/// A rebuild wraps the particles into the box, sorts them by cell and renumbers the pairs; the
/// tangential springs of pairs that touch go along.
class NeighbourList {
public:
    /// @param reach surface distance that pairs must be known to, m, >= 0
    /// @param skin  m, > 0: larger means rarer rebuilds of a longer list
    NeighbourList(double reach, double skin) : reach_(reach), skin_(skin) {}

    /// Builds it from the positions. Throws std::invalid_argument when the box is so small that a
    /// particle would meet two images of another.
    /// @param companions further columns with a value per particle, reordered like the particles
    void rebuild(ParticleStore& particles, ShearBox& box, std::span<Column* const> companions = {});

    /// True when a pair within reach may be missing. Call after every move.
    /// @param moved  upper bound of what a particle moved beside the mean shear since the last call
    /// @param strain of the mean shear since the last call, any sign
    [[nodiscard]] bool is_stale_after(const ParticleStore& particles, double moved, double strain);

    AlignedVector<int> first, second; ///< of each pair, first < second
    /// Tangential spring of each pair: displacement of `second` against `first` at the contact, m.
    /// 0 unless they touch.
    Column spring_x, spring_y, spring_z;
    /// Of each particle at the lower and at the upper wall; 0 unless it touches.
    Column lower_x, lower_z, upper_x, upper_z;
    /// Particles that may touch the walls before the next rebuild.
    AlignedVector<int> near_lower, near_upper;

    /// Where the particles were at the last rebuild, m.
    Column built_x, built_y, built_z;

    /// The list's own numbers beside its public columns, for a checkpoint.
    struct State {
        double moved{}, strain{}, largest_distance{};
        long rebuilds{};
    };
    [[nodiscard]] State state() const { return {moved_, strain_, largest_distance_, rebuilds_}; }
    void restore(const State& state) {
        moved_ = state.moved;
        strain_ = state.strain;
        largest_distance_ = state.largest_distance;
        rebuilds_ = state.rebuilds;
    }

    [[nodiscard]] double reach() const { return reach_; }
    [[nodiscard]] long rebuilds() const { return rebuilds_; }
    [[nodiscard]] std::size_t size() const { return first.size(); }

private:
    /// @return the new place of each particle
    [[nodiscard]] AlignedVector<int> sort(ParticleStore& particles, const ShearBox& box,
                                          double cell_size, std::span<Column* const> companions);
    void find_pairs(const ParticleStore& particles, const ShearBox& box);
    void find_wall_neighbours(const ParticleStore& particles, const ShearBox& box);

    struct Spring {
        int first, second; ///< places of the particles
        double x, y, z;
    };
    [[nodiscard]] AlignedVector<Spring> kept_springs() const;
    void restore(AlignedVector<Spring>& springs, const AlignedVector<int>& new_place);
    [[nodiscard]] bool is_used_up() const;
    [[nodiscard]] double way_since_rebuild(const ParticleStore& particles) const;

    double reach_;
    double skin_;
    double moved_ = 0.0;
    double strain_ = 0.0;
    long rebuilds_ = 0;
    double largest_distance_ = 0.0;
    AlignedVector<int> cell_start_;
    int cells_x_ = 1, cells_y_ = 1, cells_z_ = 1;
};

} // namespace searle::solvers::particles
