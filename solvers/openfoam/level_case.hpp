#pragma once

#include "geometry/mesh_build.hpp"
#include "solvers/openfoam/dictionaries.hpp"
#include "solvers/openfoam/level_run.hpp"
#include "solvers/openfoam/moment_file.hpp"

namespace searle::solvers::openfoam {

/// A level's mesh and the numbers that its files follow from.
class LevelCase {
public:
    explicit LevelCase(const LevelTask& task);

    [[nodiscard]] const geometry::BuiltMesh& mesh() const { return mesh_; }
    [[nodiscard]] CaseFacts facts() const {
        return {task_.scene, task_.plan, mesh_.mesh, step_, task_.coarser.filename().string()};
    }
    [[nodiscard]] LoadComponent component() const;
    /// Torque of the instrument over torque of the mesh: the one place where a slice is lifted.
    [[nodiscard]] double slice_factor() const { return mesh_.domain.slice.factor(); }
    /// Relative error of the rotor's area by chords in place of arcs.
    [[nodiscard]] double chord_error() const;
    /// The fluid's angular momentum (momentum of a box) of the whole instrument, kg m^2/s (kg m/s).
    [[nodiscard]] double momentum(const std::vector<geometry::Point>& velocity) const;

private:
    const LevelTask& task_;
    geometry::BuiltMesh mesh_;
    double step_;
};

/// Names of the files of the case that differ from what would be written, those that a user may
/// change (decomposeParDict, Allrun) and what a run changes itself left aside.
[[nodiscard]] std::vector<std::string> changed_files(const std::filesystem::path& folder,
                                                     const CaseFacts& facts);

} // namespace searle::solvers::openfoam
