#include "geometry/power_cells.hpp"

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace searle::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Vertex =
    CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel,
                                                CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
/// A tetrahedron keeps its corner of the power diagram once that is known.
using Cell =
    CGAL::Triangulation_cell_base_with_info_3<std::optional<Point>, Kernel,
                                              CGAL::Regular_triangulation_cell_base_3<Kernel>>;
using Triangulation =
    CGAL::Regular_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;

/// Volume over longest edge cubed below which a corner is computed in rational numbers: in lattices
/// rounded coordinates leave tetrahedra that are as good as flat.
constexpr double flat = 1e-6;

/// The point of equal power to a tetrahedron's four spheres.
const Point& corner_of(const Triangulation& triangulation, Triangulation::Cell_handle cell) {
    std::optional<Point>& corner = cell->info();
    if (corner)
        return *corner;
    const Point& first = cell->vertex(0)->point().point();
    Vector edges[3];
    double longest = 0.0;
    for (int k = 0; k < 3; ++k) {
        edges[k] = cell->vertex(k + 1)->point().point() - first;
        longest = std::max(longest, edges[k].squared_length());
    }
    const double sixfold = CGAL::cross_product(edges[0], edges[1]) * edges[2];
    if (std::abs(sixfold) > flat * longest * std::sqrt(longest)) {
        corner = triangulation.dual(cell);
    } else {
        const CGAL::Cartesian_converter<Kernel, Exact> exactly;
        const auto found = Exact().construct_weighted_circumcenter_3_object()(
            exactly(cell->vertex(0)->point()), exactly(cell->vertex(1)->point()),
            exactly(cell->vertex(2)->point()), exactly(cell->vertex(3)->point()));
        corner = Point(CGAL::to_double(found.x()), CGAL::to_double(found.y()),
                       CGAL::to_double(found.z()));
    }
    return *corner;
}

/// The part of the first end's cell that the face between both ends cuts off: a pyramid over the
/// face, negative where its apex lies beyond. Infinite where the face is open.
double pyramid(const Triangulation& triangulation, const Triangulation::Edge& edge,
               Triangulation::Vertex_handle centre, double& furthest) {
    const auto one = edge.first->vertex(edge.second);
    const auto other = one == centre ? edge.first->vertex(edge.third) : one;
    const Point& from = centre->point().point();
    const Vector between = other->point().point() - from;
    Vector area(0.0, 0.0, 0.0);
    Vector first(0.0, 0.0, 0.0);
    Vector before(0.0, 0.0, 0.0);
    int corners = 0;
    const auto begin = triangulation.incident_cells(edge);
    auto cell = begin;
    do {
        if (triangulation.is_infinite(cell))
            return std::numeric_limits<double>::infinity();
        const Vector corner = corner_of(triangulation, cell) - from;
        furthest = std::max(furthest, corner.squared_length());
        if (corners == 0)
            first = corner;
        else
            area = area + CGAL::cross_product(before - first, corner - first);
        before = corner;
        ++corners;
    } while (++cell != begin);
    const double distance = std::sqrt(between.squared_length());
    const double height =
        0.5 * (between.squared_length() + centre->point().weight() - other->point().weight()) /
        distance;
    return 0.5 * std::abs(area * between) / distance * height / 3.0;
}

} // namespace

PowerCells power_cells(std::span<const Sphere> spheres, std::size_t count) {
    std::vector<std::pair<Triangulation::Weighted_point, std::size_t>> sites;
    sites.reserve(spheres.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const Sphere& it = spheres[i];
        sites.emplace_back(
            Triangulation::Weighted_point(Point(it.x, it.y, it.z), it.radius * it.radius), i);
        largest = std::max(largest, it.radius);
    }
    const Triangulation triangulation(sites.begin(), sites.end());
    PowerCells cells{.volume = std::vector<double>(count, 0.0)};
    std::vector<Triangulation::Edge> edges;
    for (const auto vertex : triangulation.finite_vertex_handles()) {
        const std::size_t number = vertex->info();
        if (number >= count)
            continue;
        edges.clear();
        double furthest = 0.0; // squared
        double& volume = cells.volume[number];
        if (triangulation.dimension() == 3)
            triangulation.finite_incident_edges(vertex, std::back_inserter(edges));
        else
            volume = std::numeric_limits<double>::infinity();
        for (const Triangulation::Edge& edge : edges)
            volume += pyramid(triangulation, edge, vertex, furthest);
        const double power = furthest - vertex->point().weight() + largest * largest;
        cells.reach =
            std::max(cells.reach, std::isfinite(volume) ? std::sqrt(furthest) + std::sqrt(power)
                                                        : std::numeric_limits<double>::infinity());
    }
    return cells;
}

} // namespace searle::geometry
