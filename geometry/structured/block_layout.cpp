#include "geometry/structured/block_layout.hpp"

#include <algorithm>
#include <stdexcept>

namespace searle::geometry {
namespace {

Point on_line(const SectionPoint& from, const SectionPoint& to, double fraction) {
    return {from.r + fraction * (to.r - from.r), from.z + fraction * (to.z - from.z), 0.0};
}

/// Numbers of the nodes along each edge, ends included.
std::vector<std::vector<std::uint32_t>> add_edge_nodes(const BlockLayout& layout, Mesh& mesh) {
    for (const SectionPoint& corner : layout.corners)
        mesh.points.push_back({corner.r, corner.z, 0.0});
    std::vector<std::vector<std::uint32_t>> nodes;
    for (const BlockLayout::Edge& edge : layout.edges) {
        std::vector<std::uint32_t> along{static_cast<std::uint32_t>(edge.from)};
        const SectionPoint& from = layout.corners[static_cast<std::size_t>(edge.from)];
        const SectionPoint& to = layout.corners[static_cast<std::size_t>(edge.to)];
        for (std::size_t node = 1; node + 1 < edge.fractions.size(); ++node) {
            along.push_back(static_cast<std::uint32_t>(mesh.points.size()));
            mesh.points.push_back(on_line(from, to, edge.fractions[node]));
        }
        along.push_back(static_cast<std::uint32_t>(edge.to));
        nodes.push_back(std::move(along));
    }
    return nodes;
}

/// Fills a block: where lines that join the fractions of opposite edges cross.
void add_block(const BlockLayout& layout, const BlockLayout::Block& block,
               const std::vector<std::vector<std::uint32_t>>& edge_nodes, Mesh& mesh) {
    const auto nodes = [&](int edge) -> const auto& {
        return edge_nodes[static_cast<std::size_t>(edge)];
    };
    const auto fractions = [&](int edge) -> const auto& {
        return layout.edges[static_cast<std::size_t>(edge)].fractions;
    };
    const std::size_t columns = nodes(block.bottom).size();
    const std::size_t rows = nodes(block.left).size();
    if (nodes(block.top).size() != columns || nodes(block.right).size() != rows)
        throw std::logic_error("opposite edges of a block differ in their number of cells");
    const auto corner = [&](std::uint32_t node) { return mesh.points[node]; };
    const Point c00 = corner(nodes(block.bottom).front());
    const Point c10 = corner(nodes(block.bottom).back());
    const Point c01 = corner(nodes(block.top).front());
    const Point c11 = corner(nodes(block.top).back());
    std::vector<std::uint32_t> grid(columns * rows);
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            std::uint32_t& node = grid[row * columns + column];
            if (row == 0)
                node = nodes(block.bottom)[column];
            else if (row + 1 == rows)
                node = nodes(block.top)[column];
            else if (column == 0)
                node = nodes(block.left)[row];
            else if (column + 1 == columns)
                node = nodes(block.right)[row];
            else {
                // The parameters that the opposite edges agree on, each weighted by nearness.
                const double bottom = fractions(block.bottom)[column];
                const double top = fractions(block.top)[column];
                const double left = fractions(block.left)[row];
                const double right = fractions(block.right)[row];
                const double u =
                    (bottom + left * (top - bottom)) / (1.0 - (top - bottom) * (right - left));
                const double v = left + u * (right - left);
                const auto blend = [u, v](double p00, double p10, double p01, double p11) {
                    return (1 - v) * ((1 - u) * p00 + u * p10) + v * ((1 - u) * p01 + u * p11);
                };
                node = static_cast<std::uint32_t>(mesh.points.size());
                mesh.points.push_back(
                    {blend(c00.x, c10.x, c01.x, c11.x), blend(c00.y, c10.y, c01.y, c11.y), 0.0});
            }
        }
    }
    for (std::size_t row = 0; row + 1 < rows; ++row)
        for (std::size_t column = 0; column + 1 < columns; ++column) {
            const std::size_t at = row * columns + column;
            mesh.cells.add(
                CellShape::quadrangle4,
                std::array{grid[at], grid[at + 1], grid[at + 1 + columns], grid[at + columns]});
        }
}

/// True when the block with this edge lies to its left.
bool fluid_on_left(const BlockLayout& layout, int edge) {
    return std::any_of(layout.blocks.begin(), layout.blocks.end(), [edge](const auto& block) {
        return block.bottom == edge || block.right == edge;
    });
}

} // namespace

int BlockLayout::corner(double r, double z) {
    corners.push_back({r, z});
    return static_cast<int>(corners.size()) - 1;
}

int BlockLayout::edge(int from, int to, std::vector<double> fractions, std::string patch,
                      PatchKind kind) {
    edges.push_back({from, to, std::move(fractions), std::move(patch), kind});
    return static_cast<int>(edges.size()) - 1;
}

void BlockLayout::block(int bottom, int right, int top, int left) {
    blocks.push_back({bottom, right, top, left});
}

std::int64_t BlockLayout::cell_count() const {
    std::int64_t count = 0;
    for (const Block& block : blocks)
        count += static_cast<std::int64_t>(
                     edges[static_cast<std::size_t>(block.bottom)].fractions.size() - 1) *
                 static_cast<std::int64_t>(
                     edges[static_cast<std::size_t>(block.left)].fractions.size() - 1);
    return count;
}

Mesh section_of(const BlockLayout& layout) {
    Mesh mesh;
    mesh.dimension = 2;
    const auto edge_nodes = add_edge_nodes(layout, mesh);
    for (const BlockLayout::Block& block : layout.blocks)
        add_block(layout, block, edge_nodes, mesh);
    for (std::size_t first = 0; first < layout.edges.size(); ++first) {
        const std::string& name = layout.edges[first].patch;
        if (name.empty() || mesh.patch(name) != nullptr)
            continue;
        Patch patch{.name = name, .kind = layout.edges[first].kind, .first = mesh.faces.size()};
        for (std::size_t edge = first; edge < layout.edges.size(); ++edge) {
            if (layout.edges[edge].patch != name)
                continue;
            std::vector<std::uint32_t> nodes = edge_nodes[edge];
            if (!fluid_on_left(layout, static_cast<int>(edge)))
                std::reverse(nodes.begin(), nodes.end());
            for (std::size_t node = 0; node + 1 < nodes.size(); ++node)
                mesh.faces.add(CellShape::line2, std::array{nodes[node], nodes[node + 1]});
        }
        patch.count = mesh.faces.size() - patch.first;
        mesh.patches.push_back(std::move(patch));
    }
    return mesh;
}

} // namespace searle::geometry
