#include "geometry/eccentric_annulus.hpp"
#include "geometry/mesh_error.hpp"
#include "geometry/mesh_quality.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace searle::geometry {
namespace {

constexpr double pi = std::numbers::pi;

Point polar(double radius, double angle) {
    return {radius * std::cos(angle), radius * std::sin(angle), 0.0};
}

// What a map must do, not how: walls on walls, and right angles kept.
TEST(EccentricAnnulus, walls_come_to_lie_on_both_circles_and_right_angles_stay) {
    for (const double ratio : {1.001, 1.0714, 2.0, 10.0})
        for (const double part : {1e-9, 0.1, 0.5, 0.9, 0.999}) {
            const double offset = part * (ratio - 1.0);
            const EccentricAnnulus annulus(1.0, ratio, offset);
            for (double angle = 0.1; angle < 2.0 * pi; angle += 0.7) {
                const Point bob = annulus.placed(polar(1.0, angle));
                const Point cup = annulus.placed(polar(ratio, angle));
                EXPECT_NEAR(std::hypot(bob.x, bob.y), 1.0, 1e-13);
                EXPECT_NEAR(std::hypot(cup.x + offset, cup.y), ratio, 1e-9 * ratio);
                // Directions along and across, by central differences.
                const double middle = std::sqrt(ratio);
                const double d = 1e-3 * (ratio - 1.0) * (1.0 - part);
                const Point out = annulus.placed(polar(middle + d, angle));
                const Point in = annulus.placed(polar(middle - d, angle));
                const Point on = annulus.placed(polar(middle, angle + d));
                const Point back = annulus.placed(polar(middle, angle - d));
                const double across[] = {out.x - in.x, out.y - in.y};
                const double along[] = {on.x - back.x, on.y - back.y};
                const double cosine =
                    (across[0] * along[0] + across[1] * along[1]) /
                    (std::hypot(across[0], across[1]) * std::hypot(along[0], along[1]));
                EXPECT_NEAR(cosine, 0.0, 1e-4) << ratio << ' ' << part << ' ' << angle;
            }
            const Point narrow = annulus.placed(polar(ratio, 0.0));
            EXPECT_NEAR(narrow.x - 1.0, ratio - 1.0 - offset, 1e-9 * ratio);
        }
}

TEST(EccentricAnnulus, without_offset_every_point_stays) {
    const EccentricAnnulus annulus(14.0, 15.0, 0.0);
    EXPECT_DOUBLE_EQ(annulus.largest_stretch(), 1.0);
    for (const double radius : {14.0, 14.3, 15.0}) {
        const Point at = annulus.placed(polar(radius, 1.0));
        EXPECT_NEAR(at.x, radius * std::cos(1.0), 1e-12);
        EXPECT_NEAR(at.y, radius * std::sin(1.0), 1e-12);
    }
}

TEST(EccentricAnnulus, largest_stretch_is_that_of_the_wide_side_of_the_cup) {
    const EccentricAnnulus annulus(1.0, 2.0, 0.6);
    const double d = 1e-4;
    const Point on = annulus.placed(polar(2.0, pi + d));
    const double angle = std::atan2(-on.y, -(on.x + 0.6)); // about the cup's centre
    EXPECT_NEAR(angle / d, annulus.largest_stretch(), 1e-4);
}

TEST(EccentricMesh, is_closed_orthogonal_and_fills_the_gap_between_its_polygons) {
    for (const double part : {0.05, 0.5, 0.9, 0.98}) {
        const ConcentricCylinders gap{
            .bob_radius = 14e-3, .cup_radius = 16e-3, .height = 42e-3, .offset = part * 2e-3};
        for (const auto style : {CellStyle::hexahedra, CellStyle::prisms}) {
            if (style == CellStyle::prisms && part > 0.5)
                continue; // triangles of the section are pressed flat where the gap is narrow
            try {
                const BuiltMesh built =
                    build_mesh(gap, {.cells_across_gap = 6, .cells = style, .axial_cells = 1});
                const MeshQuality quality = quality_of(built);
                EXPECT_TRUE(quality.faults.empty()) << part << quality.faults.front();
                EXPECT_LT(std::abs(quality.volume.error()), 1e-12) << part;
                // Straight chords in place of arcs of at most 6 deg leave a few degrees.
                if (style == CellStyle::hexahedra) {
                    EXPECT_LT(quality.largest_non_orthogonality, 5.0) << part;
                }
            } catch (const MeshToolMissing& missing) {
                GTEST_SKIP() << missing.what();
            }
        }
    }
}

TEST(EccentricMesh, torque_on_the_whole_turn_is_the_instruments) {
    const ConcentricCylinders gap{
        .bob_radius = 14e-3, .cup_radius = 15e-3, .height = 42e-3, .offset = 0.5e-3};
    const BuiltMesh built = build_mesh(gap, {.slice_height = 1e-3, .axial_cells = 1});
    EXPECT_DOUBLE_EQ(built.domain.slice.factor(), 42.0);
    EXPECT_EQ(built.choices.extent, MeshExtent::full);
}

TEST(EccentricMesh, what_stands_for_one_direction_alone_is_refused_with_the_reason) {
    const ConcentricCylinders gap{
        .bob_radius = 14e-3, .cup_radius = 15e-3, .height = 42e-3, .offset = 0.5e-3};
    const std::pair<MeshSettings, const char*> requests[] = {
        {{.wedge_angle = 0.1}, "mesh.wedge_angle"},
        {{.extent = MeshExtent::sector}, "mesh.extent"},
        {{.extent = MeshExtent::section}, "mesh.extent"},
        {{.order = 2}, "mesh.order"},
        {{.cells = CellStyle::tetrahedra}, "mesh.cells"},
        {{.vertices = VertexRadius::face}, "mesh.vertices"}};
    for (const auto& [settings, key] : requests)
        try {
            (void)build_mesh(gap, settings);
            ADD_FAILURE() << key;
        } catch (const MeshError& error) {
            EXPECT_NE(std::string(error.what()).find(key), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find("geometry.offset"), std::string::npos);
        }
}

} // namespace
} // namespace searle::geometry
