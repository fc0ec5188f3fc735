#include "geometry/power_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace searle::geometry {
namespace {

/// The sphere at the origin first, then a lattice's others up to three spacings around it.
template <class IsSite, class Radius>
std::vector<Sphere> lattice(double spacing, IsSite is_site, Radius radius) {
    std::vector<Sphere> spheres{{0.0, 0.0, 0.0, radius(0)}};
    for (int i = -3; i <= 3; ++i)
        for (int j = -3; j <= 3; ++j)
            for (int k = -3; k <= 3; ++k)
                if ((i != 0 || j != 0 || k != 0) && is_site(i, j, k))
                    spheres.push_back({spacing * i, spacing * j, spacing * k, radius(k)});
    return spheres;
}

/// Every corner of these cells belongs to more than four spheres. By hand: a cube of the spacing;
/// a rhombic dodecahedron of two of its cubes, a truncated octahedron of four (sites of half the
/// lattice, of a quarter).
TEST(PowerCells, of_cubic_lattices) {
    const auto equal = [](int) { return 0.3; };
    const auto simple = [](int, int, int) { return true; };
    const auto face_centred = [](int i, int j, int k) { return (i + j + k) % 2 == 0; };
    const auto body_centred = [](int i, int j, int k) {
        return (i - j) % 2 == 0 && (j - k) % 2 == 0;
    };
    EXPECT_NEAR(power_cells(lattice(0.7, simple, equal), 1).volume[0], std::pow(0.7, 3), 1e-14);
    EXPECT_NEAR(power_cells(lattice(0.7, face_centred, equal), 1).volume[0], 2.0 * std::pow(0.7, 3),
                1e-14);
    EXPECT_NEAR(power_cells(lattice(0.7, body_centred, equal), 1).volume[0], 4.0 * std::pow(0.7, 3),
                1e-14);
}

/// Layers of two radii, a and b: the face between them lies (1 + a^2 - b^2) / 2 from a's centre.
TEST(PowerCells, of_layers_of_two_radii) {
    const auto all = [](int, int, int) { return true; };
    const auto layered = [](int k) { return k % 2 == 0 ? 0.5 : 0.3; };
    const PowerCells cells = power_cells(lattice(1.0, all, layered), 1);
    EXPECT_NEAR(cells.volume[0], 1.0 + 0.25 - 0.09, 1e-14);
    // The furthest corner is sqrt(0.5 + 0.58^2) away and 0.766 of power from it.
    EXPECT_NEAR(cells.reach, std::sqrt(0.5 + 0.3364) * 2.0, 1e-12);
}

TEST(PowerCells, open_and_covered_ones_are_told) {
    const std::vector<Sphere> few{{0, 0, 0, 1}, {3, 0, 0, 1}, {0, 3, 0, 1}};
    EXPECT_TRUE(std::isinf(power_cells(few, 3).volume[1]));
    std::vector<Sphere> many = lattice(
        1.0, [](int, int, int) { return true; }, [](int) { return 0.5; });
    many.insert(many.begin(), {0.1, 0.0, 0.0, 0.01});
    EXPECT_EQ(power_cells(many, 1).volume[0], 0.0);
}

} // namespace
} // namespace searle::geometry
