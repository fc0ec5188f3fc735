#include "solvers/particles/motion.hpp"
#include "solvers/particles/neighbour_list.hpp"
#include "solvers/particles/packing.hpp"
#include "solvers/particles/random_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

namespace searle::solvers::particles {
namespace {

using Pairs = std::set<std::pair<int, int>>;

double surface_distance(const ParticleStore& p, const ShearBox& box, std::size_t i, std::size_t j) {
    double dx = p.x[j] - p.x[i], dy = p.y[j] - p.y[i], dz = p.z[j] - p.z[i];
    NearestImage nearest(box);
    nearest(dx, dy, dz);
    return std::sqrt(dx * dx + dy * dy + dz * dz) - p.radius[i] - p.radius[j];
}

Pairs pairs_within(const ParticleStore& p, const ShearBox& box, double reach) {
    Pairs pairs;
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = i + 1; j < p.size(); ++j)
            if (surface_distance(p, box, i, j) < reach)
                pairs.insert(std::minmax(p.id[i], p.id[j]));
    return pairs;
}

Pairs listed(const ParticleStore& p, const NeighbourList& list) {
    Pairs pairs;
    for (std::size_t k = 0; k < list.size(); ++k)
        EXPECT_TRUE(pairs
                        .insert(std::minmax(p.id[static_cast<std::size_t>(list.first[k])],
                                            p.id[static_cast<std::size_t>(list.second[k])]))
                        .second)
            << "a pair stands in the list twice";
    return pairs;
}

ParticleStore scattered(const ShearBox& box, int count, double radius) {
    ParticleStore p;
    for (int i = 0; i < count; ++i) {
        const auto at = static_cast<std::uint64_t>(3 * i);
        p.add(box.length_x * uniform(7, at), box.length_y * uniform(7, at + 1),
              box.length_z * uniform(7, at + 2), radius * (0.5 + uniform(8, at)), 1.0);
    }
    return p;
}

TEST(NeighbourList, finds_the_pairs_that_a_search_over_all_finds) {
    for (const bool walls : {true, false})
        for (const double offset : {0.0, 0.13, 0.5, 0.77, 0.999}) {
            ShearBox box{.length_x = 1.0, .length_y = 0.8, .length_z = 0.9, .walls = walls};
            if (!walls)
                box.image_offset = offset;
            ParticleStore p = scattered(box, 800, 0.03);
            NeighbourList list(0.02, 0.01);
            list.rebuild(p, box);
            EXPECT_EQ(listed(p, list), pairs_within(p, box, 0.03)) << walls << ' ' << offset;
        }
}

TEST(NeighbourList, misses_no_pair_between_rebuilds_in_shear) {
    ShearBox box{.length_x = 1.0, .length_y = 1.0, .length_z = 1.0, .walls = false};
    box.set_shear_rate(1.0);
    ParticleStore p = scattered(box, 1000, 0.03);
    NeighbourList list(0.01, 0.015);
    list.rebuild(p, box);
    const double step = 2e-3;
    int checked = 0;
    for (int k = 0; k < 500; ++k) {
        double largest = 0.0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto at = static_cast<std::uint64_t>(p.id[i]);
            const double own = 0.2 * step * std::sin(6.0 * uniform(3, at) + 0.01 * k);
            p.x[i] += p.y[i] * step + own;
            p.y[i] += own;
            largest = std::max(largest, std::sqrt(2.0) * std::abs(own));
        }
        box.advance(step);
        if (list.is_stale_after(p, largest, step))
            list.rebuild(p, box);
        const Pairs near = pairs_within(p, box, 0.01);
        const Pairs known = listed(p, list);
        for (const auto& pair : near)
            EXPECT_TRUE(known.contains(pair)) << k;
        checked += static_cast<int>(near.size());
    }
    EXPECT_GT(checked, 100000);
    // A fast box does not make it stale: far fewer rebuilds than steps.
    EXPECT_LT(list.rebuilds(), 100);
}

TEST(NeighbourList, keeps_the_springs_of_touching_pairs_over_a_rebuild) {
    ShearBox box{.length_x = 1.0, .length_y = 1.0, .length_z = 1.0, .walls = false};
    ParticleStore p = scattered(box, 1000, 0.04);
    NeighbourList list(0.0, 0.02);
    list.rebuild(p, box);
    // A spring that only its two ids decide, with the sign of their order.
    const auto spring_of = [&](std::size_t k) {
        const int a = p.id[static_cast<std::size_t>(list.first[k])];
        const int b = p.id[static_cast<std::size_t>(list.second[k])];
        const double size = 1000.0 * std::min(a, b) + std::max(a, b) + 1.0;
        return a < b ? size : -size;
    };
    for (std::size_t k = 0; k < list.size(); ++k)
        list.spring_y[k] = spring_of(k);
    const std::size_t before = list.size();
    for (std::size_t i = 0; i < p.size(); ++i)
        p.x[i] += 0.37; // other cells, other order, the same pairs
    list.rebuild(p, box);
    ASSERT_EQ(list.size(), before);
    for (std::size_t k = 0; k < list.size(); ++k)
        EXPECT_EQ(list.spring_y[k], spring_of(k));
}

TEST(NeighbourList, refuses_a_box_in_which_a_particle_would_meet_two_images) {
    ShearBox box{.length_x = 0.1, .length_y = 1.0, .length_z = 1.0};
    ParticleStore p = scattered(box, 5, 0.03);
    NeighbourList list(0.01, 0.01);
    EXPECT_THROW(list.rebuild(p, box), std::invalid_argument);
}

double largest_overlap(const ParticleStore& p, const ShearBox& box) {
    double worst = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (box.walls)
            worst = std::max({worst, p.radius[i] - p.y[i], p.y[i] + p.radius[i] - box.length_y});
        for (std::size_t j = i + 1; j < p.size(); ++j)
            worst = std::max(worst, -surface_distance(p, box, i, j));
    }
    return worst;
}

TEST(Packing, has_no_overlap_up_to_sixty_percent) {
    for (const bool walls : {false, true})
        for (const double fraction : {0.05, 0.3, 0.5, 0.6}) {
            if (walls && fraction > 0.55)
                continue; // walls cost density; what is reached is tested below
            const ShearBox box{
                .length_x = 12e-6, .length_y = 12e-6, .length_z = 12e-6, .walls = walls};
            const PackingRequest request{.sizes = {{1.0e-6, 1.0}},
                                         .volume_fraction = fraction,
                                         .density = 1000.0,
                                         .seed = 5};
            const ParticleStore p = random_packing(request, box);
            EXPECT_LT(largest_overlap(p, box), 1e-6 * 1e-6) << fraction;
            EXPECT_NEAR(p.total_volume() / box.volume() / fraction, 1.0, 0.01);
        }
}

TEST(Packing, keeps_the_shares_of_a_mixture) {
    const ShearBox box{.length_x = 30e-6, .length_y = 30e-6, .length_z = 30e-6, .walls = false};
    const PackingRequest request{.sizes = {{1.0e-6, 0.5}, {1.4e-6, 0.5}},
                                 .volume_fraction = 0.4,
                                 .density = 1000.0,
                                 .seed = 1};
    const ParticleStore p = random_packing(request, box);
    double small = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i)
        small += p.radius[i] < 0.6e-6 ? p.volume(i) : 0.0;
    EXPECT_NEAR(small / p.total_volume(), 0.5, 1e-3);
    EXPECT_NEAR(p.total_volume() / box.volume(), 0.4, 1e-3);
}

TEST(Packing, spreads_the_sizes_lognormally) {
    const ShearBox box{.length_x = 100e-6, .length_y = 100e-6, .length_z = 100e-6, .walls = false};
    const PackingRequest request{.sizes = {{1.0e-6, 1.0}},
                                 .spread = 0.3,
                                 .volume_fraction = 0.05,
                                 .density = 1.0,
                                 .seed = 2};
    const std::vector<double> radii = radii_for(request, box);
    double mean = 0.0;
    double square = 0.0;
    for (const double r : radii) {
        mean += std::log(2e6 * r);
        square += std::log(2e6 * r) * std::log(2e6 * r);
    }
    const auto count = static_cast<double>(radii.size());
    ASSERT_GT(count, 10000);
    // Mean 0 and deviation 0.3 within four standard errors.
    EXPECT_NEAR(mean / count, 0.0, 4 * 0.3 / std::sqrt(count));
    EXPECT_NEAR(std::sqrt(square / count), 0.3, 4 * 0.3 / std::sqrt(2 * count));
}

TEST(Packing, is_the_same_for_the_same_seed) {
    const ShearBox box{.length_x = 8e-6, .length_y = 8e-6, .length_z = 8e-6};
    PackingRequest request{
        .sizes = {{1.0e-6, 1.0}}, .volume_fraction = 0.45, .density = 1.0, .seed = 3};
    const ParticleStore one = random_packing(request, box);
    const ParticleStore two = random_packing(request, box);
    EXPECT_EQ(one.x, two.x);
    EXPECT_EQ(one.y, two.y);
    request.seed = 4;
    EXPECT_NE(one.x, random_packing(request, box).x);
}

TEST(Packing, says_what_it_reached_when_it_cannot) {
    const ShearBox box{.length_x = 8e-6, .length_y = 8e-6, .length_z = 8e-6};
    const PackingRequest request{
        .sizes = {{1.0e-6, 1.0}}, .volume_fraction = 0.7, .density = 1.0, .seed = 3};
    try {
        const ParticleStore p = random_packing(request, box);
        FAIL() << "spheres cannot be packed at random to 0.7";
    } catch (const PackingError& error) {
        EXPECT_GT(error.reached_fraction, 0.45);
        EXPECT_LT(error.reached_fraction, 0.7);
    }
}

} // namespace
} // namespace searle::solvers::particles
