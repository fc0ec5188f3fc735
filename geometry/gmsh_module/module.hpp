#pragma once

#include "geometry/outline.hpp"

#include <functional>
#include <string>
#include <vector>

namespace searle::geometry {

/// What the module that holds gmsh is asked: triangles in one outline.
struct TriangulationJob {
    const Outline* outline = nullptr;
    std::function<double(const SectionPoint&)> size_at; ///< m
};

/// What it answers. Edge by edge of the outline the nodes along it, ends included.
struct TriangulationAnswer {
    std::vector<SectionPoint> points;
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< anticlockwise
    std::vector<std::vector<std::uint32_t>> edge_nodes;
    std::string gmsh_version;
    std::string fault; ///< empty: done
};

/// Loading gmsh takes a fifth of a second, so it stays out of the program, in a module of its own
/// that is opened on the first triangulation; this is that module's one function.
using TriangulateFunction = void (*)(const TriangulationJob&, TriangulationAnswer&);
inline constexpr const char* triangulate_symbol = "searle_triangulate";

} // namespace searle::geometry
