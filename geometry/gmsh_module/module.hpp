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

/// A second question: tetrahedra in the solid that one outline sweeps.
struct FillingJob {
    const Outline* outline = nullptr;
    std::function<double(const SectionPoint&)> size_at; ///< m
    bool revolved = true; ///< about the z axis from -extent/2; false: along x, from extent to 0
    double extent{};      ///< rad or m
    bool closed = false;  ///< a full turn
};

/// Its answer. Points on the outline's edges and on both ends are where gmsh's geometry has them:
/// close to the exact place.
struct FillingAnswer {
    using Triangles = std::vector<std::array<std::uint32_t, 3>>;
    std::vector<Point> points;
    std::vector<std::array<std::uint32_t, 4>> tetrahedra;
    std::vector<Triangles> edge_faces; ///< by edge of the outline
    Triangles front;
    std::vector<std::array<std::uint32_t, 2>> pairs; ///< front and back
    std::string fault;                               ///< empty: done
};

/// Loading gmsh takes a fifth of a second, so it stays out of the program, in a module of its own
/// that is opened when it is first asked; these are that module's functions.
using TriangulateFunction = void (*)(const TriangulationJob&, TriangulationAnswer&);
inline constexpr const char* triangulate_symbol = "searle_triangulate";
using FillFunction = void (*)(const FillingJob&, FillingAnswer&);
inline constexpr const char* fill_symbol = "searle_fill";

/// Inside the module: gmsh is initialised once for the process.
void initialise_gmsh();

} // namespace searle::geometry
