#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace searle::geometry {

/// Cells and faces, numbered as gmsh and VTK number them (corners first, then the middles of
/// edges). Orientation: the first face of a solid (the base) has its right-hand normal towards the
/// rest of the cell; a face of the boundary has its normal out of the fluid; plane cells turn
/// anticlockwise.
enum class CellShape : std::uint8_t {
    line2,
    triangle3,
    quadrangle4,
    tetrahedron4,
    pyramid5,
    prism6,
    hexahedron8,
    line3,
    triangle6,
    quadrangle8,
    tetrahedron10,
    pyramid13,
    prism15,
    hexahedron20
};

using LocalFace = std::array<std::int8_t, 4>; ///< corners of a face; the last is -1 for a triangle
using LocalEdge = std::array<std::int8_t, 2>;

[[nodiscard]] std::size_t node_count(CellShape shape);
[[nodiscard]] std::size_t corner_count(CellShape shape);
/// 1 for lines, 2 for plane cells and faces, 3 for solids.
[[nodiscard]] int dimension_of(CellShape shape);
/// The same shape with straight edges.
[[nodiscard]] CellShape straight(CellShape shape);
/// The same shape with a node in the middle of each edge.
[[nodiscard]] CellShape curved(CellShape shape);
/// Edges in the order of their middle nodes (gmsh's order).
[[nodiscard]] std::span<const LocalEdge> edges_of(CellShape shape);
/// Faces of a solid, each with its normal out of the cell.
[[nodiscard]] std::span<const LocalFace> faces_of(CellShape shape);
[[nodiscard]] std::string_view name_of(CellShape shape);

struct Point {
    double x{}, y{}, z{}; ///< m
};

/// A list of cells of mixed shapes.
class ElementList {
public:
    void add(CellShape shape, std::span<const std::uint32_t> nodes);
    void reserve(std::size_t elements, std::size_t nodes);

    [[nodiscard]] std::size_t size() const { return shapes_.size(); }
    [[nodiscard]] CellShape shape(std::size_t at) const { return shapes_[at]; }
    [[nodiscard]] std::span<const std::uint32_t> nodes(std::size_t at) const {
        return {nodes_.data() + starts_[at], starts_[at + 1] - starts_[at]};
    }
    [[nodiscard]] std::span<std::uint32_t> nodes(std::size_t at) {
        return {nodes_.data() + starts_[at], starts_[at + 1] - starts_[at]};
    }
    /// The nodes that are corners.
    [[nodiscard]] std::span<const std::uint32_t> corners(std::size_t at) const {
        return nodes(at).first(corner_count(shapes_[at]));
    }
    [[nodiscard]] std::span<const CellShape> shapes() const { return shapes_; }
    /// Where each element's nodes start in all_nodes(); one more than there are elements.
    [[nodiscard]] std::span<const std::uint64_t> starts() const { return starts_; }
    [[nodiscard]] std::span<const std::uint32_t> all_nodes() const { return nodes_; }

private:
    std::vector<CellShape> shapes_;
    std::vector<std::uint64_t> starts_{0};
    std::vector<std::uint32_t> nodes_;
};

/// What a patch is for a solver.
enum class PatchKind {
    wall,
    free_surface,
    axis,     ///< line of symmetry; only sections have it
    wedge,    ///< one side of a wedge that is one cell thick
    periodic, ///< one side of a pair whose faces follow each other in the same order
    end_face, ///< end of a slice of an endless gap, several cells away from its opposite
    flat      ///< end of a slice that is one cell high: nothing varies across it
};

/// A named part of the boundary: the faces from `first` on, `count` of them.
struct Patch {
    std::string name;
    PatchKind kind = PatchKind::wall;
    std::size_t first{};
    std::size_t count{};
    std::string partner{}; ///< of a periodic patch: the name of the other side
};

/// How a point of the front of a periodic pair reaches the back.
struct PeriodicMap {
    double angle{}; ///< turn about the z axis, rad
    Point shift{};  ///< m
};

/// Points, cells and named patches; the volume's name is always "fluid".
/// dimension 2: the meridional section, x = r and y = z (of a box: x across the gap, y the width).
/// dimension 3: z along the axis (of a box: x along the flow, y across the gap, z the width).
struct Mesh {
    int dimension = 3;
    std::vector<Point> points;
    ElementList cells;
    ElementList faces; ///< of the boundary, in the order of the patches
    std::vector<Patch> patches;
    /// Pairs of points (front, back) of the periodic patches.
    std::vector<std::array<std::uint32_t, 2>> periodic_points;
    PeriodicMap periodic_map;

    [[nodiscard]] const Patch* patch(std::string_view name) const;
    [[nodiscard]] bool is_second_order() const;
};

} // namespace searle::geometry
