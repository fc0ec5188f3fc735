#include "geometry/mesh_quality.hpp"

#include "geometry/cell_shapes.hpp"
#include "geometry/curved_faces.hpp"
#include "geometry/mesh_faces.hpp"
#include "geometry/sweep.hpp"
#include "geometry/vector3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
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

/// What the curved triangles that end on the axis may add to a patch's area, of the whole of it:
/// their segments between chord and parabola.
double tip_allowance(const BuiltMesh& built, const std::string& name) {
    const Patch* const patch = built.mesh.patch(name);
    if (built.choices.order == 1 || built.choices.angular_cells == 0 || patch == nullptr)
        return 0.0;
    double tips = 0.0;
    double all = 0.0;
    for (std::size_t face = patch->first; face < patch->first + patch->count; ++face) {
        const auto corners = built.mesh.faces.corners(face);
        MeshFace flat;
        std::copy(corners.begin(), corners.end(), flat.corners.begin());
        const double area = length(face_geometry(built.mesh, flat).area);
        const bool has_tip = std::any_of(corners.begin(), corners.end(), [&](std::uint32_t node) {
            return built.mesh.points[node].x == 0.0 && built.mesh.points[node].y == 0.0;
        });
        all += area;
        tips += has_tip ? area : 0.0;
    }
    const double cell = built.choices.angle / built.choices.angular_cells;
    return tips / all * (1.0 - std::cos(0.5 * cell));
}

/// What straight faces between points of round walls may miss.
struct ChordAllowance {
    double volume{};                     ///< m^3
    std::map<std::string, double> areas; ///< m^2, by patch
};

/// Tetrahedra have chords of all directions, so there is no closed form: between a face and its
/// wall there is at most the face's area times its sagitta, radius (1 - cos(half its angle)), and
/// beside each edge on a circle at most the edge's length times its own.
ChordAllowance chord_allowance(const Mesh& mesh) {
    ChordAllowance allowance;
    const auto angle_between = [&](std::uint32_t one, std::uint32_t two) {
        const Point& a = mesh.points[one];
        const Point& b = mesh.points[two];
        return std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y));
    };
    const auto radius_of = [&](std::uint32_t node) {
        return std::hypot(mesh.points[node].x, mesh.points[node].y);
    };
    for (const Patch& patch : mesh.patches) {
        double& area = allowance.areas[patch.name];
        std::map<std::array<std::uint32_t, 2>, int> edges;
        for (std::size_t face = patch.first; face < patch.first + patch.count; ++face) {
            const auto corners = mesh.faces.corners(face);
            MeshFace flat;
            std::copy(corners.begin(), corners.end(), flat.corners.begin());
            const double size = length(face_geometry(mesh, flat).area);
            double angle = 0.0;
            double radius = 0.0;
            for (std::size_t at = 0; at < corners.size(); ++at) {
                const std::uint32_t one = corners[at];
                const std::uint32_t two = corners[(at + 1) % corners.size()];
                angle = std::max(angle, angle_between(one, two));
                radius = std::max(radius, radius_of(one));
                ++edges[{std::min(one, two), std::max(one, two)}];
            }
            if (patch.kind == PatchKind::periodic)
                continue;
            allowance.volume += size * radius * (1.0 - std::cos(0.5 * angle));
            area += size * (1.0 - std::cos(0.5 * angle));
        }
        for (const auto& [edge, count] : edges)
            if (count == 1) {
                const double angle = angle_between(edge[0], edge[1]);
                area += length(mesh.points[edge[1]] - mesh.points[edge[0]]) * radius_of(edge[0]) *
                        (1.0 - std::cos(0.5 * angle));
            }
    }
    return allowance;
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
    const bool is_filled = built.domain.revolved && built.mesh.dimension == 3 &&
                           built.choices.cells == CellStyle::tetrahedra;
    const ChordAllowance chords = is_filled ? chord_allowance(built.mesh) : ChordAllowance{};
    const auto chord_share = [&](const CheckedMeasure& area) {
        const auto found = chords.areas.find(area.name);
        return found == chords.areas.end() ? 0.0 : found->second / area.exact;
    };
    if (!(std::abs(quality.volume.error()) <=
          most_measure_error + chords.volume / quality.volume.exact))
        fault(fmt::format("the volume differs by {:.2g} from the closed form",
                          quality.volume.error()));
    for (const CheckedMeasure& area : quality.areas)
        if (!(std::abs(area.error()) <=
              most_measure_error + tip_allowance(built, area.name) + chord_share(area)))
            fault(fmt::format("the area of {} differs by {:.2g} from the closed form", area.name,
                              area.error()));
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
