#include "geometry/slice_plan.hpp"

#include <algorithm>
#include <unordered_map>

namespace searle::geometry {
namespace {

constexpr std::string_view bottom_name = "slice_bottom";

/// Nodes of the bottom, numbered anew as they are met.
class BottomNodes {
public:
    BottomNodes(const Mesh& slice, Mesh& plan) : slice_(slice), plan_(plan) {}

    std::uint32_t take(std::uint32_t node) {
        const auto [entry, is_new] =
            number_.try_emplace(node, static_cast<std::uint32_t>(plan_.points.size()));
        if (is_new)
            plan_.points.push_back(slice_.points[node]);
        return entry->second;
    }
    /// The numbers of those of the nodes that lie on the bottom.
    [[nodiscard]] std::vector<std::uint32_t> among(std::span<const std::uint32_t> nodes) const {
        std::vector<std::uint32_t> there;
        for (const std::uint32_t node : nodes)
            if (const auto entry = number_.find(node); entry != number_.end())
                there.push_back(entry->second);
        return there;
    }

private:
    const Mesh& slice_;
    Mesh& plan_;
    std::unordered_map<std::uint32_t, std::uint32_t> number_;
};

} // namespace

Mesh slice_plan(const Mesh& slice) {
    Mesh plan;
    plan.dimension = 2;
    const Patch* bottom = slice.patch(bottom_name);
    if (slice.dimension != 3 || bottom == nullptr)
        return plan;
    BottomNodes nodes(slice, plan);
    for (std::size_t face = bottom->first; face < bottom->first + bottom->count; ++face) {
        std::vector<std::uint32_t> corners;
        for (const std::uint32_t node : slice.faces.corners(face))
            corners.push_back(nodes.take(node));
        // Out of the fluid is down: from above they turn clockwise.
        std::ranges::reverse(corners);
        plan.cells.add(straight(slice.faces.shape(face)), corners);
    }
    for (const Patch& patch : slice.patches) {
        Patch line{.name = patch.name, .kind = patch.kind, .first = plan.faces.size(), .count = 0};
        for (std::size_t face = patch.first; face < patch.first + patch.count; ++face)
            if (const auto ends = nodes.among(slice.faces.corners(face)); ends.size() == 2)
                plan.faces.add(CellShape::line2, ends);
        line.count = plan.faces.size() - line.first;
        if (line.count > 0)
            plan.patches.push_back(line);
    }
    return plan;
}

} // namespace searle::geometry
