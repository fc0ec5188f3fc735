#include "app/mesh_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <numbers>

namespace searle::app {
namespace {

using geometry::BuiltMesh;
using geometry::CheckedMeasure;
using geometry::MeshQuality;

std::map<std::string, std::size_t> counts_by_shape(const geometry::Mesh& mesh) {
    std::map<std::string, std::size_t> counts;
    for (const geometry::CellShape shape : mesh.cells.shapes())
        ++counts[std::string{name_of(shape)}];
    return counts;
}

std::string_view name_of_kind(geometry::PatchKind kind) {
    switch (kind) {
    case geometry::PatchKind::wall:
        return "wall";
    case geometry::PatchKind::free_surface:
        return "free surface";
    case geometry::PatchKind::axis:
        return "axis";
    case geometry::PatchKind::wedge:
        return "wedge";
    case geometry::PatchKind::periodic:
        return "periodic";
    case geometry::PatchKind::end_face:
        return "end";
    case geometry::PatchKind::flat:
        return "end, one cell high";
    }
    return "";
}

nlohmann::ordered_json as_json(const CheckedMeasure& measure) {
    return {{"value", measure.value},
            {"closed_form", measure.exact},
            {"closed_form_with_chords", measure.expected},
            {"relative_error", measure.error()},
            {"relative_difference_to_arcs", measure.value / measure.exact - 1.0}};
}

std::string row(const CheckedMeasure& measure, std::string_view kind) {
    return fmt::format("  {:<16} {:<18} {:>9} {:>13.6g} {:>13.6g} {:>9.1e} {:>9.1e}\n",
                       measure.name, kind, measure.faces, measure.value, measure.exact,
                       measure.error(), measure.value / measure.exact - 1.0);
}

} // namespace

std::string mesh_table(const BuiltMesh& built, const MeshQuality& quality) {
    const geometry::Mesh& mesh = built.mesh;
    std::string text = fmt::format("{} cells (", quality.cells);
    bool is_first = true;
    for (const auto& [shape, count] : counts_by_shape(mesh)) {
        text += fmt::format("{}{} {}", is_first ? "" : ", ", count, shape);
        is_first = false;
    }
    text += fmt::format("), {} points\n", quality.points);
    for (const std::string& note : built.notes)
        text += fmt::format("  {}\n", note);
    const bool is_section = mesh.dimension == 2;
    text +=
        fmt::format("\n  {:<16} {:<18} {:>9} {:>13} {:>13} {:>9} {:>9}\n", "name", "kind", "faces",
                    is_section ? "m^2, m" : "m^3, m^2", "closed form", "error", "to arcs");
    text += row(quality.volume, "volume");
    for (const CheckedMeasure& area : quality.areas) {
        const geometry::Patch* const patch = mesh.patch(area.name);
        text += row(area, patch == nullptr ? "" : name_of_kind(patch->kind));
    }
    text += fmt::format("\n  least scaled Jacobian     {:.4g}\n"
                        "  largest aspect ratio      {:.4g}\n"
                        "  largest non-orthogonality {:.4g} deg\n"
                        "  largest skewness          {:.4g}\n"
                        "  largest growth            {:.4g}\n"
                        "  inverted cells            {}\n"
                        "  misoriented faces         {}\n"
                        "  open faces                {}\n"
                        "  openness                  {:.2g}\n",
                        quality.least_scaled_jacobian, quality.largest_aspect_ratio,
                        quality.largest_non_orthogonality, quality.largest_skewness,
                        quality.largest_growth, quality.inverted, quality.misoriented,
                        quality.unmatched, quality.openness);
    for (const std::string& fault : quality.faults)
        text += fmt::format("  FAULT: {}\n", fault);
    return text + (quality.faults.empty() ? "  Mesh OK.\n" : "  The mesh is NOT in order.\n");
}

std::string mesh_json(const BuiltMesh& built, const MeshQuality& quality) {
    nlohmann::ordered_json json;
    json["ok"] = quality.faults.empty();
    json["faults"] = quality.faults;
    json["notes"] = built.notes;
    json["cells"] = quality.cells;
    json["cells_by_shape"] = counts_by_shape(built.mesh);
    json["points"] = quality.points;
    json["order"] = built.choices.order;
    json["angle_deg"] = built.choices.angle * 180.0 / std::numbers::pi;
    json["angular_cells"] = built.choices.angular_cells;
    json["radius_factor"] = built.choices.radius_factor;
    json["slice_factor"] = built.domain.slice.factor();
    json["volume"] = as_json(quality.volume);
    for (const CheckedMeasure& area : quality.areas) {
        json["patches"][area.name] = as_json(area);
        json["patches"][area.name]["faces"] = area.faces;
        if (const geometry::Patch* const patch = built.mesh.patch(area.name))
            json["patches"][area.name]["kind"] = name_of_kind(patch->kind);
    }
    json["least_scaled_jacobian"] = quality.least_scaled_jacobian;
    json["largest_aspect_ratio"] = quality.largest_aspect_ratio;
    json["largest_non_orthogonality_deg"] = quality.largest_non_orthogonality;
    json["largest_skewness"] = quality.largest_skewness;
    json["largest_growth"] = quality.largest_growth;
    json["least_volume"] = quality.least_volume;
    json["inverted_cells"] = quality.inverted;
    json["misoriented_faces"] = quality.misoriented;
    json["open_faces"] = quality.unmatched;
    json["openness"] = quality.openness;
    return json.dump(2) + "\n";
}

} // namespace searle::app
