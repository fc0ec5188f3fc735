#include "geometry/profile_outline.hpp"

#include "geometry/mesh_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace searle::geometry {
namespace {

std::string at(const ProfilePoint& point) {
    return fmt::format("(r, z) = ({:.6g}, {:.6g}) mm", point.r * 1e3, point.z * 1e3);
}

OutlineEdge edge_after(const ProfilePoint& point, std::size_t number, bool is_rotor) {
    const char* part = is_rotor ? "rotor" : "cup";
    return {point.patch.empty() ? (is_rotor ? "bob" : "cup") : point.patch, PatchKind::wall,
            fmt::format("edge {} of the {}", number, part)};
}

void check_ends(const Profile& profile) {
    const ProfilePoint& rotor_end = profile.rotor.back();
    const ProfilePoint& cup_end = profile.cup.back();
    if (rotor_end.z != cup_end.z)
        throw MeshError(fmt::format("the free surface is not level: geometry.rotor ends at {} and "
                                    "geometry.cup at {}; both must end at the liquid's height",
                                    at(rotor_end), at(cup_end)));
    const ProfilePoint& rotor_start = profile.rotor.front();
    const ProfilePoint& cup_start = profile.cup.front();
    const bool on_axis = rotor_start.r == 0.0 && cup_start.r == 0.0;
    if (!on_axis && rotor_start.z != cup_start.z)
        throw MeshError(fmt::format("geometry.rotor starts at {} and geometry.cup at {}: both must "
                                    "start on the axis, or both at the same height",
                                    at(rotor_start), at(cup_start)));
    double lowest = rotor_start.z;
    for (const ProfilePoint& point : profile.rotor)
        lowest = std::min(lowest, point.z);
    if (!(rotor_end.z > lowest))
        throw MeshError(fmt::format("the liquid's level, z = {:.6g} mm, is below the rotor",
                                    rotor_end.z * 1e3));
}

} // namespace

Outline outline_of(const Profile& profile) {
    if (profile.rotor.size() < 2 || profile.cup.size() < 2)
        throw MeshError("geometry.rotor and geometry.cup need at least two points each");
    check_ends(profile);
    Outline outline;
    const auto& rotor = profile.rotor;
    const auto& cup = profile.cup;
    for (std::size_t point = 0; point < cup.size(); ++point) {
        outline.points.push_back({cup[point].r, cup[point].z});
        if (point + 1 < cup.size())
            outline.edges.push_back(edge_after(cup[point], point + 1, false));
    }
    outline.edges.push_back({"free_surface", PatchKind::free_surface, "the free surface"});
    for (std::size_t point = rotor.size(); point-- > 0;) {
        outline.points.push_back({rotor[point].r, rotor[point].z});
        if (point > 0)
            outline.edges.push_back(edge_after(rotor[point - 1], point, true));
    }
    if (cup.front().r == 0.0 && rotor.front().r == 0.0)
        outline.edges.push_back({"axis", PatchKind::axis, "the axis"});
    else
        outline.edges.push_back({"slice_bottom", PatchKind::end_face, "the lower end"});
    return outline;
}

ConcentricCylinders nominal_cylinders(const Profile& profile) {
    const auto narrower = [](const ProfilePoint& one, const ProfilePoint& other) {
        return one.r < other.r;
    };
    const auto widest = [&](const std::vector<ProfilePoint>& points) {
        const auto found = std::max_element(points.begin(), points.end(), narrower);
        return found == points.end() ? 0.0 : found->r;
    };
    ConcentricCylinders cylinders{widest(profile.rotor), widest(profile.cup), 0.0};
    for (std::size_t at = 0; at + 1 < profile.rotor.size(); ++at)
        if (profile.rotor[at].r == cylinders.bob_radius &&
            profile.rotor[at + 1].r == cylinders.bob_radius)
            cylinders.height += std::abs(profile.rotor[at + 1].z - profile.rotor[at].z);
    if (cylinders.height == 0.0 && !profile.rotor.empty())
        cylinders.height = std::abs(profile.rotor.back().z - profile.rotor.front().z);
    return cylinders;
}

} // namespace searle::geometry
