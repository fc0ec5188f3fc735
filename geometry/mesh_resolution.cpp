#include "geometry/mesh_resolution.hpp"

#include "geometry/grading.hpp"
#include "geometry/mesh_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::geometry {
namespace {

constexpr int default_cells = 20;
/// Largest over smallest cell across a gap when the case does not ask for a growth.
constexpr double default_contrast = 4.0;
constexpr double default_growth = 1.2;
constexpr double most_contrast = 1e4;

void check_choice(double gap, const MeshSettings& settings) {
    const int given = settings.cells_across_gap.has_value() + settings.cell_size.has_value() +
                      settings.first_cell.has_value();
    if (given > 1)
        throw MeshError("the resolution is given twice: one of mesh.cells_across_gap, "
                        "mesh.cell_size and mesh.first_cell is allowed");
    if (settings.cell_size && *settings.cell_size > gap)
        throw MeshError(fmt::format("the gap of {:.6g} mm is thinner than one cell of "
                                    "mesh.cell_size = {:.6g} mm",
                                    gap * 1e3, *settings.cell_size * 1e3));
    if (settings.first_cell && *settings.first_cell > 0.5 * gap)
        throw MeshError(fmt::format("two cells of mesh.first_cell = {:.6g} mm do not fit into the "
                                    "gap of {:.6g} mm",
                                    *settings.first_cell * 1e3, gap * 1e3));
    if (settings.cell_size && settings.growth && *settings.growth > 1.0)
        throw MeshError(
            "mesh.growth has no meaning beside mesh.cell_size: all cells have one size");
}

} // namespace

int bounded_count(double cells, std::int64_t most, const char* what) {
    const double bound =
        std::min(static_cast<double>(most), static_cast<double>(std::numeric_limits<int>::max()));
    if (!(cells <= bound))
        throw MeshError(fmt::format("{:.3g} cells {} are more than mesh.most_cells = {} allows in "
                                    "the whole mesh",
                                    cells, what, most));
    return static_cast<int>(cells);
}

GapCells cells_across(double gap, const MeshSettings& settings) {
    check_choice(gap, settings);
    GapCells cells;
    if (settings.first_cell) {
        const double growth = settings.growth.value_or(default_growth);
        // The size grows within the first cell too, whose height is then as asked for.
        const double start = growth > 1.0 ? *settings.first_cell * std::log(growth) / (growth - 1.0)
                                          : *settings.first_cell;
        const Spacing spacing{start, start, gap, growth};
        const int count =
            bounded_count(graded_cell_count(gap, spacing), settings.most_cells, "across the gap");
        cells.fractions = graded_fractions(gap, spacing, count);
    } else {
        const double wanted = settings.cell_size
                                  ? std::ceil(gap / *settings.cell_size * (1 - 1e-9))
                                  : settings.cells_across_gap.value_or(default_cells);
        const int count = bounded_count(wanted, settings.most_cells, "across the gap");
        const int layers = (count - 1) / 2; // between a wall's cell and the middle's
        double growth = 1.0;
        if (settings.growth)
            growth = *settings.growth;
        else if (!settings.cell_size && layers > 0)
            growth = std::min(default_growth, std::pow(default_contrast, 1.0 / layers));
        if (layers * std::log(growth) > std::log(most_contrast))
            throw MeshError(fmt::format("mesh.growth = {:.6g} makes the cells in the middle of the "
                                        "gap more than {:g} times as large as those at the walls",
                                        growth, most_contrast));
        cells.fractions = symmetric_fractions(count, growth);
    }
    cells.wall_cell = cells.fractions[1] * gap;
    return cells;
}

Resolution resolution_for(double gap, double height, double width, const MeshSettings& settings) {
    const GapCells across = cells_across(gap, settings);
    Resolution resolution;
    const double count = static_cast<double>(across.fractions.size() - 1);
    resolution.mean_cell = gap / count;
    resolution.wall_cell = across.wall_cell;
    resolution.growth = settings.growth.value_or(settings.cell_size ? 1.05 : default_growth);
    if (settings.cell_size) {
        resolution.axial_cell = resolution.bulk_cell = *settings.cell_size;
    } else {
        // Long thin cells suit a flow that hardly varies along the gap.
        resolution.axial_cell = std::max(10.0 * resolution.mean_cell, height / (20.0 * count));
        resolution.bulk_cell = std::max(1.5 * resolution.mean_cell, 0.8 * width / count);
    }
    return resolution;
}

} // namespace searle::geometry
