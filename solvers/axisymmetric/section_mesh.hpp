#pragma once

#include "solvers/axisymmetric/section_shape.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace searle::solvers::axisymmetric {

/// What a side of the section is made of; a bit mask, since a corner belongs to two sides.
enum Boundary : unsigned {
    interior_side = 0,
    rotor_wall = 1,    ///< cone, cylinder, top face and shaft
    cup_wall = 2,      ///< floor and wall
    free_surface = 4,  ///< no stress
    symmetry_axis = 8, ///< r = 0
    inner_surface = 16 ///< no stress; inside the rotor of a double gap
};

/// A quadrilateral with two vertical sides: r runs from left to right, z is linear along each side.
/// Lengths in units of the shape; z = 0 is the lower edge of the cylinder, as in geometry::DinBob.
struct SectionElement {
    double left{};
    double right{};
    double bottom_left{};
    double bottom_right{};
    double top_left{};
    double top_right{};
    std::array<int, 4> vertex{}; ///< bottom left, bottom right, top left, top right
    std::array<int, 4> edge{};   ///< bottom, top (r grows along both), left, right (z grows)
    /// Families of the vertical and of the other lines around it, and its interval in each.
    std::array<std::size_t, 2> family{};
    std::array<std::size_t, 2> interval{};
};

/// Half of the section that the fluid fills, r >= 0, as conforming quadrilaterals. Two elements
/// that share an edge run along it in the same direction.
struct SectionMesh {
    std::vector<SectionElement> elements;
    std::vector<unsigned> vertex_boundary; ///< Boundary bits of each vertex
    std::vector<unsigned> edge_boundary;   ///< Boundary bits of each edge
};

/// The six families of lines that divide a section; lengths in units of the shape, increasing. In a
/// double gap the rotor's lower end is under_bob, and the inner gap over_bob.
enum class LineFamily {
    under_bob,  ///< r from the axis to the edge of the cylinder, below it
    across_gap, ///< r from the cylinder to the cup
    over_bob,   ///< r from the shaft to the edge of the cylinder, above it
    below,      ///< share of the height between the floor (0) and the bob or z = 0 (1)
    beside,     ///< z along the cylinder
    above       ///< z from the top face to the free surface
};
constexpr std::size_t line_families = 6;

/// Without fluid above the bob the families over_bob and above are empty; above in a double gap.
using SectionLines = std::array<std::vector<double>, line_families>;

/// Which intervals between lines are to be cut.
using LineMarks = std::array<std::vector<bool>, line_families>;

/// How a section is divided at first. Elements shrink by a constant factor towards the walls of the
/// rotor, so that they are small at both edges of the cylinder, where the gradient is infinite.
struct Grading {
    double smallest = 1e-2; ///< size next to the rotor over the width of the gap, > 0
    double ratio = 0.15;    ///< size of an element over that of its larger neighbour, 0 < ratio < 1
};

[[nodiscard]] SectionLines graded_lines(const SectionShape& shape, const Grading& grading);

/// The lines with the marked intervals cut: in two halves, or next to a wall of the rotor near it,
/// at the share `ratio` of the interval.
[[nodiscard]] SectionLines refined(const SectionLines& lines, const LineMarks& marks, double ratio);

/// The elements between the lines.
[[nodiscard]] SectionMesh section_of(const SectionShape& shape, const SectionLines& lines);

} // namespace searle::solvers::axisymmetric
