#pragma once

#include <vector>

namespace searle::geometry {

/// How long cells are along a line: `start` and `end` at its ends (m, > 0), each growing inwards by
/// the factor `growth` (>= 1) a cell up to `largest`.
struct Spacing {
    double start{};
    double end{};
    double largest{};
    double growth = 1.2;
};

/// Cells that a line of this length (m) gets, at least 1. Not limited from above: a caller compares
/// it with what there is memory for before asking for the fractions.
[[nodiscard]] double graded_cell_count(double length, const Spacing& spacing);

/// Positions of the cells' ends along the line, from 0 to 1, one more than there are cells.
/// @param count  cells; the spacing's shape is kept, its sizes scale
[[nodiscard]] std::vector<double> graded_fractions(double length, const Spacing& spacing,
                                                   int count);

/// `count` cells that grow by `growth` from both ends to the middle; symmetric.
[[nodiscard]] std::vector<double> symmetric_fractions(int count, double growth);

} // namespace searle::geometry
