#include "solvers/particles/local_volumes.hpp"

#include "solvers/particles/random_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace searle::solvers::particles {
namespace {

constexpr double tallest = 4.0;

/// Two sizes on a jittered grid, none touching: 64 spheres, or 8 in the same box.
ParticleStore jittered(const ShearBox& box, int across) {
    ParticleStore store;
    std::uint64_t draw = 0;
    const double spacing = tallest / across;
    for (int i = 0; i < across; ++i)
        for (int j = 0; j < across; ++j)
            for (int k = 0; k < across; ++k) {
                const auto at = [&](int n) {
                    return spacing * (n + 0.3 + 0.4 * uniform(9, draw++));
                };
                // Out of the box by a period, as between two sortings of the particles.
                const double x = at(i) + (i == 0 ? box.length_x : 0.0);
                const bool above = !box.walls && j == 1;
                store.add(x + (above ? box.image_offset : 0.0),
                          at(j) + (above ? box.length_y : 0.0), at(k),
                          spacing * (draw % 2 == 0 ? 0.3 : 0.15), 1.0);
            }
    return store;
}

/// Power distance to the nearest image of any kind, by trying them.
double power_distance(const ParticleStore& store, const ShearBox& box, std::size_t i, double x,
                      double y, double z) {
    double least = std::numeric_limits<double>::infinity();
    const int layers = box.walls ? 1 : 2;
    for (int j = -layers; j <= layers; ++j) {
        const double at_y = box.walls ? (j == 0 ? store.y[i] : (j + 1) * box.length_y - store.y[i])
                                      : store.y[i] + j * box.length_y;
        const double shift = box.walls ? 0.0 : j * box.image_offset;
        const double dx = std::remainder(x - store.x[i] - shift, box.length_x);
        const double dz = std::remainder(z - store.z[i], box.length_z);
        const double squared = dx * dx + (y - at_y) * (y - at_y) + dz * dz;
        least = std::min(least, squared - store.radius[i] * store.radius[i]);
    }
    return least;
}

/// Independent: which particle is nearest, at a grid of points. A cell of n points is wrong by some
/// sqrt of those that its surface cuts, n^(2/3) times six.
TEST(LocalVolumes, are_those_of_the_points_that_are_nearest) {
    for (const bool walls : {false, true})
        for (const int across : {2, 4}) {
            ShearBox box{.length_x = tallest, .length_y = tallest, .length_z = tallest};
            box.walls = walls;
            box.image_offset = walls ? 0.0 : 1.3;
            const ParticleStore store = jittered(box, across);
            const std::vector<double> volumes = local_volumes(store, box);
            ASSERT_EQ(volumes.size(), store.size());
            EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), box.volume(), 1e-11);
            constexpr int points = 48;
            std::vector<double> counted(store.size(), 0.0);
            const double side = tallest / points;
            for (int a = 0; a < points; ++a)
                for (int b = 0; b < points; ++b)
                    for (int c = 0; c < points; ++c) {
                        std::size_t nearest = 0;
                        double least = std::numeric_limits<double>::infinity();
                        for (std::size_t i = 0; i < store.size(); ++i) {
                            const double d = power_distance(store, box, i, side * (a + 0.5),
                                                            side * (b + 0.5), side * (c + 0.5));
                            if (d < least) {
                                least = d;
                                nearest = i;
                            }
                        }
                        counted[nearest] += 1.0;
                    }
            for (std::size_t i = 0; i < store.size(); ++i) {
                const double cut = 6.0 * std::pow(counted[i], 2.0 / 3.0);
                EXPECT_NEAR(volumes[i] / std::pow(side, 3), counted[i], 2.0 * std::sqrt(cut))
                    << walls << across << ' ' << i;
            }
        }
}

/// A single sphere has the whole box, however it is sheared.
TEST(LocalVolumes, one_particle_fills_the_box) {
    for (const bool walls : {false, true}) {
        ShearBox box{.length_x = 2.0, .length_y = 1.0, .length_z = 3.0};
        box.walls = walls;
        box.image_offset = walls ? 0.0 : 0.77;
        ParticleStore store;
        store.add(0.4, 0.6, 2.9, 0.1, 1.0);
        EXPECT_NEAR(local_volumes(store, box).at(0), 6.0, 1e-13);
    }
}

} // namespace
} // namespace searle::solvers::particles
