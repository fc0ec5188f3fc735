#include "solvers/meridional/vortex_cell.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace searle::solvers::meridional {
namespace {

using namespace axisymmetric;

std::vector<double> even_lines(double from, double length, int parts) {
    std::vector<double> lines;
    for (int k = 0; k <= parts; ++k) {
        lines.push_back(from + length * k / parts);
    }
    return lines;
}

SectionMesh rectangle(const std::vector<double>& radii, const std::vector<double>& heights) {
    const auto columns = static_cast<int>(radii.size()) - 1;
    const auto rows = static_cast<int>(heights.size()) - 1;
    const int level_edges = columns * (rows + 1);
    SectionMesh mesh;
    mesh.vertex_boundary.assign(radii.size() * heights.size(), interior_side);
    mesh.edge_boundary.assign(static_cast<std::size_t>(level_edges + rows * (columns + 1)),
                              interior_side);
    const auto vertex = [&](int i, int j) { return j * (columns + 1) + i; };
    const auto level_edge = [&](int i, int j) { return j * columns + i; };
    const auto upright_edge = [&](int i, int j) { return level_edges + j * (columns + 1) + i; };
    const auto mark = [&](int edge, int from, int to, unsigned side) {
        mesh.edge_boundary[static_cast<std::size_t>(edge)] |= side;
        mesh.vertex_boundary[static_cast<std::size_t>(from)] |= side;
        mesh.vertex_boundary[static_cast<std::size_t>(to)] |= side;
    };
    for (int i = 0; i < columns; ++i) {
        // A mirror plane stops what a flat free surface stops: flow and stress across it.
        mark(level_edge(i, 0), vertex(i, 0), vertex(i + 1, 0), free_surface);
        mark(level_edge(i, rows), vertex(i, rows), vertex(i + 1, rows), free_surface);
    }
    for (int j = 0; j < rows; ++j) {
        mark(upright_edge(0, j), vertex(0, j), vertex(0, j + 1), rotor_wall);
        mark(upright_edge(columns, j), vertex(columns, j), vertex(columns, j + 1), cup_wall);
    }
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const auto column = static_cast<std::size_t>(i);
            const auto row = static_cast<std::size_t>(j);
            mesh.elements.push_back(
                {.left = radii[column],
                 .right = radii[column + 1],
                 .bottom_left = heights[row],
                 .bottom_right = heights[row],
                 .top_left = heights[row + 1],
                 .top_right = heights[row + 1],
                 .vertex = {vertex(i, j), vertex(i + 1, j), vertex(i, j + 1), vertex(i + 1, j + 1)},
                 .edge = {level_edge(i, j), level_edge(i, j + 1), upright_edge(i, j),
                          upright_edge(i + 1, j)},
                 .family = {static_cast<std::size_t>(LineFamily::across_gap),
                            static_cast<std::size_t>(LineFamily::beside)},
                 .interval = {column, row}});
        }
    }
    return mesh;
}

} // namespace

std::unique_ptr<FlowLevel> cell_level(const VortexCell& cell, const CellResolution& resolution) {
    SectionLines lines;
    auto& radii = lines[static_cast<std::size_t>(LineFamily::across_gap)];
    auto& heights = lines[static_cast<std::size_t>(LineFamily::beside)];
    radii = even_lines(1.0, cell.gap, resolution.columns);
    heights = even_lines(0.0, cell.height, resolution.rows);
    SectionMesh mesh = rectangle(radii, heights);
    return std::make_unique<FlowLevel>(std::move(lines), std::move(mesh), resolution.degree);
}

void disturb_rotor(const VortexCell& cell, const FlowSpace& space, double disturbance,
                   FlowState& state) {
    for (int node = 0; node < space.nodes(); ++node) {
        if ((space.boundary(node) & rotor_wall) != 0U) {
            const double height = space.swirl_space().position()(node, 1);
            state.velocity(node, static_cast<Eigen::Index>(Component::rotation)) =
                1.0 + disturbance * std::cos(std::numbers::pi * height / cell.height);
        }
    }
}

double laminar_torque(const VortexCell& cell) {
    const double ratio = 1.0 + cell.gap;
    return 2.0 * cell.height / (1.0 - 1.0 / (ratio * ratio));
}

} // namespace searle::solvers::meridional
