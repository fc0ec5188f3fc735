#include "solvers/openfoam/level_case.hpp"

#include "geometry/cell_shapes.hpp"
#include "geometry/mesh_faces.hpp"
#include "solvers/openfoam/case_folder.hpp"

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>

namespace searle::solvers::openfoam {
namespace {

namespace fs = std::filesystem;

geometry::MeshSubject subject_of(const Scene& scene) {
    return scene.profile ? geometry::MeshSubject{*scene.profile}
                         : geometry::subject_of(scene.instrument);
}

/// Without the lines that a run sets as it goes.
std::string settled_control(const std::string& text) {
    std::istringstream lines(text);
    std::string kept;
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("endTime ") && !line.starts_with("stopAt ") &&
            !line.starts_with("writeInterval "))
            kept += line + '\n';
    return kept;
}

} // namespace

LevelCase::LevelCase(const LevelTask& task)
    : task_(task), mesh_(geometry::build_mesh(subject_of(task.scene),
                                              mesh_settings(task.scene, task.plan, task.level))),
      step_(task.plan.steady ? 1.0 : std::ldexp(task.plan.coarsest_step, -task.level)) {}

LoadComponent LevelCase::component() const {
    return std::holds_alternative<geometry::Box>(task_.scene.instrument) ? LoadComponent::force_x
                                                                         : LoadComponent::moment_z;
}

double LevelCase::chord_error() const {
    const auto expected = mesh_.expected();
    const auto exact = mesh_.exact();
    double with_chords = 0.0;
    double with_arcs = 0.0;
    for (const std::string& name : rotor_patches(mesh_.mesh)) {
        with_chords += expected.patch_areas.at(name);
        with_arcs += exact.patch_areas.at(name);
    }
    return std::abs(with_chords / with_arcs - 1.0);
}

double LevelCase::momentum(const std::vector<geometry::Point>& velocity) const {
    const geometry::CellGeometry cells =
        geometry::cell_geometry(mesh_.mesh, geometry::faces_of_cells(mesh_.mesh));
    const bool is_box = component() == LoadComponent::force_x;
    double sum = 0.0;
    for (std::size_t cell = 0; cell < velocity.size(); ++cell) {
        const geometry::Point& at = cells.centres[cell];
        const geometry::Point& u = velocity[cell];
        sum += cells.volumes[cell] * (is_box ? u.x : at.x * u.y - at.y * u.x);
    }
    return task_.scene.fluid.density * sum * slice_factor();
}

std::vector<std::string> changed_files(const fs::path& folder, const CaseFacts& facts) {
    struct File {
        const char* name;
        std::function<std::string()> text;
    };
    const File files[] = {
        {"0/U", [&facts] { return velocity_text(facts); }},
        {"0/p", [&facts] { return pressure_text(facts); }},
        {"constant/transportProperties", [&facts] { return transport_properties(facts); }},
        {"constant/turbulenceProperties", [] { return turbulence_properties(); }},
        {"system/controlDict", [&facts] { return control_text(facts); }},
        {"system/fvSchemes", [&facts] { return schemes_text(facts); }},
        {"system/fvSolution", [&facts] { return solution_text(facts); }}};
    std::vector<std::string> changed;
    for (const File& file : files) {
        std::ifstream stream(folder / file.name, std::ios::binary);
        const std::string there{std::istreambuf_iterator<char>(stream), {}};
        if (settled_control(there) != settled_control(file.text()))
            changed.emplace_back(file.name);
    }
    std::error_code missing;
    if (!fs::exists(folder / "constant/polyMesh/points", missing))
        changed.emplace_back("constant/polyMesh");
    return changed;
}

} // namespace searle::solvers::openfoam
