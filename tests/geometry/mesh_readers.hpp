#pragma once

#include "geometry/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

// Readers of mesh files, written after the formats' descriptions and not after the writers. Names
// stand in the order in which a file has them.
namespace searle::geometry::testing {

namespace fs = std::filesystem;

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

inline std::string output_of(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((command + " 2>&1").c_str(), "r"),
                                                     pclose);
    std::string text;
    char part[4096];
    while (pipe && std::fgets(part, sizeof part, pipe.get()) != nullptr)
        text += part;
    return text;
}

inline bool is_there(const char* program) {
    return std::system(fmt::format("command -v {} >/dev/null 2>&1", program).c_str()) == 0;
}

inline bool has_meshio() {
    return std::system("/usr/bin/python3 -c 'import meshio' >/dev/null 2>&1") == 0;
}

/// The least that checkMesh needs beside constant/polyMesh.
inline void prepare_check_mesh(const fs::path& folder) {
    fs::create_directories(folder / "system");
    const std::string head = "FoamFile{version 2.0;format ascii;class dictionary;object x;}\n";
    std::ofstream(folder / "system/controlDict")
        << head
        << "startFrom startTime;startTime 0;stopAt endTime;endTime 1;deltaT 1;writeInterval 1;\n";
    std::ofstream(folder / "system/fvSchemes")
        << head
        << "ddtSchemes{}gradSchemes{}divSchemes{}laplacianSchemes{}interpolationSchemes{}"
           "snGradSchemes{}\n";
    std::ofstream(folder / "system/fvSolution") << head;
}

/// What OpenFOAM's checkMesh says of a prepared folder.
inline std::string check_mesh(const fs::path& folder) {
    return output_of(fmt::format("cd {0} && WM_PROJECT_DIR=/usr/share/openfoam PWD={0} checkMesh",
                                 folder.string()));
}

using Faces = std::map<std::string, std::vector<std::pair<CellShape, std::vector<std::uint32_t>>>>;

inline void add_patches(const Faces& faces, Mesh& mesh) {
    for (const auto& [name, list] : faces) {
        mesh.patches.push_back({.name = name, .first = mesh.faces.size(), .count = list.size()});
        for (const auto& [shape, nodes] : list)
            mesh.faces.add(shape, nodes);
    }
}

/// gmsh's manual, "MSH file format version 2".
inline Mesh read_msh22(const fs::path& file, int dimension) {
    static const std::map<int, CellShape> shapes{
        {1, CellShape::line2},          {2, CellShape::triangle3},    {3, CellShape::quadrangle4},
        {4, CellShape::tetrahedron4},   {5, CellShape::hexahedron8},  {6, CellShape::prism6},
        {7, CellShape::pyramid5},       {8, CellShape::line3},        {9, CellShape::triangle6},
        {11, CellShape::tetrahedron10}, {16, CellShape::quadrangle8}, {17, CellShape::hexahedron20},
        {18, CellShape::prism15},       {19, CellShape::pyramid13}};
    Mesh mesh;
    mesh.dimension = dimension;
    std::map<int, std::string> names;
    Faces faces;
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
                    faces[names[tag.at(0)]].emplace_back(shape, nodes);
            }
        }
    }
    add_patches(faces, mesh);
    return mesh;
}

/// Dumps what meshio reads: points, then "shape name node ...", nodes in VTK's order. Names by what
/// each format has: sets, markers, families, field data, an Information element, a second line.
constexpr const char* meshio_dump = R"(
import re, sys, warnings, meshio, numpy
warnings.simplefilter('ignore')
from meshio.abaqus import _abaqus
_abaqus.abaqus_to_meshio_type['C3D5'] = 'pyramid'
for kind in ('wedge15', 'pyramid13'):
    meshio._mesh.topological_dimension.setdefault(kind, 3)
source, legend = sys.argv[1], sys.argv[2:]
ending = source[source.rfind('.'):]
mesh = meshio.read(source)
count = [len(b.data) for b in mesh.cells]
tags = [['?'] * n for n in count]
def by_number(data, names):
    for block, numbers in enumerate(data):
        tags[block] = [names.get(int(i), '?') for i in numpy.atleast_1d(numbers)]
if ending == '.inp':
    for name, parts in mesh.cell_sets.items():
        for block, part in enumerate(parts):
            for at in part:
                tags[block][at] = name
elif ending == '.su2':
    markers = re.findall(r'MARKER_TAG= *(\S+)', open(source).read())
    numbers = {i + 1: n for i, n in enumerate(markers)}
    numbers[0] = 'fluid'
    by_number(mesh.cell_data['su2:tag'], numbers)
elif ending == '.med':
    by_number(mesh.cell_data['cell_tags'], {i: n[0] for i, n in mesh.cell_tags.items()})
elif ending == '.vtk':
    names = open(source, 'rb').read(2000).split(b'\n')[1].decode().split()[1:]
    by_number(mesh.cell_data['patch'], dict(enumerate(names)))
elif ending in ('.mesh', '.avs', '.bdf', '.vol'):
    data = next(iter(mesh.cell_data.values()))
    by_number(data, {i + 1: n for i, n in enumerate(legend)})
else:
    names = {int(numpy.atleast_1d(v)[0]): n for n, v in mesh.field_data.items()}
    by_number(mesh.cell_data.get('gmsh:physical') or mesh.cell_data['patch'], names)
print('points', len(mesh.points))
for p in mesh.points:
    print(*['%.17g' % x for x in list(p) + [0.0] * (3 - len(p))])
for block, names in zip(mesh.cells, tags):
    for nodes, name in zip(block.data, names):
        print(block.type, name, len(nodes), *nodes)
print('end 0 0')
)";

/// VTK's order of the middle nodes in gmsh's: VTK User's Guide, figure "Nonlinear cell types"
/// (base, top, uprights), and gmsh's manual, "Node ordering".
inline std::vector<std::size_t> places_in_gmsh(CellShape shape) {
    using enum CellShape;
    const auto edge_at = [shape](int a, int b) {
        const auto edges = edges_of(shape);
        for (std::size_t at = 0; at < edges.size(); ++at)
            if ((edges[at][0] == a && edges[at][1] == b) ||
                (edges[at][0] == b && edges[at][1] == a))
                return corner_count(shape) + at;
        return std::size_t{0};
    };
    std::vector<std::array<int, 2>> order;
    if (shape == hexahedron20)
        order = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                 {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
    else if (shape == prism15)
        order = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
    else if (shape == pyramid13)
        order = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
    else if (shape == tetrahedron10)
        order = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
    else
        for (const LocalEdge& edge : edges_of(shape))
            if (node_count(shape) > corner_count(shape))
                order.push_back({edge[0], edge[1]});
    std::vector<std::size_t> places;
    for (std::size_t corner = 0; corner < corner_count(shape); ++corner)
        places.push_back(corner);
    for (const auto& [a, b] : order)
        places.push_back(edge_at(a, b));
    return places;
}

/// Any file that meshio reads. `legend` names the numbers 1, 2, ... where a format has no names.
/// What cannot be read gives a mesh without points; `said` then holds why.
inline Mesh read_by_meshio(const fs::path& file, int dimension,
                           const std::vector<std::string>& legend, std::string& said) {
    static const std::map<std::string, CellShape> shapes{{"line", CellShape::line2},
                                                         {"triangle", CellShape::triangle3},
                                                         {"quad", CellShape::quadrangle4},
                                                         {"tetra", CellShape::tetrahedron4},
                                                         {"hexahedron", CellShape::hexahedron8},
                                                         {"wedge", CellShape::prism6},
                                                         {"pyramid", CellShape::pyramid5},
                                                         {"line3", CellShape::line3},
                                                         {"triangle6", CellShape::triangle6},
                                                         {"tetra10", CellShape::tetrahedron10},
                                                         {"quad8", CellShape::quadrangle8},
                                                         {"hexahedron20", CellShape::hexahedron20},
                                                         {"wedge15", CellShape::prism15},
                                                         {"pyramid13", CellShape::pyramid13}};
    const fs::path script = file.parent_path() / "dump.py";
    const fs::path dump = file.parent_path() / "dump.txt";
    std::ofstream(script) << meshio_dump;
    said = output_of(fmt::format("/usr/bin/python3 {} {} {} > {}", script.string(), file.string(),
                                 fmt::join(legend, " "), dump.string()));
    Mesh mesh;
    mesh.dimension = dimension;
    Faces faces;
    std::ifstream in(dump);
    std::string word;
    while (in >> word && word != "points") // meshio may print of itself before
        ;
    std::size_t count = 0;
    in >> count;
    mesh.points.resize(count);
    for (Point& point : mesh.points)
        in >> point.x >> point.y >> point.z;
    std::string name;
    while (in >> word >> name >> count && word != "end") {
        const CellShape shape = shapes.at(word);
        const std::vector<std::size_t> places = places_in_gmsh(shape);
        std::vector<std::uint32_t> nodes(count);
        for (std::size_t at = 0; at < count; ++at)
            in >> nodes[places.at(at)];
        if (dimension_of(shape) == dimension) {
            mesh.cells.add(shape, nodes);
            if (name != "fluid")
                said += "a cell belongs to " + name + "\n";
        } else {
            faces[name].emplace_back(shape, nodes);
        }
    }
    add_patches(faces, mesh);
    return mesh;
}

} // namespace searle::geometry::testing
