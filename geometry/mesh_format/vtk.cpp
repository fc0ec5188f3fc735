// Formats: VTK User's Guide, "VTK File Formats". Both files hold the cells and the faces of the
// boundary, with the number of the patch in the cell array "patch"; in a .vtu each name is a field
// array that holds its number, in a .vtk the second line has the names in the numbers' order.

#include "geometry/mesh_format/text_stream.hpp"
#include "geometry/mesh_format/vtk_numbers.hpp"
#include "geometry/mesh_format/write_mesh.hpp"

#include <array>
#include <string>
#include <vector>

namespace searle::geometry {
namespace {

std::string patch_names(const Mesh& mesh, char separator) {
    std::string names = "fluid";
    for (const Patch& patch : mesh.patches)
        names += separator + patch.name;
    return names;
}

/// One array of the appended block: its size in bytes, then its bytes.
template <class Item>
void append(TextStream& out, const std::vector<Item>& items) {
    const auto bytes = static_cast<std::uint64_t>(items.size() * sizeof(Item));
    out.raw(std::span{&bytes, 1});
    out.raw(std::span<const Item>{items});
}

} // namespace

std::vector<std::uint32_t> vtk_nodes(CellShape shape, std::span<const std::uint32_t> nodes) {
    static constexpr std::array<std::size_t, 20> hexahedron{0,  1, 2,  3,  4,  5,  6,  7,  8,  11,
                                                            13, 9, 16, 18, 19, 17, 10, 12, 14, 15};
    static constexpr std::array<std::size_t, 15> prism{0, 1,  2,  3,  4, 5,  6, 9,
                                                       7, 12, 14, 13, 8, 10, 11};
    static constexpr std::array<std::size_t, 13> pyramid{0, 1, 2, 3, 4, 5, 8, 10, 6, 7, 9, 11, 12};
    static constexpr std::array<std::size_t, 10> tetrahedron{0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
    // VTK's straight prism has its base the other way round, its curved one has not.
    static constexpr std::array<std::size_t, 6> straight_prism{0, 2, 1, 3, 5, 4};
    std::span<const std::size_t> order;
    switch (shape) {
    case CellShape::prism6:
        order = straight_prism;
        break;
    case CellShape::hexahedron20:
        order = hexahedron;
        break;
    case CellShape::prism15:
        order = prism;
        break;
    case CellShape::pyramid13:
        order = pyramid;
        break;
    case CellShape::tetrahedron10:
        order = tetrahedron;
        break;
    default:
        return {nodes.begin(), nodes.end()};
    }
    std::vector<std::uint32_t> result;
    for (const std::size_t at : order)
        result.push_back(nodes[at]);
    return result;
}

void write_vtu(const Mesh& mesh, const std::filesystem::path& file) {
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets;
    std::vector<std::uint8_t> types;
    std::vector<std::int32_t> patches;
    for_each_vtk_cell(mesh, [&](CellShape shape, std::span<const std::uint32_t> nodes, int patch) {
        for (const std::uint32_t node : vtk_nodes(shape, nodes))
            connectivity.push_back(node);
        offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
        types.push_back(static_cast<std::uint8_t>(vtk_type(shape)));
        patches.push_back(patch);
    });
    TextStream out{file};
    std::uint64_t offset = 0;
    const auto array = [&](const char* type, const char* name, int components,
                           std::uint64_t bytes) {
        out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\""
            << components << "\" format=\"appended\" offset=\"" << offset << "\"/>\n";
        offset += bytes + sizeof(std::uint64_t);
    };
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
           "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
    out << "<!-- patch: 0 fluid";
    for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch)
        out << ", " << patch + 1 << ' ' << mesh.patches[patch].name;
    out << " -->\n<FieldData>\n";
    const auto number = [&out](std::string_view name, std::size_t value) {
        out << "<DataArray type=\"Int32\" Name=\"" << name
            << "\" NumberOfTuples=\"1\" format=\"ascii\">" << value << "</DataArray>\n";
    };
    number("fluid", 0);
    for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch)
        number(mesh.patches[patch].name, patch + 1);
    out << "</FieldData>\n<Piece NumberOfPoints=\"" << mesh.points.size() << "\" NumberOfCells=\""
        << types.size() << "\">\n<Points>\n";
    static_assert(sizeof(Point) == 3 * sizeof(double));
    array("Float64", "points", 3, mesh.points.size() * sizeof(Point));
    out << "</Points>\n<Cells>\n";
    array("Int64", "connectivity", 1, connectivity.size() * sizeof(std::int64_t));
    array("Int64", "offsets", 1, offsets.size() * sizeof(std::int64_t));
    array("UInt8", "types", 1, types.size());
    out << "</Cells>\n<CellData Scalars=\"patch\">\n";
    array("Int32", "patch", 1, patches.size() * sizeof(std::int32_t));
    out << "</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
    append(out, mesh.points);
    append(out, connectivity);
    append(out, offsets);
    append(out, types);
    append(out, patches);
    out << "\n</AppendedData>\n</VTKFile>\n";
    out.close();
}

void write_vtk(const Mesh& mesh, const std::filesystem::path& file) {
    TextStream out{file};
    out << "# vtk DataFile Version 3.0\npatch: " << patch_names(mesh, ' ').substr(0, 240)
        << "\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " << mesh.points.size() << " double\n";
    for (const Point& point : mesh.points)
        out << point.x << ' ' << point.y << ' ' << point.z << '\n';
    const std::size_t count = mesh.cells.size() + mesh.faces.size();
    const std::size_t nodes = mesh.cells.all_nodes().size() + mesh.faces.all_nodes().size();
    out << "CELLS " << count << ' ' << count + nodes << '\n';
    for_each_vtk_cell(mesh, [&](CellShape shape, std::span<const std::uint32_t> all, int) {
        out << all.size();
        for (const std::uint32_t node : vtk_nodes(shape, all))
            out << ' ' << node;
        out << '\n';
    });
    out << "CELL_TYPES " << count << '\n';
    for_each_vtk_cell(mesh, [&](CellShape shape, std::span<const std::uint32_t>, int) {
        out << vtk_type(shape) << '\n';
    });
    out << "CELL_DATA " << count << "\nSCALARS patch int 1\nLOOKUP_TABLE default\n";
    for_each_vtk_cell(
        mesh, [&](CellShape, std::span<const std::uint32_t>, int patch) { out << patch << '\n'; });
    out.close();
}

} // namespace searle::geometry
