#pragma once

#include "geometry/mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace searle::geometry::testing {

/// What an OpenFOAM mesh says, read after the user guide's "Mesh description". Cells have no shape
/// there, so volumes and areas come from the faces.
struct PolyMesh {
    struct FoamPatch {
        std::string type;
        std::string partner;
        std::size_t faces{};
        double area{}; ///< m^2, over the triangles about each face's middle
    };
    std::size_t cells{};
    std::map<std::string, FoamPatch> patches;
    double volume{}; ///< m^3
};

namespace polymesh {

/// A file without its header and brackets, as words.
inline std::stringstream words_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    text.erase(0, text.find('}') + 1);
    for (char& letter : text)
        if (letter == '(' || letter == ')' || letter == ';' || letter == '{' || letter == '}')
            letter = ' ';
    return std::stringstream{text};
}

} // namespace polymesh

inline PolyMesh read_polymesh(const std::filesystem::path& folder) {
    std::size_t count = 0;
    std::stringstream points_in = polymesh::words_of(folder / "points");
    points_in >> count;
    std::vector<std::array<double, 3>> points(count);
    for (auto& point : points)
        points_in >> point[0] >> point[1] >> point[2];
    std::stringstream faces_in = polymesh::words_of(folder / "faces");
    faces_in >> count;
    std::vector<std::vector<std::size_t>> faces(count);
    for (auto& face : faces) {
        faces_in >> count;
        face.resize(count);
        for (std::size_t& node : face)
            faces_in >> node;
    }
    PolyMesh mesh;
    for (const char* side : {"owner", "neighbour"}) {
        std::stringstream in = polymesh::words_of(folder / side);
        in >> count;
        for (std::size_t face = 0; face < count; ++face) {
            std::size_t cell = 0;
            in >> cell;
            mesh.cells = std::max(mesh.cells, cell + 1);
        }
    }
    std::stringstream boundary = polymesh::words_of(folder / "boundary");
    boundary >> count;
    for (std::size_t patch = 0; patch < count; ++patch) {
        std::string name;
        boundary >> name;
        PolyMesh::FoamPatch& it = mesh.patches[name];
        std::string word;
        std::size_t start = 0;
        while (boundary >> word && word != "startFace") {
            if (word == "type")
                boundary >> it.type;
            else if (word == "neighbourPatch")
                boundary >> it.partner;
            else if (word == "nFaces")
                boundary >> it.faces;
        }
        boundary >> start;
        for (std::size_t face = start; face < start + it.faces; ++face) {
            const auto& nodes = faces[face];
            std::array<double, 3> middle{};
            for (const std::size_t node : nodes)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    middle[axis] += points[node][axis] / static_cast<double>(nodes.size());
            for (std::size_t at = 0; at < nodes.size(); ++at) {
                const auto& a = points[nodes[at]];
                const auto& b = points[nodes[(at + 1) % nodes.size()]];
                std::array<double, 3> u{};
                std::array<double, 3> v{};
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    u[axis] = a[axis] - middle[axis];
                    v[axis] = b[axis] - middle[axis];
                }
                const std::array<double, 3> normal{u[1] * v[2] - u[2] * v[1],
                                                   u[2] * v[0] - u[0] * v[2],
                                                   u[0] * v[1] - u[1] * v[0]};
                it.area += 0.5 * std::hypot(normal[0], normal[1], normal[2]);
                for (std::size_t axis = 0; axis < 3; ++axis)
                    mesh.volume += normal[axis] * (a[axis] + b[axis] + middle[axis]) / 18.0;
            }
        }
    }
    return mesh;
}

} // namespace searle::geometry::testing
