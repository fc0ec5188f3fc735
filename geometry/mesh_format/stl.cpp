// Format: 3D Systems' StereoLithography, text: one solid a patch.

#include "geometry/mesh_error.hpp"
#include "geometry/mesh_format/text_stream.hpp"
#include "geometry/mesh_format/write_mesh.hpp"
#include "geometry/vector3.hpp"

#include <array>
#include <vector>

namespace searle::geometry {
namespace {

using Local = std::array<std::size_t, 3>;

/// Triangles of a face; a curved one is cut through the middles of its edges too.
std::vector<Local> triangles_of(CellShape shape) {
    switch (shape) {
    case CellShape::triangle3:
        return {{0, 1, 2}};
    case CellShape::quadrangle4:
        return {{0, 1, 2}, {0, 2, 3}};
    case CellShape::triangle6:
        return {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
    default:
        return {{0, 4, 7}, {4, 1, 5}, {5, 2, 6}, {6, 3, 7}, {4, 5, 6}, {4, 6, 7}};
    }
}

void write_point(const Point& point, TextStream& out) {
    out << point.x << ' ' << point.y << ' ' << point.z << '\n';
}

} // namespace

void write_stl(const Mesh& mesh, const std::filesystem::path& file) {
    if (mesh.dimension != 3)
        throw MeshError("an .stl file holds the surface of a solid, not a plane section; choose "
                        "another mesh.extent or another format");
    TextStream out{file};
    for (const Patch& patch : mesh.patches) {
        out << "solid " << patch.name << '\n';
        for (std::size_t face = patch.first; face < patch.first + patch.count; ++face) {
            const auto nodes = mesh.faces.nodes(face);
            for (const Local& triangle : triangles_of(mesh.faces.shape(face))) {
                const Point& a = mesh.points[nodes[triangle[0]]];
                const Point& b = mesh.points[nodes[triangle[1]]];
                const Point& c = mesh.points[nodes[triangle[2]]];
                const Point normal = cross(b - a, c - a);
                out << "facet normal ";
                write_point((1.0 / length(normal)) * normal, out);
                out << "outer loop\n";
                for (const Point* corner : {&a, &b, &c}) {
                    out << "vertex ";
                    write_point(*corner, out);
                }
                out << "endloop\nendfacet\n";
            }
        }
        out << "endsolid " << patch.name << '\n';
    }
    out.close();
}

} // namespace searle::geometry
