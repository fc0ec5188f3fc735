#include "geometry/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace searle::geometry {
namespace {

using Node = std::uint32_t;

class Sweeper {
public:
    Sweeper(const Mesh& section, const Sweep& sweep) : section_{section}, sweep_{sweep} {
        solid_.dimension = 3;
        place_points();
    }

    Mesh take() {
        const std::size_t cells = section_.cells.size() * static_cast<std::size_t>(sweep_.cells);
        solid_.cells.reserve(cells, 8 * cells);
        for (int layer = 0; layer < sweep_.cells; ++layer)
            for (std::size_t cell = 0; cell < section_.cells.size(); ++cell)
                add_cell(section_.cells.corners(cell), layer);
        for (const Patch& patch : section_.patches)
            add_side(patch);
        if (sweep_.ends != Sweep::Ends::closed) {
            const bool is_wedge = sweep_.ends == Sweep::Ends::wedge;
            add_end(is_wedge ? "wedge_front" : "periodic_front", 0);
            add_end(is_wedge ? "wedge_back" : "periodic_back", sweep_.cells);
            pair_ends(is_wedge);
        }
        return std::move(solid_);
    }

private:
    [[nodiscard]] bool on_axis(Node node) const {
        return sweep_.revolved && section_.points[node].x == 0.0;
    }

    [[nodiscard]] Point placed(const Point& point, int layer) const {
        const double part = sweep_.extent * layer / sweep_.cells;
        if (!sweep_.revolved) // backwards, so that a section's normal looks back on both sweeps
            return {sweep_.extent - part, point.x, point.y};
        const double angle = sweep_.ends == Sweep::Ends::closed ? part : part - 0.5 * sweep_.extent;
        const double radius = point.x * sweep_.radius_factor;
        return {radius * std::cos(angle), radius * std::sin(angle), point.y};
    }

    /// First the axis, then layer by layer what is not on it.
    void place_points() {
        rank_.resize(section_.points.size());
        Node axis = 0;
        Node swept = 0;
        for (Node node = 0; node < section_.points.size(); ++node)
            rank_[node] = on_axis(node) ? axis++ : swept++;
        axis_count_ = axis;
        layer_count_ = swept;
        const bool is_closed = sweep_.ends == Sweep::Ends::closed;
        const int layers = is_closed ? sweep_.cells : sweep_.cells + 1;
        solid_.points.resize(axis +
                             static_cast<std::size_t>(swept) * static_cast<std::size_t>(layers));
        for (Node node = 0; node < section_.points.size(); ++node) {
            if (on_axis(node)) {
                solid_.points[rank_[node]] = {0.0, 0.0, section_.points[node].y};
                continue;
            }
            for (int layer = 0; layer < layers; ++layer)
                solid_.points[node_at(node, layer)] = placed(section_.points[node], layer);
        }
    }

    [[nodiscard]] Node node_at(Node node, int layer) const {
        if (on_axis(node))
            return rank_[node];
        if (sweep_.ends == Sweep::Ends::closed)
            layer %= sweep_.cells;
        return axis_count_ + static_cast<Node>(layer) * layer_count_ + rank_[node];
    }

    void add_cell(std::span<const Node> corners, int layer) {
        // An anticlockwise section has its normal against the sweep, so the base is the far layer.
        const auto far = [&](std::size_t at) {
            return node_at(corners[at % corners.size()], layer + 1);
        };
        const auto near = [&](std::size_t at) {
            return node_at(corners[at % corners.size()], layer);
        };
        const auto axial = [&](std::size_t at) { return on_axis(corners[at % corners.size()]); };
        std::size_t count = 0;
        std::size_t first = 0; // the first of the axis corners, which follow each other
        for (std::size_t at = 0; at < corners.size(); ++at) {
            if (!axial(at))
                continue;
            ++count;
            if (!axial(at + corners.size() - 1))
                first = at;
        }
        ElementList& cells = solid_.cells;
        if (corners.size() == 4 && count == 0)
            cells.add(CellShape::hexahedron8, std::array{far(0), far(1), far(2), far(3), near(0),
                                                         near(1), near(2), near(3)});
        else if (corners.size() == 4 && count == 2) {
            const std::size_t a = first; // a, b = a + 1 on the axis, then c and d off it
            cells.add(CellShape::prism6, std::array{far(a), far(a + 3), near(a + 3), far(a + 1),
                                                    far(a + 2), near(a + 2)});
        } else if (corners.size() == 3 && count == 0)
            cells.add(CellShape::prism6,
                      std::array{far(0), far(1), far(2), near(0), near(1), near(2)});
        else if (corners.size() == 3 && count == 1)
            cells.add(CellShape::pyramid5, std::array{far(first + 1), near(first + 1),
                                                      near(first + 2), far(first + 2), far(first)});
        else if (corners.size() == 3 && count == 2)
            cells.add(CellShape::tetrahedron4,
                      std::array{far(first), far(first + 1), far(first + 2), near(first + 2)});
        else
            throw std::logic_error("a plane cell touches the axis in a corner only");
    }

    void add_side(const Patch& patch) {
        Patch side{.name = patch.name, .kind = patch.kind, .first = solid_.faces.size()};
        for (int layer = 0; layer < sweep_.cells; ++layer)
            for (std::size_t edge = patch.first; edge < patch.first + patch.count; ++edge) {
                const Node from = section_.faces.nodes(edge)[0];
                const Node to = section_.faces.nodes(edge)[1];
                if (on_axis(from) && on_axis(to))
                    continue;
                if (on_axis(from))
                    solid_.faces.add(CellShape::triangle3,
                                     std::array{node_at(from, layer), node_at(to, layer + 1),
                                                node_at(to, layer)});
                else if (on_axis(to))
                    solid_.faces.add(CellShape::triangle3,
                                     std::array{node_at(from, layer), node_at(from, layer + 1),
                                                node_at(to, layer)});
                else
                    solid_.faces.add(CellShape::quadrangle4,
                                     std::array{node_at(from, layer), node_at(from, layer + 1),
                                                node_at(to, layer + 1), node_at(to, layer)});
            }
        side.count = solid_.faces.size() - side.first;
        if (side.count > 0)
            solid_.patches.push_back(std::move(side));
    }

    void add_end(const char* name, int layer) {
        Patch end{.name = name, .first = solid_.faces.size()};
        for (std::size_t cell = 0; cell < section_.cells.size(); ++cell) {
            std::vector<Node> nodes;
            for (const Node node : section_.cells.corners(cell))
                nodes.push_back(node_at(node, layer));
            // Same first corner on both ends, so that the faces of a pair match corner by corner.
            if (layer != 0)
                std::reverse(nodes.begin() + 1, nodes.end());
            solid_.faces.add(section_.cells.shape(cell), nodes);
        }
        end.count = solid_.faces.size() - end.first;
        solid_.patches.push_back(std::move(end));
    }

    void pair_ends(bool is_wedge) {
        Patch& front = solid_.patches[solid_.patches.size() - 2];
        Patch& back = solid_.patches.back();
        front.kind = back.kind = is_wedge ? PatchKind::wedge : PatchKind::periodic;
        if (is_wedge)
            return;
        front.partner = back.name;
        back.partner = front.name;
        if (sweep_.revolved)
            solid_.periodic_map.angle = sweep_.extent;
        else
            solid_.periodic_map.shift = {-sweep_.extent, 0.0, 0.0};
        for (Node node = 0; node < section_.points.size(); ++node)
            solid_.periodic_points.push_back({node_at(node, 0), node_at(node, sweep_.cells)});
    }

    const Mesh& section_;
    const Sweep& sweep_;
    Mesh solid_;
    std::vector<Node> rank_; ///< of a section's node among those on or off the axis
    Node axis_count_ = 0;
    Node layer_count_ = 0;
};

} // namespace

Mesh swept(const Mesh& section, const Sweep& sweep) { return Sweeper{section, sweep}.take(); }

Mesh with_triangles_at_axis_corners(const Mesh& section) {
    Mesh result = section;
    result.cells = {};
    result.cells.reserve(section.cells.size(), 4 * section.cells.size());
    for (std::size_t cell = 0; cell < section.cells.size(); ++cell) {
        const auto nodes = section.cells.corners(cell);
        const auto axial = [&](std::size_t at) { return section.points[nodes[at % 4]].x == 0.0; };
        std::size_t count = 0;
        std::size_t corner = 0;
        for (std::size_t at = 0; at < nodes.size(); ++at)
            if (axial(at)) {
                ++count;
                corner = at;
            }
        if (nodes.size() != 4 || count != 1) {
            result.cells.add(section.cells.shape(cell), nodes);
            continue;
        }
        const auto node = [&](std::size_t after) { return nodes[(corner + after) % 4]; };
        result.cells.add(CellShape::triangle3, std::array{node(0), node(1), node(3)});
        result.cells.add(CellShape::triangle3, std::array{node(1), node(2), node(3)});
    }
    return result;
}

} // namespace searle::geometry
