#include "geometry/mesh_error.hpp"
#include "geometry/mesh_format/write_mesh.hpp"
#include "geometry/mesh_quality.hpp"
#include "mesh_readers.hpp"
#include "mesh_subjects.hpp"
#include "polymesh_reader.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>

namespace searle::geometry {
namespace {

using namespace testing;

/// What is read back has the same cells, the same patches by name, volume and areas.
void expect_same(const BuiltMesh& written, Mesh read, double tolerance, const std::string& where) {
    const MeshQuality before = quality_of(written);
    BuiltMesh again = written;
    again.mesh = std::move(read);
    ASSERT_EQ(again.mesh.points.size(), written.mesh.points.size()) << where;
    const MeshQuality after = quality_of(again);
    std::map<CellShape, std::size_t> shapes;
    for (const CellShape shape : written.mesh.cells.shapes())
        ++shapes[shape];
    for (const CellShape shape : again.mesh.cells.shapes())
        --shapes[shape];
    for (const auto& [shape, left] : shapes)
        EXPECT_EQ(left, 0U) << where << ' ' << name_of(shape);
    EXPECT_EQ(after.unmatched + after.misoriented + after.inverted, 0U) << where;
    EXPECT_NEAR(after.volume.value / before.volume.value, 1.0, tolerance) << where;
    EXPECT_EQ(after.areas.size(), before.areas.size()) << where;
    for (const CheckedMeasure& area : before.areas) {
        const auto same = std::find_if(after.areas.begin(), after.areas.end(),
                                       [&](const auto& one) { return one.name == area.name; });
        ASSERT_NE(same, after.areas.end()) << where << ' ' << area.name;
        EXPECT_EQ(same->faces, area.faces) << where << ' ' << area.name;
        EXPECT_NEAR(same->value / area.value, 1.0, tolerance) << where << ' ' << area.name;
    }
}

TEST(MeshFormat, msh22_reads_back_with_the_same_cells_patches_and_volumes) {
    const Folder folder;
    for (const auto& [name, subject] : laboratory_subjects())
        for (const int order : {1, 2})
            for (const auto extent : {MeshExtent::section, MeshExtent::sector}) {
                const BuiltMesh built =
                    build_mesh(subject, {.cells_across_gap = 4, .order = order, .extent = extent});
                write_mesh(built.mesh, folder.path / "a.msh", MeshFormat::msh22);
                expect_same(built, read_msh22(folder.path / "a.msh", built.mesh.dimension), 1e-14,
                            name);
            }
}

/// A format that meshio reads, with what it can hold and how exactly it holds points.
struct MeshioFormat {
    const char* ending;
    double tolerance;
    int order = 2;
    bool holds_curved_pyramids = true;
};

TEST(MeshFormat, every_format_that_meshio_reads_gives_back_cells_names_and_volumes) {
    if (!has_meshio())
        GTEST_SKIP() << "meshio is not here (apt-get install python3-meshio)";
    // Text of 16 digits and raw numbers differ in rounding alone; a Nastran field has 9 digits.
    const std::array formats{MeshioFormat{"msh", 1e-12},
                             MeshioFormat{"vtu", 1e-12},
                             MeshioFormat{"vtk", 1e-12},
                             MeshioFormat{"xdmf", 1e-12, 1},
                             MeshioFormat{"inp", 1e-12, 2, false},
                             MeshioFormat{"su2", 1e-12, 1},
                             MeshioFormat{"med", 1e-12},
                             MeshioFormat{"mesh", 1e-12, 1},
                             MeshioFormat{"bdf", 1e-5},
                             MeshioFormat{"avs", 1e-12, 1},
                             MeshioFormat{"vol", 1e-12}};
    const Folder folder;
    // Hexahedra and prisms; prisms, pyramids and tetrahedra at the axis; a plane section.
    struct Scene {
        MeshExtent extent;
        CellStyle cells;
        int order;
    };
    const std::array scenes{Scene{MeshExtent::wedge, CellStyle::hexahedra, 1},
                            Scene{MeshExtent::sector, CellStyle::prisms, 1},
                            Scene{MeshExtent::wedge, CellStyle::hexahedra, 2},
                            Scene{MeshExtent::sector, CellStyle::prisms, 2}};
    const DinBob bob{.bob_radius = 14e-3, .cup_radius = 15.2e-3};
    for (const Scene& scene : scenes) {
        const BuiltMesh built = build_mesh(bob, {.cells_across_gap = 2,
                                                 .order = scene.order,
                                                 .extent = scene.extent,
                                                 .cells = scene.cells,
                                                 .angular_cells = 1});
        std::vector<std::string> legend;
        for (const Patch& patch : built.mesh.patches)
            legend.push_back(patch.name);
        legend.emplace_back("fluid");
        for (const MeshioFormat& format : formats) {
            if (scene.order > format.order ||
                (scene.order == 2 && scene.cells == CellStyle::prisms &&
                 !format.holds_curved_pyramids))
                continue;
            const fs::path file = folder.path / fmt::format("a.{}", format.ending);
            const std::string where = fmt::format("{} order {}", format.ending, scene.order);
            try {
                write_mesh(built.mesh, file, *format_of(file));
            } catch (const MeshToolMissing& missing) {
                GTEST_SKIP() << missing.what();
            }
            std::string said;
            expect_same(built, read_by_meshio(file, 3, legend, said), format.tolerance,
                        where + ' ' + said);
        }
    }
}

TEST(MeshFormat, meshio_formats_refuse_what_they_would_lose_and_leave_nothing) {
    if (!has_meshio())
        GTEST_SKIP() << "meshio is not here (apt-get install python3-meshio)";
    const Folder folder;
    const BuiltMesh curved =
        build_mesh(ConcentricCylinders{14e-3, 15e-3, 42e-3}, {.cells_across_gap = 2, .order = 2});
    for (const char* ending : {"su2", "mesh", "avs"}) {
        const fs::path file = folder.path / fmt::format("a.{}", ending);
        try {
            write_mesh(curved.mesh, file, *format_of(file));
            ADD_FAILURE() << ending << " was written";
        } catch (const MeshError& error) {
            EXPECT_NE(std::string{error.what()}.find("cannot hold this mesh"), std::string::npos)
                << error.what();
        }
        EXPECT_TRUE(fs::is_empty(folder.path)) << ending;
    }
}

TEST(MeshFormat, formats_without_names_say_so_with_the_numbers) {
    if (!has_meshio())
        GTEST_SKIP() << "meshio is not here (apt-get install python3-meshio)";
    const Folder folder;
    const BuiltMesh built =
        build_mesh(ConcentricCylinders{14e-3, 15e-3, 42e-3}, {.cells_across_gap = 2});
    const auto notes_for = [&](const char* ending) {
        const fs::path file = folder.path / fmt::format("a.{}", ending);
        return fmt::format("{}", fmt::join(write_mesh(built.mesh, file, *format_of(file)), "; "));
    };
    EXPECT_EQ(notes_for("inp"), "");
    EXPECT_EQ(notes_for("su2"), "");
    EXPECT_NE(notes_for("avs").find("2 cup"), std::string::npos) << notes_for("avs");
}

TEST(MeshFormat, polymesh_reads_back_with_the_same_cells_patches_and_volumes) {
    const Folder folder;
    for (const auto& [name, subject] : laboratory_subjects())
        for (const auto extent : {MeshExtent::wedge, MeshExtent::sector, MeshExtent::full}) {
            const BuiltMesh built = build_mesh(subject, {.cells_across_gap = 3, .extent = extent});
            const MeshQuality quality = quality_of(built);
            write_mesh(built.mesh, folder.path / "", MeshFormat::openfoam);
            const PolyMesh read = read_polymesh(folder.path / "constant/polyMesh");
            EXPECT_EQ(read.cells, quality.cells) << name;
            EXPECT_NEAR(read.volume / quality.volume.value, 1.0, 1e-10) << name;
            ASSERT_EQ(read.patches.size(), quality.areas.size()) << name;
            for (const CheckedMeasure& area : quality.areas) {
                ASSERT_TRUE(read.patches.contains(area.name)) << name << ' ' << area.name;
                const PolyMesh::FoamPatch& patch = read.patches.at(area.name);
                EXPECT_EQ(patch.faces, area.faces) << name << ' ' << area.name;
                EXPECT_NEAR(patch.area / area.value, 1.0, 1e-10) << name << ' ' << area.name;
                const PatchKind kind = built.mesh.patch(area.name)->kind;
                EXPECT_EQ(patch.type == "wall", kind == PatchKind::wall) << area.name;
                EXPECT_EQ(patch.type == "wedge", kind == PatchKind::wedge) << area.name;
                EXPECT_EQ(patch.type == "cyclic", kind == PatchKind::periodic) << area.name;
                EXPECT_EQ(patch.partner, built.mesh.patch(area.name)->partner) << area.name;
            }
        }
}

TEST(MeshFormat, stl_triangles_have_the_patches_areas_and_enclose_the_volume) {
    const Folder folder;
    const BuiltMesh built =
        build_mesh(DinBob{.bob_radius = 14e-3, .cup_radius = 15.2e-3}, {.cells_across_gap = 4});
    write_mesh(built.mesh, folder.path / "din.stl", MeshFormat::stl);
    std::ifstream in(folder.path / "din.stl");
    std::map<std::string, double> areas;
    double volume = 0.0;
    std::string word;
    std::string solid;
    std::vector<Point> corners;
    while (in >> word) {
        if (word == "solid")
            in >> solid;
        else if (word == "vertex") {
            Point p;
            in >> p.x >> p.y >> p.z;
            corners.push_back(p);
        } else if (word == "endloop") {
            const auto [a, b, c] = std::array{corners[0], corners[1], corners[2]};
            const double x = (b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y);
            const double y = (b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z);
            const double z = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
            areas[solid] += 0.5 * std::sqrt(x * x + y * y + z * z);
            volume += (x * a.x + y * a.y + z * a.z) / 6.0;
            corners.clear();
        }
    }
    const MeshQuality quality = quality_of(built);
    EXPECT_EQ(areas.size(), quality.areas.size());
    for (const CheckedMeasure& area : quality.areas)
        EXPECT_NEAR(areas[area.name] / area.value, 1.0, 1e-12) << area.name;
    EXPECT_NEAR(volume / quality.volume.value, 1.0, 1e-10);
}

TEST(MeshFormat, openfoam_says_mesh_ok_for_every_kind_extent_and_resolution) {
    if (!is_there("checkMesh"))
        GTEST_SKIP() << "OpenFOAM is not here (apt-get install openfoam)";
    const Folder folder;
    prepare_check_mesh(folder.path);
    for (const auto& [name, subject] : laboratory_subjects())
        for (const auto extent : {MeshExtent::wedge, MeshExtent::sector, MeshExtent::full})
            for (const int cells : {3, 6, 12}) {
                const BuiltMesh built =
                    build_mesh(subject, {.cells_across_gap = cells, .extent = extent});
                write_mesh(built.mesh, folder.path / "", MeshFormat::openfoam);
                const std::string said = check_mesh(folder.path);
                EXPECT_NE(said.find("Mesh OK."), std::string::npos)
                    << name << ' ' << static_cast<int>(extent) << ' ' << cells << '\n'
                    << said;
            }
}

TEST(MeshFormat, an_ending_that_nobody_knows_has_no_format) {
    EXPECT_FALSE(format_of("mesh.mhs").has_value());
    EXPECT_EQ(format_of("folder/"), MeshFormat::openfoam);
    EXPECT_EQ(format_of("a.MSH"), MeshFormat::msh41);
    EXPECT_EQ(format_of("a.xdmf"), MeshFormat::meshio);
}

TEST(MeshFormat, openfoam_refuses_curved_cells_and_sections) {
    const Folder folder;
    const MeshSubject gap = ConcentricCylinders{14e-3, 15e-3, 42e-3};
    EXPECT_THROW(
        write_mesh(build_mesh(gap, {.order = 2}).mesh, folder.path / "", MeshFormat::openfoam),
        MeshError);
    EXPECT_THROW(write_mesh(build_mesh(gap, {.extent = MeshExtent::section}).mesh, folder.path / "",
                            MeshFormat::openfoam),
                 MeshError);
}

} // namespace
} // namespace searle::geometry
