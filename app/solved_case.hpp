#pragma once

#include "app/case_reader.hpp"
#include "app/stage_clock.hpp"
#include "app/summary_json.hpp"
#include "rheometry/conversion/conversion.hpp"
#include "rheometry/end_effect.hpp"
#include "rheometry/rheogram.hpp"
#include "solvers/axisymmetric/section_mesh.hpp"
#include "solvers/openfoam/installation.hpp"
#include "solvers/plan.hpp"
#include "solvers/progress.hpp"
#include "solvers/radial/radial_solver.hpp"
#include "solvers/suspension/checkpoint.hpp"
#include "solvers/suspension/run_recorder.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace searle::app {

/// The case asks for an engine or a model that is not here. The program's exit code for it is 4.
struct EngineMissing : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The OpenFOAM that a case is run with. Throws EngineMissing, with the name of the package.
[[nodiscard]] solvers::openfoam::Installation installation_for(const Case& source);

/// A case with its plan, which can be solved.
struct PlannedCase {
    Case source;
    solvers::Plan plan;
    StageClock clock;
};

/// Plans a case; `clock` has timed its reading. Throws EngineMissing when this program cannot solve
/// it.
[[nodiscard]] PlannedCase plan_case(Case source, StageClock clock);

/// Where a run leaves what it can go on from.
struct RunKeeping {
    solvers::suspension::Checkpointing checkpointing; ///< of a suspension
    solvers::suspension::FrameSink frames{};          ///< of a suspension: its trajectory
    std::filesystem::path engine_folder;              ///< of engine = "openfoam": its cases
};

/// A case with what came out of it.
struct SolvedCase {
    Case source;
    solvers::Plan plan;
    solvers::radial::RadialReport solution;
    std::optional<solvers::axisymmetric::SectionDivision> division; ///< where a mesh was used
    rheometry::Conversion conversion;
    rheometry::Rheogram rheogram;
    /// Where the instrument's ends were solved: those of the rows that turn.
    std::vector<rheometry::EndEffect> ends;
    /// Of a suspension with output.fields, by row.
    std::map<std::size_t, solvers::suspension::Microstructure> structure;
    StageClock clock;
};

/// Solves and converts. When the progress sink throws solvers::Interrupted the rheogram has the
/// rows that were finished.
/// @param keeping  what keeps a long run safe, and where
[[nodiscard]] SolvedCase solve_case(PlannedCase planned, const solvers::ProgressSink& progress,
                                    const RunKeeping& keeping = {});

/// The same from an engine's folder that was run elsewhere; nothing is solved.
[[nodiscard]] SolvedCase collect_case(PlannedCase planned,
                                      const std::filesystem::path& engine_folder);

[[nodiscard]] Completeness completeness_of(const SolvedCase& solved);

/// What the user should know about the result: of the plan, of the solver, and of its completeness.
[[nodiscard]] std::vector<std::string> warnings_of(const SolvedCase& solved);

} // namespace searle::app
