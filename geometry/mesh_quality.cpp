#include "geometry/mesh_quality.hpp"

#include "geometry/cell_shapes.hpp"
#include "geometry/curved_faces.hpp"
#include "geometry/measure_allowance.hpp"
#include "geometry/mesh_faces.hpp"
#include "geometry/sweep.hpp"
#include "geometry/vector3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace searle::geometry {
namespace {

/// checkMesh's own limit of skewness. It warns of non-orthogonality from 70 deg on; near 90 deg no
/// correction of a solver's is of use any more.
constexpr double most_skewness = 4.0;
constexpr double most_non_orthogonality = 85.0;
constexpr double most_openness = 1e-6;
/// A mesh fills its outline; what is left is rounding of sums over all cells.
constexpr double most_measure_error = 1e-9;

void look_between_cells(const Mesh& mesh, const MeshFaces& faces, const CellGeometry& cells,
                        MeshQuality& quality) {
    for (const MeshFace& face : faces.inside) {
        const FaceGeometry at = face_geometry(mesh, face);
        const Point& owner = cells.centres[face.owner];
        const Point& neighbour = cells.centres[face.neighbour];
        const Point line = neighbour - owner;
        const double projected = dot(at.area, line);
        const double cosine = projected / (length(at.area) * length(line));
        const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
        quality.largest_non_orthogonality = std::max(quality.largest_non_orthogonality, angle);

        const Point to_face = at.centre - owner;
        const Point off = to_face - (dot(at.area, to_face) / projected) * line;
        const double size = length(off);
        double reference = 0.2 * length(line);
        if (size > 0.0)
            for (std::size_t corner = 0; corner < face.corner_count(); ++corner)
                reference = std::max(
                    reference,
                    std::abs(dot(off, mesh.points[face.corners[corner]] - at.centre)) / size);
        quality.largest_skewness = std::max(quality.largest_skewness, size / reference);

        const double near = std::abs(dot(at.area, to_face));
        const double far = std::abs(dot(at.area, neighbour - at.centre));
        quality.largest_growth =
            std::max(quality.largest_growth, std::max(near, far) / std::min(near, far));
    }
}

void look_at_cells(const Mesh& mesh, const CellGeometry& cells, MeshQuality& quality) {
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
        quality.least_scaled_jacobian =
            std::min(quality.least_scaled_jacobian, scaled_jacobian(mesh, cell));
        quality.largest_aspect_ratio =
            std::max(quality.largest_aspect_ratio, aspect_ratio(mesh, cell));
        quality.least_volume = std::min(quality.least_volume, cells.volumes[cell]);
        quality.inverted += cells.volumes[cell] <= 0.0;
        quality.openness = std::max(quality.openness, cells.openness[cell]);
        quality.volume.value += cells.volumes[cell];
    }
}

/// A section's neighbours are those of a slab of it, 1 m thick, in which areas are lengths.
Mesh slab_of(const Mesh& section) {
    Mesh corners = section;
    corners.cells = {};
    corners.faces = {};
    for (std::size_t cell = 0; cell < section.cells.size(); ++cell)
        corners.cells.add(straight(section.cells.shape(cell)), section.cells.corners(cell));
    for (std::size_t face = 0; face < section.faces.size(); ++face)
        corners.faces.add(CellShape::line2, section.faces.corners(face));
    return swept(corners, {.revolved = false, .extent = 1.0, .ends = Sweep::Ends::periodic});
}

double exact_or(const std::map<std::string, double>& measures, const std::string& name,
                double otherwise) {
    const auto found = measures.find(name);
    return found == measures.end() ? otherwise : found->second;
}

void compare_measures(const BuiltMesh& built, const Mesh& solid, bool is_section,
                      MeshQuality& quality) {
    const OutlineMeasures exact = built.exact();
    const OutlineMeasures expected = built.expected();
    quality.volume.name = "fluid";
    quality.volume.faces = solid.cells.size();
    quality.volume.exact = is_section ? exact.section_area : exact.volume;
    quality.volume.expected = is_section ? expected.section_area : expected.volume;
    double enclosed = 0.0;
    for (const Patch& patch : solid.patches) {
        const SurfaceMeasures surface = surface_measures_of(solid, patch);
        enclosed += surface.volume;
        const bool is_end = patch.kind == PatchKind::wedge || patch.kind == PatchKind::periodic;
        if (is_section && is_end)
            continue;
        const auto& all = is_section ? exact.patch_lengths : exact.patch_areas;
        const auto& all_expected = is_section ? expected.patch_lengths : expected.patch_areas;
        quality.areas.push_back({patch.name, patch.count, surface.area,
                                 exact_or(all, patch.name, exact.section_area),
                                 exact_or(all_expected, patch.name, expected.section_area)});
    }
    if (solid.is_second_order())
        quality.volume.value = enclosed;
}

void judge(const BuiltMesh& built, MeshQuality& quality) {
    const auto fault = [&quality](std::string text) { quality.faults.push_back(std::move(text)); };
    if (quality.inverted > 0)
        fault(fmt::format("{} cells are inverted", quality.inverted));
    if (quality.unmatched > 0)
        fault(fmt::format("{} faces have neither a neighbour nor a patch", quality.unmatched));
    if (quality.misoriented > 0)
        fault(fmt::format("{} faces look the wrong way", quality.misoriented));
    if (!(quality.openness <= most_openness))
        fault(fmt::format("a cell is open by {:.2g} of its surface", quality.openness));
    if (!(quality.least_scaled_jacobian > 0.0))
        fault(fmt::format("the least scaled Jacobian is {:.3g}", quality.least_scaled_jacobian));
    if (!(quality.largest_non_orthogonality <= most_non_orthogonality))
        fault(fmt::format("the largest non-orthogonality is {:.3g} deg",
                          quality.largest_non_orthogonality));
    if (!(quality.largest_skewness <= most_skewness))
        fault(fmt::format("the largest skewness is {:.3g}", quality.largest_skewness));
    const MeasureAllowance allowance = measure_allowance(built);
    if (!(std::abs(quality.volume.error()) <=
          most_measure_error + allowance.volume / quality.volume.exact))
        fault(fmt::format("the volume differs by {:.2g} from the closed form",
                          quality.volume.error()));
    for (const CheckedMeasure& area : quality.areas) {
        const auto found = allowance.areas.find(area.name);
        const double more = found == allowance.areas.end() ? 0.0 : found->second / area.exact;
        if (!(std::abs(area.error()) <= most_measure_error + more))
            fault(fmt::format("the area of {} differs by {:.2g} from the closed form", area.name,
                              area.error()));
    }
}

} // namespace

double CheckedMeasure::error() const { return value / expected - 1.0; }

MeshQuality quality_of(const BuiltMesh& built) {
    MeshQuality quality;
    quality.cells = built.mesh.cells.size();
    quality.points = built.mesh.points.size();
    quality.least_scaled_jacobian = quality.least_volume = std::numeric_limits<double>::infinity();
    quality.largest_growth = 1.0;
    const bool is_section = built.mesh.dimension == 2;
    const Mesh slab = is_section ? slab_of(built.mesh) : Mesh{};
    const Mesh& solid = is_section ? slab : built.mesh;
    {
        const MeshFaces faces = faces_of_cells(solid);
        quality.unmatched = faces.unmatched;
        quality.misoriented = faces.misoriented;
        const CellGeometry cells = cell_geometry(solid, faces);
        look_at_cells(solid, cells, quality);
        look_between_cells(solid, faces, cells, quality);
    }
    if (is_section) { // the slab's thickness is no edge of the section
        quality.largest_aspect_ratio = 0.0;
        for (std::size_t cell = 0; cell < built.mesh.cells.size(); ++cell)
            quality.largest_aspect_ratio =
                std::max(quality.largest_aspect_ratio, aspect_ratio(built.mesh, cell));
    }
    compare_measures(built, solid, is_section, quality);
    judge(built, quality);
    return quality;
}

} // namespace searle::geometry
