#pragma once

#include "geometry/outline.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace searle::geometry {

/// A section cut into four-sided blocks that meet edge to edge, each filled with a grid of
/// quadrangles.
struct BlockLayout {
    struct Edge {
        int from{};
        int to{};
        std::vector<double> fractions; ///< positions of the nodes along it, 0 to 1
        std::string patch{};           ///< empty: inside the fluid
        PatchKind kind = PatchKind::wall;
    };
    /// Indices of edges; opposite edges have the same direction and the same number of nodes:
    /// bottom and top from left to right, left and right from bottom to top.
    struct Block {
        int bottom{};
        int right{};
        int top{};
        int left{};
    };

    std::vector<SectionPoint> corners;
    std::vector<Edge> edges;
    std::vector<Block> blocks;

    int corner(double r, double z);
    int edge(int from, int to, std::vector<double> fractions, std::string patch = "",
             PatchKind kind = PatchKind::wall);
    void block(int bottom, int right, int top, int left);

    [[nodiscard]] std::int64_t cell_count() const;
};

/// The section as a plane mesh (x = r, y = z), patches in the order of their first edge.
/// Each block's inside is interpolated from its four edges.
[[nodiscard]] Mesh section_of(const BlockLayout& layout);

} // namespace searle::geometry
