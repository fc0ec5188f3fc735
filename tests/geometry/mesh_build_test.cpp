#include "geometry/mesh_error.hpp"
#include "geometry/mesh_quality.hpp"
#include "mesh_subjects.hpp"
#include "random_meshes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace searle::geometry {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
using namespace testing;

bool is_profile(const MeshSubject& subject) { return std::holds_alternative<Profile>(subject); }

TEST(MeshBuild, every_kind_extent_style_and_order_is_closed_oriented_and_fills_its_outline) {
    for (const auto& [name, subject] : laboratory_subjects())
        for (const auto extent :
             {MeshExtent::section, MeshExtent::wedge, MeshExtent::sector, MeshExtent::full})
            for (const auto style :
                 {CellStyle::hexahedra, CellStyle::prisms, CellStyle::tetrahedra})
                for (const int order : {1, 2}) {
                    if (is_profile(subject) && style == CellStyle::hexahedra)
                        continue;
                    if (style == CellStyle::tetrahedra && extent != MeshExtent::section)
                        continue; // below: they are no sweep of the section
                    MeshSettings settings{
                        .cells_across_gap = 3, .order = order, .extent = extent, .cells = style};
                    if (extent == MeshExtent::full)
                        settings.angular_cells = 24;
                    try {
                        const MeshQuality quality = quality_of(build_mesh(subject, settings));
                        EXPECT_TRUE(quality.faults.empty())
                            << name << ' ' << static_cast<int>(extent) << ' '
                            << static_cast<int>(style) << " order " << order << ": "
                            << (quality.faults.empty() ? "" : quality.faults[0]);
                    } catch (const MeshToolMissing& missing) {
                        GTEST_SKIP() << missing.what();
                    }
                }
}

TEST(MeshBuild, tetrahedra_fill_every_solid_and_are_not_flat) {
    for (const auto& [name, subject] : laboratory_subjects())
        for (const auto extent : {MeshExtent::wedge, MeshExtent::sector, MeshExtent::full})
            for (const int order : {1, 2}) {
                // Around the axis tetrahedra of the double gap's thin gaps go into the millions.
                const bool is_double = std::holds_alternative<DoubleGap>(subject);
                if (extent != MeshExtent::wedge && (is_double || order == 2))
                    continue;
                try {
                    const BuiltMesh built = build_mesh(subject, {.cells_across_gap = 1,
                                                                 .order = order,
                                                                 .extent = extent,
                                                                 .cells = CellStyle::tetrahedra});
                    const MeshQuality quality = quality_of(built);
                    EXPECT_TRUE(quality.faults.empty())
                        << name << ' ' << static_cast<int>(extent) << " order " << order << ": "
                        << (quality.faults.empty() ? "" : quality.faults[0]);
                    // checkMesh warns from 70 deg on; a wedge of 5 deg is thinner at the axis than
                    // any cell.
                    if (extent != MeshExtent::wedge) {
                        EXPECT_LE(quality.largest_non_orthogonality, 75.0) << name;
                    }
                    EXPECT_NEAR(quality.volume.value / quality.volume.exact, 1.0, 5e-3) << name;
                    if (extent != MeshExtent::full) {
                        EXPECT_EQ(built.mesh.patch("periodic_front")->count,
                                  built.mesh.patch("periodic_back")->count);
                    }
                } catch (const MeshToolMissing& missing) {
                    GTEST_SKIP() << missing.what();
                }
            }
}

TEST(MeshBuild, both_ends_of_tetrahedra_are_the_same_triangles_turned) {
    try {
        const BuiltMesh built = build_mesh(DinBob{.bob_radius = 14e-3, .cup_radius = 15.2e-3},
                                           {.cells_across_gap = 1,
                                            .order = 2,
                                            .extent = MeshExtent::sector,
                                            .cells = CellStyle::tetrahedra});
        const Mesh& mesh = built.mesh;
        const double c = std::cos(mesh.periodic_map.angle);
        const double s = std::sin(mesh.periodic_map.angle);
        for (const auto& [front, back] : mesh.periodic_points) {
            const Point& from = mesh.points[front];
            const Point& to = mesh.points[back];
            EXPECT_NEAR(c * from.x - s * from.y, to.x, 1e-15);
            EXPECT_NEAR(s * from.x + c * from.y, to.y, 1e-15);
            EXPECT_EQ(from.z, to.z);
        }
        // Every corner and middle of the front has its partner.
        const Patch& front = *mesh.patch("periodic_front");
        std::set<std::uint32_t> nodes;
        for (std::size_t face = front.first; face < front.first + front.count; ++face)
            nodes.insert(mesh.faces.nodes(face).begin(), mesh.faces.nodes(face).end());
        EXPECT_EQ(nodes.size(), mesh.periodic_points.size());
    } catch (const MeshToolMissing& missing) {
        GTEST_SKIP() << missing.what();
    }
}

TEST(MeshBuild, a_wedge_has_the_tangent_times_the_arc_s_volume) {
    // Vertices at r / cos(a/2): volume and wall areas are tan(a/2) / (a/2) times those with arcs.
    for (const auto& [name, subject] : laboratory_subjects()) {
        if (is_profile(subject) || std::holds_alternative<Box>(subject))
            continue;
        const BuiltMesh built = build_mesh(subject, {.wedge_angle = 5 * degree});
        const MeshQuality quality = quality_of(built);
        const double factor = std::tan(2.5 * degree) / (2.5 * degree);
        EXPECT_NEAR(quality.volume.value / built.exact().volume / factor, 1.0, 1e-12) << name;
        for (const CheckedMeasure& area : quality.areas)
            if (area.name == "bob" || area.name == "cup" || area.name == "shaft") {
                EXPECT_NEAR(area.value / area.exact / factor, 1.0, 1e-12)
                    << name << ' ' << area.name;
            }
    }
}

TEST(MeshBuild, a_sector_holds_the_arc_s_volume_within_a_thousandth) {
    for (const auto& [name, subject] : laboratory_subjects()) {
        if (is_profile(subject))
            continue;
        const MeshQuality quality = quality_of(build_mesh(subject, {.extent = MeshExtent::sector}));
        EXPECT_NEAR(quality.volume.value / quality.volume.exact, 1.0, 1e-3) << name;
    }
}

TEST(MeshBuild, second_order_follows_the_arc_with_the_fourth_power_of_the_angle) {
    const MeshSubject gap = ConcentricCylinders{14e-3, 15e-3, 42e-3};
    const auto error = [&](int cells) {
        const MeshQuality quality = quality_of(build_mesh(gap, {.cells_across_gap = 2,
                                                                .order = 2,
                                                                .extent = MeshExtent::sector,
                                                                .angular_cells = cells,
                                                                .axial_cells = 2}));
        return std::abs(quality.volume.value / quality.volume.exact - 1.0);
    };
    EXPECT_NEAR(std::log2(error(4) / error(8)), 4.0, 0.05);
    EXPECT_NEAR(std::log2(error(8) / error(16)), 4.0, 0.05);
}

TEST(MeshBuild, first_cells_have_the_asked_for_height_and_growth) {
    const BuiltMesh built = build_mesh(
        ConcentricCylinders{14e-3, 15e-3, 42e-3},
        {.extent = MeshExtent::section, .first_cell = 10e-6, .growth = 1.3, .axial_cells = 1});
    double first = 1.0;
    for (const Point& point : built.mesh.points)
        if (point.x > 14e-3)
            first = std::min(first, point.x - 14e-3);
    EXPECT_LE(first, 10e-6);
    EXPECT_GE(first, 8e-6); // the count is rounded up, so cells are a little smaller
    EXPECT_LE(quality_of(built).largest_growth, 1.3 * 1.02);
}

TEST(MeshBuild, a_slice_is_one_cell_high_and_flat) {
    const BuiltMesh built = build_mesh(DinBob{.bob_radius = 14e-3, .cup_radius = 15.2e-3},
                                       {.slice_height = 1e-3, .extent = MeshExtent::full});
    ASSERT_NE(built.mesh.patch("slice_bottom"), nullptr);
    EXPECT_EQ(built.mesh.patch("slice_bottom")->kind, PatchKind::flat);
    EXPECT_EQ(built.mesh.patch("slice_bottom")->count, built.mesh.cells.size());
    EXPECT_DOUBLE_EQ(built.domain.slice.factor(), 42.0);
}

TEST(MeshBuild, a_slice_of_triangles_is_not_flat) {
    for (const CellStyle style : {CellStyle::prisms, CellStyle::tetrahedra})
        try {
            const BuiltMesh built =
                build_mesh(ConcentricCylinders{14e-3, 15e-3, 42e-3},
                           {.cells_across_gap = 2, .slice_height = 1e-3, .cells = style});
            EXPECT_TRUE(quality_of(built).faults.empty());
            EXPECT_EQ(built.mesh.patch("slice_top")->kind, PatchKind::end_face);
        } catch (const MeshToolMissing& missing) {
            GTEST_SKIP() << missing.what();
        }
}

TEST(MeshBuild, a_double_gap_can_be_joined_under_its_rotor) {
    const BuiltMesh built = build_mesh(DoubleGap{{20e-3, 20.38e-3, 21.96e-3, 22.38e-3}, 55e-3},
                                       {.cells_across_gap = 5, .floor_clearance = 3e-3});
    EXPECT_TRUE(quality_of(built).faults.empty());
    for (const char* name : {"post", "bob", "bob_edge", "cup", "cup_floor", "free_surface"})
        EXPECT_NE(built.mesh.patch(name), nullptr) << name;
}

TEST(MeshBuild, the_walls_of_a_double_gap_s_rotor_can_be_patches_of_their_own) {
    const DoubleGap gap{{20e-3, 20.38e-3, 21.96e-3, 22.38e-3}, 55e-3};
    for (const std::optional<double> clearance : {std::optional<double>{}, std::optional{3e-3}}) {
        const BuiltMesh apart = build_mesh(gap, {.cells_across_gap = 3,
                                                 .floor_clearance = clearance,
                                                 .rotor_walls = RotorWalls::separate});
        EXPECT_TRUE(quality_of(apart).faults.empty());
        ASSERT_NE(apart.mesh.patch("bob_inner"), nullptr);
        ASSERT_NE(apart.mesh.patch("bob_outer"), nullptr);
        EXPECT_EQ(apart.mesh.patch("bob"), nullptr);
        const BuiltMesh together =
            build_mesh(gap, {.cells_across_gap = 3, .floor_clearance = clearance});
        EXPECT_EQ(apart.mesh.patch("bob_inner")->count + apart.mesh.patch("bob_outer")->count,
                  together.mesh.patch("bob")->count);
    }
    EXPECT_THROW((void)build_mesh(ConcentricCylinders{14e-3, 15e-3, 42e-3},
                                  {.rotor_walls = RotorWalls::separate}),
                 MeshError);
}

TEST(MeshBuild, a_thousand_random_instruments_mesh_and_pass_the_checks) {
    Dice dice{20260101};
    for (int draw = 0; draw < 1000; ++draw) {
        const MeshSubject subject = dice.subject();
        const MeshSettings settings = dice.settings();
        const MeshQuality quality = quality_of(build_mesh(subject, settings));
        EXPECT_TRUE(quality.faults.empty())
            << "draw " << draw << ", kind " << subject.index() << ": "
            << (quality.faults.empty() ? "" : quality.faults.front());
    }
}

TEST(MeshBuild, two_hundred_invalid_requests_are_refused_with_their_cause) {
    const std::vector<Spoiled> ways = ways_to_spoil();
    Dice dice{7};
    for (int draw = 0; draw < 200; ++draw) {
        const Spoiled& spoiled = ways[static_cast<std::size_t>(draw) % ways.size()];
        MeshSubject subject = dice.subject();
        if (std::string_view{spoiled.word} == "slice_height" &&
            std::holds_alternative<Profile>(subject))
            continue;
        MeshSettings settings = dice.settings();
        settings.slice_height.reset();
        spoiled.how(subject, settings, dice);
        try {
            (void)build_mesh(subject, settings);
            ADD_FAILURE() << "draw " << draw << " was meshed; expected " << spoiled.word;
        } catch (const MeshError& error) {
            EXPECT_NE(std::string{error.what()}.find(spoiled.word), std::string::npos)
                << spoiled.word << ": " << error.what();
        }
    }
}

// With ends = true the fluid below and above the rotor is meshed: volumes of cylinders by hand.
TEST(Domain, ends_of_gaps_are_part_of_the_section_but_of_a_slice) {
    constexpr double pi = std::numbers::pi;
    const ConcentricCylinders single{.bob_radius = 14e-3,
                                     .cup_radius = 15e-3,
                                     .height = 42e-3,
                                     .ends = true,
                                     .bottom_gap = 5e-3,
                                     .top_gap = 3e-3,
                                     .shaft_radius = 4e-3};
    const double beside = pi * (15e-3 * 15e-3 - 14e-3 * 14e-3) * 42e-3;
    const double below = pi * 15e-3 * 15e-3 * 5e-3;
    const double above = pi * (15e-3 * 15e-3 - 4e-3 * 4e-3) * 3e-3;
    EXPECT_NEAR(measures_of(domain_of(subject_of(single), {}).outlines).volume /
                    (beside + below + above),
                1.0, 1e-12);
    EXPECT_NEAR(
        measures_of(domain_of(subject_of(single), {.slice_height = 42e-3}).outlines).volume /
            beside,
        1.0, 1e-12);

    const DoubleGap gap{
        .radii = {20e-3, 21e-3, 22e-3, 23e-3}, .height = 30e-3, .ends = true, .bottom_gap = 2e-3};
    const double rings =
        pi * (21e-3 * 21e-3 - 20e-3 * 20e-3 + 23e-3 * 23e-3 - 22e-3 * 22e-3) * 30e-3;
    const double under = pi * (23e-3 * 23e-3 - 20e-3 * 20e-3) * 2e-3;
    EXPECT_NEAR(measures_of(domain_of(gap, {}).outlines).volume / (rings + under), 1.0, 1e-12);
    EXPECT_THROW((void)domain_of(gap, {.floor_clearance = 3e-3}), MeshError);

    // Cut into cells, each with the volume that its place in the domain gives it.
    for (const MeshSubject& subject : {subject_of(single), subject_of(gap)}) {
        const BuiltMesh built = build_mesh(subject, {.cells_across_gap = 4});
        EXPECT_TRUE(quality_of(built).faults.empty());
        EXPECT_NE(built.mesh.patch("cup_floor"), nullptr);
    }
}

} // namespace
} // namespace searle::geometry
