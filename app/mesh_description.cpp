#include "app/mesh_description.hpp"

#include "geometry/mesh_picture.hpp"
#include "geometry/mesh_quality.hpp"
#include "solvers/axisymmetric/named_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace searle::app {
namespace {

solvers::axisymmetric::SectionLines lines_of(const geometry::DinBob& bob, const MeshNote& note) {
    solvers::axisymmetric::SectionLines lines;
    if (note.lines.size() != lines.size())
        throw std::runtime_error("summary.json: the mesh has not six families of lines");
    std::copy(note.lines.begin(), note.lines.end(), lines.begin());
    for (std::size_t family = 0; family < lines.size(); ++family) {
        using enum solvers::axisymmetric::LineFamily;
        const bool is_above = family == static_cast<std::size_t>(over_bob) ||
                              family == static_cast<std::size_t>(above);
        const bool may_be_empty = is_above && bob.top_ratio == 0.0;
        if ((lines[family].size() < 2 && !(may_be_empty && lines[family].empty())) ||
            !std::is_sorted(lines[family].begin(), lines[family].end()))
            throw std::runtime_error("summary.json: the mesh's lines do not fit the bob");
    }
    return lines;
}

} // namespace

rheometry::report::MeshDescription mesh_description(const geometry::DinBob& bob,
                                                    const MeshNote& note) {
    const geometry::BuiltMesh built =
        solvers::axisymmetric::named_section(bob, lines_of(bob, note));
    const geometry::MeshQuality quality = geometry::quality_of(built);
    rheometry::report::MeshDescription description;
    description.picture = geometry::mesh_picture(built.mesh, built.domain.gap, "");
    description.caption =
        "The section of the fluid as it was divided, patches in colour. Elements shrink "
        "geometrically towards the rotor's edges, where the shear rate has no bound.";
    std::string patches;
    for (const geometry::CheckedMeasure& area : quality.areas)
        patches += fmt::format("{}{} {}", patches.empty() ? "" : ", ", area.name, area.faces);
    double worst_length = 0.0;
    for (const geometry::CheckedMeasure& area : quality.areas)
        worst_length = std::max(worst_length, std::abs(area.error()));
    description.facts = {
        {"elements", fmt::format("{} quadrilaterals with polynomials of degree {} in each "
                                 "direction",
                                 quality.cells, note.degree)},
        {"edges on patches", patches},
        {"area of the section",
         fmt::format("{:.6g} mm^2, {:.1g} off its closed form", quality.volume.value * 1e6,
                     std::abs(quality.volume.error()))},
        {"lengths of the patches",
         fmt::format("within {:.1g} of their closed forms", worst_length)},
        {"least scaled Jacobian", fmt::format("{:.3g}", quality.least_scaled_jacobian)},
        {"largest aspect ratio", fmt::format("{:.3g}", quality.largest_aspect_ratio)},
        {"largest non-orthogonality", fmt::format("{:.3g} deg", quality.largest_non_orthogonality)},
        {"largest skewness", fmt::format("{:.3g}", quality.largest_skewness)},
        {"faults",
         quality.faults.empty() ? "none" : fmt::format("{}", fmt::join(quality.faults, "; "))}};
    return description;
}

} // namespace searle::app
