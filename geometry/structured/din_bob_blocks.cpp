#include "geometry/grading.hpp"
#include "geometry/mesh_resolution.hpp"
#include "geometry/structured/instrument_blocks.hpp"

#include <cmath>
#include <numbers>

namespace searle::geometry {
namespace {

using Fractions = std::vector<double>;

/// Gathers the blocks of one bob. Lines of the mesh leave the cone upwards or sideways, whichever
/// meets it less slantingly: under a blunt cone the blocks stand below it, beside a sharp one the
/// gap's block goes on down to the tip.
class DinBobLayout {
public:
    DinBobLayout(const DinBob& bob, const MeshSettings& settings)
        : bob_{bob}, settings_{settings}, size_{resolution_for(bob.gap(), bob.height(),
                                                               bob.bob_radius, settings)},
          across_{cells_across(bob.gap(), settings).fractions} {
        floor_centre_ = layout_.corner(0.0, floor());
        floor_rim_ = layout_.corner(bob.cup_radius, floor());
        tip_ = layout_.corner(0.0, -bob.cone_height());
        edge_ = layout_.corner(bob.bob_radius, 0.0);
        wall_ = layout_.corner(bob.cup_radius, 0.0);
        neck_ = layout_.edge(edge_, wall_, across_);
        cone_ = 0;
    }

    BlockLayout take() {
        const bool is_sharp = bob_.cone_angle < 0.5 * std::numbers::pi;
        if (is_sharp)
            add_beside_cone();
        else
            add_below_cone();
        add_gap();
        return std::move(layout_);
    }

private:
    [[nodiscard]] double floor() const { return -bob_.bottom_ratio * bob_.bob_radius; }

    [[nodiscard]] Fractions graded(double length, double start, double end, double largest,
                                   const char* what) const {
        const Spacing spacing{start, end, largest, size_.growth};
        const int count =
            bounded_count(graded_cell_count(length, spacing), settings_.most_cells, what);
        return graded_fractions(length, spacing, count);
    }

    void add_below_cone() {
        const int floor_edge = layout_.corner(bob_.bob_radius, floor());
        const Fractions under = graded(bob_.bob_radius, size_.bulk_cell, size_.wall_cell,
                                       size_.bulk_cell, "under the bob");
        const Fractions below = graded(-floor(), size_.bulk_cell, size_.wall_cell, size_.bulk_cell,
                                       "between floor and bob");
        const int inner_floor = layout_.edge(floor_centre_, floor_edge, under, "cup_floor");
        const int outer_floor = layout_.edge(floor_edge, floor_rim_, across_, "cup_floor");
        const int axis = layout_.edge(floor_centre_, tip_, below, "axis", PatchKind::axis);
        const int inside = layout_.edge(floor_edge, edge_, below);
        const int cup = layout_.edge(floor_rim_, wall_, below, "cup");
        cone_ = layout_.edge(tip_, edge_, under, "bob_cone");
        layout_.block(inner_floor, inside, cone_, axis);
        layout_.block(outer_floor, cup, neck_, inside);
    }

    void add_beside_cone() {
        const int level = layout_.corner(bob_.cup_radius, -bob_.cone_height());
        const double slant = std::hypot(bob_.bob_radius, bob_.cone_height());
        const Fractions below = graded(bob_.tip_clearance(), size_.bulk_cell, size_.bulk_cell,
                                       size_.bulk_cell, "between floor and bob");
        const Fractions beside =
            graded(slant, size_.bulk_cell, size_.wall_cell, size_.bulk_cell, "along the cone");
        const int bottom = layout_.edge(floor_centre_, floor_rim_, across_, "cup_floor");
        const int axis = layout_.edge(floor_centre_, tip_, below, "axis", PatchKind::axis);
        const int lower_cup = layout_.edge(floor_rim_, level, below, "cup");
        const int inside = layout_.edge(tip_, level, across_);
        cone_ = layout_.edge(tip_, edge_, beside, "bob_cone");
        const int upper_cup = layout_.edge(level, wall_, beside, "cup");
        layout_.block(bottom, lower_cup, inside, axis);
        layout_.block(inside, upper_cup, neck_, cone_);
    }

    void add_gap() {
        const double height = bob_.height();
        const Spacing along{size_.wall_cell,
                            bob_.top_ratio > 0 ? size_.wall_cell : size_.axial_cell,
                            size_.axial_cell, size_.growth};
        const int rows = settings_.axial_cells.value_or(bounded_count(
            graded_cell_count(height, along), settings_.most_cells, "along the cylinder"));
        const Fractions axial = graded_fractions(height, along, rows);
        const int shoulder = layout_.corner(bob_.bob_radius, height);
        const int beside = layout_.corner(bob_.cup_radius, height);
        const int bob = layout_.edge(edge_, shoulder, axial, "bob");
        const int cup = layout_.edge(wall_, beside, axial, "cup");
        if (bob_.top_ratio > 0.0) {
            const int top = layout_.edge(shoulder, beside, across_);
            layout_.block(neck_, cup, top, bob);
            add_above(shoulder, beside, top);
        } else {
            const int top =
                layout_.edge(shoulder, beside, across_, "free_surface", PatchKind::free_surface);
            layout_.block(neck_, cup, top, bob);
        }
    }

    void add_above(int shoulder, int beside, int gap_top) {
        const double above = bob_.top_ratio * bob_.bob_radius;
        const double level = bob_.height() + above;
        const double shaft_radius = bob_.shaft_ratio * bob_.bob_radius;
        const Fractions up =
            graded(above, size_.wall_cell, size_.bulk_cell, size_.bulk_cell, "above the bob");
        const Fractions inwards = graded(bob_.bob_radius - shaft_radius, size_.bulk_cell,
                                         size_.wall_cell, size_.bulk_cell, "above the bob");
        const int shaft_foot = layout_.corner(shaft_radius, bob_.height());
        const int shaft_top = layout_.corner(shaft_radius, level);
        const int middle_top = layout_.corner(bob_.bob_radius, level);
        const int rim = layout_.corner(bob_.cup_radius, level);
        const int bob_top = layout_.edge(shaft_foot, shoulder, inwards, "bob_top");
        const int shaft = layout_.edge(shaft_foot, shaft_top, up, "shaft");
        const int inside = layout_.edge(shoulder, middle_top, up);
        const int cup = layout_.edge(beside, rim, up, "cup");
        const auto surface = PatchKind::free_surface;
        const int inner = layout_.edge(shaft_top, middle_top, inwards, "free_surface", surface);
        const int outer = layout_.edge(middle_top, rim, across_, "free_surface", surface);
        layout_.block(bob_top, inside, inner, shaft);
        layout_.block(gap_top, cup, outer, inside);
    }

    const DinBob& bob_;
    const MeshSettings& settings_;
    Resolution size_;
    Fractions across_;
    BlockLayout layout_;
    int floor_centre_{};
    int floor_rim_{};
    int tip_{};
    int edge_{};
    int wall_{};
    int neck_{};
    int cone_{};
};

} // namespace

BlockLayout din_bob_blocks(const DinBob& bob, const MeshSettings& settings) {
    return DinBobLayout{bob, settings}.take();
}

} // namespace searle::geometry
