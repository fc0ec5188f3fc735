#include "geometry/mesh_error.hpp"
#include "geometry/mesh_format/write_mesh.hpp"
#include "geometry/mesh_quality.hpp"
#include "mesh_subjects.hpp"

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

namespace fs = std::filesystem;
using testing::laboratory_subjects;

class Folder {
public:
    Folder() {
        std::string name = (fs::temp_directory_path() / "searle-format-XXXXXX").string();
        path = mkdtemp(name.data());
    }
    ~Folder() { fs::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    fs::path path;
};

std::string output_of(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((command + " 2>&1").c_str(), "r"),
                                                     pclose);
    std::string text;
    char part[4096];
    while (pipe && std::fgets(part, sizeof part, pipe.get()) != nullptr)
        text += part;
    return text;
}

bool is_there(const char* program) {
    return std::system(fmt::format("command -v {} >/dev/null 2>&1", program).c_str()) == 0;
}

bool has_meshio() {
    return std::system("/usr/bin/python3 -c 'import meshio' >/dev/null 2>&1") == 0;
}

/// An independent reading of gmsh 2.2: after the manual, not after the writer.
Mesh read_msh22(const fs::path& file, int dimension) {
    static const std::map<int, CellShape> shapes{
        {1, CellShape::line2},          {2, CellShape::triangle3},    {3, CellShape::quadrangle4},
        {4, CellShape::tetrahedron4},   {5, CellShape::hexahedron8},  {6, CellShape::prism6},
        {7, CellShape::pyramid5},       {8, CellShape::line3},        {9, CellShape::triangle6},
        {11, CellShape::tetrahedron10}, {16, CellShape::quadrangle8}, {17, CellShape::hexahedron20},
        {18, CellShape::prism15},       {19, CellShape::pyramid13}};
    Mesh mesh;
    mesh.dimension = dimension;
    std::map<int, std::string> names;
    std::map<int, std::vector<std::pair<CellShape, std::vector<std::uint32_t>>>> faces;
    std::ifstream in(file);
    std::string word;
    while (in >> word) {
        std::size_t count = 0;
        if (word == "$PhysicalNames") {
            in >> count;
            for (std::size_t at = 0; at < count; ++at) {
                int of = 0;
                int tag = 0;
                std::string name;
                in >> of >> tag >> name;
                names[tag] = name.substr(1, name.size() - 2);
            }
        } else if (word == "$Nodes") {
            in >> count;
            for (std::size_t at = 0; at < count; ++at) {
                Point point;
                std::size_t number = 0;
                in >> number >> point.x >> point.y >> point.z;
                mesh.points.push_back(point);
            }
        } else if (word == "$Elements") {
            in >> count;
            for (std::size_t at = 0; at < count; ++at) {
                std::size_t number = 0;
                int type = 0;
                int tags = 0;
                in >> number >> type >> tags;
                std::vector<int> tag(static_cast<std::size_t>(tags));
                for (int& each : tag)
                    in >> each;
                const CellShape shape = shapes.at(type);
                std::vector<std::uint32_t> nodes(node_count(shape));
                for (std::uint32_t& node : nodes) {
                    in >> node;
                    --node;
                }
                if (dimension_of(shape) == dimension)
                    mesh.cells.add(shape, nodes);
                else
                    faces[tag.at(0)].emplace_back(shape, nodes);
            }
        }
    }
    for (const auto& [tag, list] : faces) {
        mesh.patches.push_back(
            {.name = names[tag], .first = mesh.faces.size(), .count = list.size()});
        for (const auto& [shape, nodes] : list)
            mesh.faces.add(shape, nodes);
    }
    return mesh;
}

TEST(MeshFormat, msh22_reads_back_with_the_same_cells_patches_and_volumes) {
    const Folder folder;
    for (const auto& [name, subject] : laboratory_subjects())
        for (const int order : {1, 2})
            for (const auto extent : {MeshExtent::section, MeshExtent::sector}) {
                BuiltMesh built =
                    build_mesh(subject, {.cells_across_gap = 4, .order = order, .extent = extent});
                write_mesh(built.mesh, folder.path / "a.msh", MeshFormat::msh22);
                const MeshQuality before = quality_of(built);
                built.mesh = read_msh22(folder.path / "a.msh", built.mesh.dimension);
                const MeshQuality after = quality_of(built);
                EXPECT_EQ(after.cells, before.cells) << name;
                EXPECT_EQ(after.volume.value, before.volume.value) << name;
                EXPECT_EQ(after.unmatched + after.misoriented, 0U) << name;
                for (const CheckedMeasure& area : before.areas) {
                    const auto same =
                        std::find_if(after.areas.begin(), after.areas.end(),
                                     [&](const auto& one) { return one.name == area.name; });
                    ASSERT_NE(same, after.areas.end()) << name << ' ' << area.name;
                    EXPECT_EQ(same->faces, area.faces) << name << ' ' << area.name;
                    EXPECT_DOUBLE_EQ(same->value, area.value) << name << ' ' << area.name;
                }
            }
}

/// Patch names with their number of faces, and the number of solid cells, as meshio sees them.
constexpr const char* meshio_summary = R"(
import sys, meshio, numpy
mesh = meshio.read(sys.argv[1])
print('summary')
data = mesh.cell_data.get('gmsh:physical') or mesh.cell_data['patch']
solid = ('hexahedron', 'wedge', 'pyramid', 'tetra')
print('cells', sum(len(b.data) for b in mesh.cells if b.type.rstrip('0123456789') in solid))
for name, value in sorted(mesh.field_data.items()):
    number = int(numpy.atleast_1d(value)[0])
    print(name, sum(int((d == number).sum()) for d in data))
)";

std::string expected_summary(const Mesh& mesh) {
    std::map<std::string, std::size_t> counts{{"fluid", mesh.cells.size()}};
    for (const Patch& patch : mesh.patches)
        counts[patch.name] = patch.count;
    std::string text = fmt::format("summary\ncells {}\n", mesh.cells.size());
    for (const auto& [name, count] : counts)
        text += fmt::format("{} {}\n", name, count);
    return text;
}

TEST(MeshFormat, meshio_reads_what_is_written_with_names) {
    if (!has_meshio())
        GTEST_SKIP() << "meshio is not here (apt-get install python3-meshio)";
    const Folder folder;
    const BuiltMesh built =
        build_mesh(DinBob{.bob_radius = 14e-3, .cup_radius = 15.2e-3}, {.cells_across_gap = 4});
    std::ofstream(folder.path / "summary.py") << meshio_summary;
    for (const char* ending : {"msh", "vtu", "xdmf"}) {
        const fs::path file = folder.path / fmt::format("din.{}", ending);
        try {
            write_mesh(built.mesh, file, *format_of(file));
        } catch (const MeshToolMissing& missing) {
            GTEST_SKIP() << missing.what();
        }
        // meshio may print of itself before.
        const std::string said = output_of(fmt::format(
            "/usr/bin/python3 {} {}", (folder.path / "summary.py").string(), file.string()));
        const std::size_t start = said.find("summary");
        EXPECT_EQ(start == std::string::npos ? said : said.substr(start),
                  expected_summary(built.mesh))
            << ending;
    }
}

TEST(MeshFormat, abaqus_and_su2_keep_the_names) {
    if (!has_meshio())
        GTEST_SKIP() << "meshio is not here (apt-get install python3-meshio)";
    const Folder folder;
    const BuiltMesh built =
        build_mesh(ConcentricCylinders{14e-3, 15e-3, 42e-3}, {.cells_across_gap = 3});
    for (const char* ending : {"inp", "su2"}) {
        const fs::path file = folder.path / fmt::format("gap.{}", ending);
        write_mesh(built.mesh, file, *format_of(file));
        std::stringstream text;
        text << std::ifstream(file).rdbuf();
        for (const Patch& patch : built.mesh.patches)
            EXPECT_NE(text.str().find(patch.name), std::string::npos)
                << ending << ' ' << patch.name;
    }
}

TEST(MeshFormat, stl_triangles_have_the_patches_areas) {
    const Folder folder;
    const BuiltMesh built =
        build_mesh(DinBob{.bob_radius = 14e-3, .cup_radius = 15.2e-3}, {.cells_across_gap = 4});
    write_mesh(built.mesh, folder.path / "din.stl", MeshFormat::stl);
    std::ifstream in(folder.path / "din.stl");
    std::map<std::string, double> areas;
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
            corners.clear();
        }
    }
    for (const CheckedMeasure& area : quality_of(built).areas)
        EXPECT_NEAR(areas[area.name] / area.value, 1.0, 1e-12) << area.name;
}

TEST(MeshFormat, openfoam_says_mesh_ok_for_every_kind_extent_and_resolution) {
    if (!is_there("checkMesh"))
        GTEST_SKIP() << "OpenFOAM is not here (apt-get install openfoam)";
    const Folder folder;
    fs::create_directories(folder.path / "system");
    const std::string head = "FoamFile{version 2.0;format ascii;class dictionary;object x;}\n";
    std::ofstream(folder.path / "system/controlDict")
        << head
        << "startFrom startTime;startTime 0;stopAt endTime;endTime 1;deltaT 1;writeInterval 1;\n";
    std::ofstream(folder.path / "system/fvSchemes")
        << head
        << "ddtSchemes{}gradSchemes{}divSchemes{}laplacianSchemes{}interpolationSchemes{}"
           "snGradSchemes{}\n";
    std::ofstream(folder.path / "system/fvSolution") << head;
    for (const auto& [name, subject] : laboratory_subjects())
        for (const auto extent : {MeshExtent::wedge, MeshExtent::sector, MeshExtent::full})
            for (const int cells : {3, 6, 12}) {
                const BuiltMesh built =
                    build_mesh(subject, {.cells_across_gap = cells, .extent = extent});
                write_mesh(built.mesh, folder.path / "", MeshFormat::openfoam);
                const std::string said = output_of(
                    fmt::format("cd {0} && WM_PROJECT_DIR=/usr/share/openfoam PWD={0} checkMesh",
                                folder.path.string()));
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
