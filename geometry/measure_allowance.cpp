#include "geometry/measure_allowance.hpp"

#include "geometry/cell_shapes.hpp"
#include "geometry/mesh_faces.hpp"
#include "geometry/vector3.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace searle::geometry {
namespace {

double flat_area(const Mesh& mesh, std::size_t face) {
    const auto corners = mesh.faces.corners(face);
    MeshFace flat;
    std::copy(corners.begin(), corners.end(), flat.corners.begin());
    return length(face_geometry(mesh, flat).area);
}

double radius_of(const Point& point) { return std::hypot(point.x, point.y); }

/// About the axis, 0 ... pi.
double angle_between(const Point& one, const Point& other) {
    return std::abs(
        std::atan2(one.x * other.y - one.y * other.x, one.x * other.x + one.y * other.y));
}

double sagitta_share(double angle) { return 1.0 - std::cos(0.5 * angle); }

MeasureAllowance chord_allowance(const Mesh& mesh) {
    MeasureAllowance allowance;
    for (const Patch& patch : mesh.patches) {
        double& area = allowance.areas[patch.name];
        std::map<std::array<std::uint32_t, 2>, int> edges;
        for (std::size_t face = patch.first; face < patch.first + patch.count; ++face) {
            const auto corners = mesh.faces.corners(face);
            const double size = flat_area(mesh, face);
            double angle = 0.0;
            double radius = 0.0;
            for (std::size_t at = 0; at < corners.size(); ++at) {
                const std::uint32_t one = corners[at];
                const std::uint32_t two = corners[(at + 1) % corners.size()];
                angle = std::max(angle, angle_between(mesh.points[one], mesh.points[two]));
                radius = std::max(radius, radius_of(mesh.points[one]));
                ++edges[{std::min(one, two), std::max(one, two)}];
            }
            if (patch.kind == PatchKind::periodic)
                continue;
            allowance.volume += size * radius * sagitta_share(angle);
            area += size * sagitta_share(angle);
        }
        for (const auto& [edge, count] : edges) {
            const Point& one = mesh.points[edge[0]];
            const Point& two = mesh.points[edge[1]];
            if (count == 1)
                area += length(two - one) * radius_of(one) * sagitta_share(angle_between(one, two));
        }
    }
    return allowance;
}

MeasureAllowance tip_allowance(const Mesh& mesh, double cell_angle) {
    MeasureAllowance allowance;
    for (const Patch& patch : mesh.patches) {
        double tips = 0.0;
        for (std::size_t face = patch.first; face < patch.first + patch.count; ++face) {
            const auto corners = mesh.faces.corners(face);
            if (std::any_of(corners.begin(), corners.end(), [&mesh](std::uint32_t node) {
                    return mesh.points[node].x == 0.0 && mesh.points[node].y == 0.0;
                }))
                tips += flat_area(mesh, face);
        }
        allowance.areas[patch.name] = tips * sagitta_share(cell_angle);
    }
    return allowance;
}

} // namespace

MeasureAllowance measure_allowance(const BuiltMesh& built) {
    const MeshChoices& choices = built.choices;
    if (!built.domain.revolved || choices.extent == MeshExtent::section)
        return {};
    if (choices.cells == CellStyle::tetrahedra)
        return chord_allowance(built.mesh);
    if (choices.order == 2)
        return tip_allowance(built.mesh, choices.angle / choices.angular_cells);
    return {};
}

} // namespace searle::geometry
