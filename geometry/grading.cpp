#include "geometry/grading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace searle::geometry {
namespace {

/// The cell size along a line is piecewise linear; a mesh line lies wherever the integral of
/// 1 / size is a whole number.
struct Piece {
    double from{}; ///< m along the line
    double to{};
    double size{};  ///< at `from`, m
    double slope{}; ///< of the size

    [[nodiscard]] double cells() const {
        const double length = to - from;
        const double change = slope * length / size;
        if (std::abs(change) < 1e-9)
            return length / size;
        return std::log1p(change) / slope;
    }
    /// Where `cells` cells from `from` end.
    [[nodiscard]] double position(double cells) const {
        if (std::abs(slope * cells) < 1e-12)
            return from + size * cells;
        return from + size * std::expm1(slope * cells) / slope;
    }
};

std::array<Piece, 3> pieces_of(double length, const Spacing& spacing) {
    const double slope = std::max(0.0, std::log(spacing.growth));
    const double largest = std::max({spacing.largest, spacing.start, spacing.end});
    if (slope == 0.0) {
        // Without growth the ends' sizes hold on either side of the middle.
        const double half = 0.5 * length;
        return {Piece{0.0, half, spacing.start, 0.0}, Piece{half, half, spacing.start, 0.0},
                Piece{half, length, spacing.end, 0.0}};
    }
    double rise_end = (largest - spacing.start) / slope;
    double fall_start = length - (largest - spacing.end) / slope;
    if (rise_end > fall_start) {
        const double meeting = 0.5 * (length + (spacing.end - spacing.start) / slope);
        rise_end = fall_start = std::clamp(meeting, 0.0, length);
    }
    const double top = spacing.start + slope * rise_end;
    const double fall_top = spacing.end + slope * (length - fall_start);
    return {Piece{0.0, rise_end, spacing.start, slope}, Piece{rise_end, fall_start, top, 0.0},
            Piece{fall_start, length, fall_top, -slope}};
}

double total_cells(const std::array<Piece, 3>& pieces) {
    double total = 0.0;
    for (const Piece& piece : pieces)
        total += piece.cells();
    return total;
}

} // namespace

double graded_cell_count(double length, const Spacing& spacing) {
    // A hair below a whole number is that number.
    return std::max(1.0, std::ceil(total_cells(pieces_of(length, spacing)) - 1e-6));
}

std::vector<double> graded_fractions(double length, const Spacing& spacing, int count) {
    const std::array<Piece, 3> pieces = pieces_of(length, spacing);
    const double scale = total_cells(pieces) / count;
    std::vector<double> fractions(static_cast<std::size_t>(count) + 1);
    std::size_t at = 0;
    double before = 0.0;
    for (std::size_t line = 1; line + 1 < fractions.size(); ++line) {
        const double wanted = scale * static_cast<double>(line);
        while (at + 1 < pieces.size() && wanted > before + pieces[at].cells())
            before += pieces[at++].cells();
        fractions[line] = pieces[at].position(wanted - before) / length;
    }
    fractions.back() = 1.0;
    return fractions;
}

std::vector<double> symmetric_fractions(int count, double growth) {
    std::vector<double> fractions(static_cast<std::size_t>(count) + 1);
    for (int cell = 0; cell < count; ++cell)
        fractions[static_cast<std::size_t>(cell) + 1] =
            fractions[static_cast<std::size_t>(cell)] +
            std::pow(growth, std::min(cell, count - 1 - cell));
    const double total = fractions.back();
    for (double& fraction : fractions)
        fraction /= total;
    fractions.back() = 1.0;
    return fractions;
}

} // namespace searle::geometry
