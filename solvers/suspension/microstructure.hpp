#pragma once

#include "solvers/particles/particle_store.hpp"
#include "solvers/particles/shear_box.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace searle::solvers::suspension {

/// Sums over snapshots of a suspension: how the particles stand to one another and in the gap.
///
/// Pair distribution: pairs by the distance of their centres over the number-mean diameter, against
/// what as many particles placed evenly would have; between walls "evenly" is over the heights that
/// a mean sphere's centre can reach, so that walls do not show as a lack of neighbours. Apart for
/// pairs that the shear presses together and pulls apart (dx dy < 0 and > 0 at a positive rate).
///
/// Local volume fraction: each sphere's volume over that of its cell (local_volumes.hpp), in every
/// tenth snapshot: cells change slowly and cost more than all else here.
///
/// Profiles: slices of equal height across the box; each sphere counts with the exact volume that
/// it has in a slice.
class Microstructure {
public:
    static constexpr std::size_t slices = 32;
    static constexpr std::size_t most_contacts = 12; ///< more count as so many
    static constexpr std::size_t fractions = 100;    ///< bins from 0 to 1
    static constexpr double bin_width = 0.02;        ///< over the mean diameter
    static constexpr double furthest = 3.0;          ///< over the mean diameter

    /// @param fluid_velocity at equal distances from wall to wall, m/s; empty: not known
    void add(const particles::ParticleStore& particles, const particles::ShearBox& box,
             std::span<const double> fluid_velocity);

    [[nodiscard]] double snapshots() const { return snapshots_; }

    struct PairBin {
        double distance{}; ///< middle of the bin over the mean diameter
        double all{};      ///< 1: as many as evenly placed
        double pressed{};  ///< of the quadrants that the shear presses together
        double pulled{};   ///< of those that it pulls apart
    };
    /// Up to the largest distance at which the periodic box shows every pair once.
    [[nodiscard]] std::vector<PairBin> pair_distribution() const;

    struct Slice {
        double height{}; ///< middle over the gap
        double volume_fraction{};
        double particle_velocity{}; ///< along the flow, by volume, m/s; NaN without particles
        double fluid_velocity{};    ///< m/s; NaN where it is not known
    };
    [[nodiscard]] std::vector<Slice> profile() const;

    /// Share of the particles with 0, 1, ... touching partners, walls included.
    [[nodiscard]] std::array<double, most_contacts + 1> contact_shares() const;
    [[nodiscard]] double contact_number() const;

    /// Share of the particles by their local volume fraction, in equal bins from 0 to 1. Spheres
    /// that reach out of their cells count as filling them.
    [[nodiscard]] std::array<double, fractions> local_fraction_shares() const;

    /// All sums, for a checkpoint.
    [[nodiscard]] std::vector<double> numbers() const;
    [[nodiscard]] static Microstructure from(std::span<const double> numbers);

private:
    static constexpr std::size_t bins = 150;
    using Histogram = std::array<double, bins>;
    void count_pairs(particles::ParticleStore particles, particles::ShearBox box);
    void add_slices(const particles::ParticleStore& particles, const particles::ShearBox& box);
    void add_local_fractions(const particles::ParticleStore& particles,
                             const particles::ShearBox& box);

    template <class Self, class Visit>
    static void visit(Self& self, Visit visit);

    double snapshots_{};
    double particles_{};
    double reach_{}; ///< distance up to which every pair is known, over the mean diameter
    Histogram pressed_{}, pulled_{}, even_{};
    std::array<double, most_contacts + 1> contacts_{};
    std::array<double, fractions> local_{};
    std::array<double, slices> volume_{}, flux_{}, fluid_{}; ///< shares of the slice; m/s
};

} // namespace searle::solvers::suspension
