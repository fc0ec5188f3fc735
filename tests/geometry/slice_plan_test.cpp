#include "geometry/slice_plan.hpp"

#include "geometry/mesh_build.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace searle::geometry {
namespace {

double twice_triangle(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }

/// Area of a plane cell, m^2: positive where it turns anticlockwise.
double area_of(const Mesh& mesh, std::size_t cell) {
    const auto corners = mesh.cells.corners(cell);
    double twice = 0.0;
    for (std::size_t at = 0; at < corners.size(); ++at)
        twice += twice_triangle(mesh.points[corners[at]],
                                mesh.points[corners[(at + 1) % corners.size()]]);
    return 0.5 * twice;
}

/// Of a regular polygon inside a circle, m^2.
double polygon_area(double radius, int sides) {
    return 0.5 * sides * radius * radius * std::sin(2.0 * std::numbers::pi / sides);
}

BuiltMesh slice_of(double offset, int order) {
    MeshSettings settings;
    settings.extent = MeshExtent::full;
    settings.angular_cells = 120;
    settings.cells_across_gap = 6;
    settings.slice_height = 1e-3;
    settings.order = order;
    const ConcentricCylinders gap{
        .bob_radius = 14e-3, .cup_radius = 15e-3, .height = 42e-3, .offset = offset};
    return build_mesh(subject_of(Instrument{gap}), settings);
}

// Without an offset the ring between two regular polygons, by elementary geometry.
TEST(SlicePlan, cells_fill_the_ring_between_both_polygons) {
    for (const int order : {1, 2}) {
        const Mesh plan = slice_plan(slice_of(0.0, order).mesh);
        ASSERT_EQ(plan.cells.size(), 720U);
        double area = 0.0;
        for (std::size_t cell = 0; cell < plan.cells.size(); ++cell) {
            EXPECT_GT(area_of(plan, cell), 0.0);
            area += area_of(plan, cell);
        }
        EXPECT_NEAR(area / (polygon_area(15e-3, 120) - polygon_area(14e-3, 120)), 1.0, 1e-10);
    }
}

TEST(SlicePlan, walls_of_an_eccentric_bob_are_closed_lines_on_their_circles) {
    const Mesh plan = slice_plan(slice_of(0.5e-3, 1).mesh);
    ASSERT_EQ(plan.patches.size(), 2U);
    for (const Patch& wall : plan.patches) {
        const bool is_bob = wall.name == "bob";
        ASSERT_TRUE(is_bob || wall.name == "cup") << wall.name;
        EXPECT_EQ(wall.count, 120U);
        double length = 0.0;
        for (std::size_t face = wall.first; face < wall.first + wall.count; ++face) {
            const Point& from = plan.points[plan.faces.nodes(face)[0]];
            const Point& to = plan.points[plan.faces.nodes(face)[1]];
            EXPECT_NEAR(std::hypot(from.x + (is_bob ? 0.0 : 0.5e-3), from.y),
                        is_bob ? 14e-3 : 15e-3, 1e-12);
            length += std::hypot(to.x - from.x, to.y - from.y);
        }
        EXPECT_NEAR(length / (2.0 * std::numbers::pi * (is_bob ? 14e-3 : 15e-3)), 1.0, 1e-3);
    }
}

TEST(SlicePlan, of_a_section_there_is_none) {
    MeshSettings settings;
    settings.extent = MeshExtent::section;
    const ConcentricCylinders gap{.bob_radius = 14e-3, .cup_radius = 15e-3, .height = 42e-3};
    EXPECT_EQ(slice_plan(build_mesh(subject_of(Instrument{gap}), settings).mesh).cells.size(), 0U);
}

} // namespace
} // namespace searle::geometry
