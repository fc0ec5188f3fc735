#include "solvers/suspension/microstructure.hpp"

#include "solvers/particles/random_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace searle::solvers::suspension {
namespace {

using particles::ParticleStore;
using particles::ShearBox;

/// Points at random: no structure at all. Their centres keep a radius from the walls.
ParticleStore points_at_random(const ShearBox& box, int count, double radius, std::uint64_t key) {
    ParticleStore store;
    const double margin = box.walls ? radius : 0.0;
    for (int i = 0; i < count; ++i) {
        const auto at = static_cast<std::uint64_t>(3 * i);
        store.add(box.length_x * particles::uniform(key, at),
                  margin + (box.length_y - 2.0 * margin) * particles::uniform(key, at + 1),
                  box.length_z * particles::uniform(key, at + 2), radius, 1.0);
    }
    return store;
}

TEST(Microstructure, particles_without_structure_have_a_pair_distribution_of_one) {
    for (const bool walls : {false, true}) {
        ShearBox box{.length_x = 12.0, .length_y = 5.0, .length_z = 11.0, .walls = walls};
        box.set_shear_rate(1.0);
        box.image_offset = walls ? 0.0 : 3.7;
        Microstructure structure;
        for (std::uint64_t key = 1; key <= 4; ++key)
            structure.add(points_at_random(box, 3000, 0.4, key), box, {});
        const auto bins = structure.pair_distribution();
        ASSERT_GT(bins.size(), 100U);
        double all = 0.0, pressed = 0.0, pulled = 0.0, weights = 0.0;
        for (const auto& bin : bins) {
            // Four snapshots of 3000 points: a bin at 0.4 diameters holds some 400 pairs.
            if (bin.distance > 0.4) {
                EXPECT_NEAR(bin.all, 1.0, 0.25) << bin.distance << walls;
            }
            const double weight = bin.distance * bin.distance;
            all += weight * bin.all;
            pressed += weight * bin.pressed;
            pulled += weight * bin.pulled;
            weights += weight;
        }
        // Millions of pairs: what is left is the scatter of the density itself.
        EXPECT_NEAR(all / weights, 1.0, 0.01) << walls;
        EXPECT_NEAR(pressed / weights, 1.0, 0.02) << walls;
        EXPECT_NEAR(pulled / weights, 1.0, 0.02) << walls;
    }
}

TEST(Microstructure, a_cubic_lattice_of_touching_spheres_has_six_neighbours) {
    // Radius 0.5, spaced by 0.999: each has 6 partners at 0.999, 12 at 0.999 sqrt 2.
    const double spacing = 0.999;
    const ShearBox box{
        .length_x = 8 * spacing, .length_y = 8 * spacing, .length_z = 8 * spacing, .walls = false};
    ParticleStore store;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
            for (int k = 0; k < 8; ++k)
                store.add(spacing * i, spacing * j, spacing * k, 0.5, 1.0);
    Microstructure structure;
    structure.add(store, box, {});
    EXPECT_DOUBLE_EQ(structure.contact_number(), 6.0);
    EXPECT_DOUBLE_EQ(structure.contact_shares()[6], 1.0);
    for (const auto& bin : structure.pair_distribution()) {
        // Pairs of one particle in a bin of even ones: 4 pi r^2 dr density.
        const double even = 4.0 * std::numbers::pi * bin.distance * bin.distance *
                            Microstructure::bin_width / std::pow(spacing, 3);
        const double pairs = bin.all * even;
        const auto holds = [&](double distance) {
            return std::abs(bin.distance - distance) <= 0.5 * Microstructure::bin_width;
        };
        const double expected = holds(spacing) ? 6.0 : holds(std::sqrt(2.0) * spacing) ? 12.0 : 0.0;
        if (bin.distance < 1.6) { // the next are at sqrt 3
            EXPECT_NEAR(pairs, expected, 1e-9) << bin.distance;
        }
    }
}

TEST(Microstructure, tells_pairs_that_the_shear_presses_from_those_it_pulls) {
    ShearBox box{.length_x = 10.0, .length_y = 10.0, .length_z = 10.0};
    box.set_shear_rate(2.0);
    ParticleStore store;
    store.add(5.0, 5.0, 5.0, 0.5, 1.0);
    store.add(5.8, 4.2, 5.0, 0.5, 1.0); // ahead and below: the upper one runs into it
    Microstructure pressed;
    pressed.add(store, box, {});
    store.y[1] = 5.8;
    Microstructure pulled;
    pulled.add(store, box, {});
    double sums[4] = {};
    for (const auto& bin : pressed.pair_distribution()) {
        sums[0] += bin.pressed;
        sums[1] += bin.pulled;
    }
    for (const auto& bin : pulled.pair_distribution()) {
        sums[2] += bin.pressed;
        sums[3] += bin.pulled;
    }
    EXPECT_GT(sums[0], 0.0);
    EXPECT_EQ(sums[1], 0.0);
    EXPECT_EQ(sums[2], 0.0);
    EXPECT_GT(sums[3], 0.0);
}

TEST(Microstructure, slices_hold_the_whole_volume_and_the_shear) {
    for (const bool walls : {false, true}) {
        ShearBox box{.length_x = 9.0, .length_y = 8.0, .length_z = 7.0, .walls = walls};
        box.set_shear_rate(3.0);
        ParticleStore store = points_at_random(box, 200, 0.3, 5);
        for (std::size_t i = 0; i < store.size(); ++i)
            store.vx[i] = 3.0 * store.y[i];
        const std::vector<double> fluid{0.0, 12.0, 24.0};
        Microstructure structure;
        structure.add(store, box, fluid);
        double sum = 0.0;
        for (const auto& slice : structure.profile()) {
            sum += slice.volume_fraction / Microstructure::slices;
            EXPECT_NEAR(slice.fluid_velocity, 24.0 * slice.height, 1e-12);
            // A sphere counts with the velocity of its centre, at most a radius away.
            if (slice.volume_fraction > 0.0) {
                EXPECT_NEAR(slice.particle_velocity, 24.0 * slice.height, 3.0 * (0.3 + 0.125));
            }
        }
        EXPECT_NEAR(sum, store.total_volume() / box.volume(), 1e-12) << walls;
    }
}

/// Radius 0.5 in cubes of 0.999^3 ... and in a lattice stretched to 1.25: pi / 6 over the volume.
TEST(Microstructure, local_fractions_of_lattices) {
    for (const double height : {0.999, 1.25}) {
        const ShearBox box{
            .length_x = 5 * 0.999, .length_y = 5 * height, .length_z = 5 * 0.999, .walls = false};
        ParticleStore store;
        for (int i = 0; i < 5; ++i)
            for (int j = 0; j < 5; ++j)
                for (int k = 0; k < 5; ++k)
                    store.add(0.999 * i, height * j, 0.999 * k, 0.5, 1.0);
        Microstructure structure;
        for (int snapshot = 0; snapshot < 12; ++snapshot)
            structure.add(store, box, {});
        const double fraction = std::numbers::pi / 6.0 / (0.999 * height * 0.999);
        EXPECT_DOUBLE_EQ(
            structure.local_fraction_shares()[static_cast<std::size_t>(100.0 * fraction)], 1.0);
    }
}

TEST(Microstructure, comes_back_from_its_numbers) {
    const ShearBox box{.length_x = 9.0, .length_y = 8.0, .length_z = 7.0};
    Microstructure structure;
    structure.add(points_at_random(box, 100, 0.3, 5), box, std::vector<double>{0.0, 1.0});
    const std::vector<double> numbers = structure.numbers();
    EXPECT_EQ(Microstructure::from(numbers).numbers(), numbers);
}

} // namespace
} // namespace searle::solvers::suspension
