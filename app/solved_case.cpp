#include "app/solved_case.hpp"

#include "solvers/meridional/bob_solver.hpp"
#include "solvers/meridional/vortex_solver.hpp"
#include "solvers/openfoam/openfoam_solver.hpp"
#include "solvers/suspension/suspension_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::app {
namespace {

/// Regime of each row that was finished.
std::vector<std::string> regimes_of(const solvers::Plan& plan, std::size_t rows) {
    std::vector<std::string> regimes;
    for (std::size_t row = 0; row < rows; ++row)
        regimes.push_back(plan.rows.at(row).regime);
    return regimes;
}

std::vector<double> rotor_wall_rates(const solvers::Scene& scene,
                                     const rheometry::TorqueHistory& history) {
    std::vector<double> rates;
    for (const rheometry::TorqueRow& row : history.rows)
        rates.push_back(
            solvers::radial::steady_instrument_flow(scene.instrument, scene.fluid.law, row.speed)
                .rotor_wall_rate);
    return rates;
}

/// Each row with the end factor of its own speed; the conversion that is reported has the last
/// row's.
void convert_with_computed_ends(SolvedCase& solved, const std::vector<double>& end_factors,
                                const std::vector<std::string>& regimes,
                                const std::vector<double>& wall_rates) {
    const solvers::Scene& scene = solved.source.scene;
    for (std::size_t row = 0; row < end_factors.size(); ++row) {
        rheometry::ConversionSettings settings = scene.conversion;
        settings.end_factor = end_factors[row];
        solved.conversion = rheometry::conversion_for(scene.instrument, settings);
        const rheometry::Rheogram point =
            rheometry::make_rheogram({{solved.solution.history.rows[row]}}, solved.conversion,
                                     {&regimes[row], 1}, {&wall_rates[row], 1});
        solved.rheogram.points.push_back(point.points.front());
    }
}

} // namespace

solvers::openfoam::Installation installation_for(const Case& source) {
    const auto found = solvers::openfoam::find_installation();
    if (!found)
        throw EngineMissing(fmt::format(
            "{}: solver.engine: OpenFOAM is not here; apt-get install {} brings it, engine = "
            "\"native\" solves the case without it",
            source.file.string(), solvers::openfoam::package));
    const int processes = source.scene.solver.processors;
    if (processes > 1 && !solvers::openfoam::program_in_path("mpirun"))
        throw EngineMissing(fmt::format(
            "{}: solver.processors = {}: mpirun, which starts several processes, is not here; "
            "apt-get install {} brings it, processors = 1 does without",
            source.file.string(), processes, solvers::openfoam::mpi_package));
    return *found;
}

PlannedCase plan_case(Case source, StageClock clock) {
    PlannedCase planned{std::move(source), {}, std::move(clock)};
    planned.plan = solvers::make_plan(planned.source.scene);
    planned.clock.end_stage("plan");
    if (!planned.plan.can_be_solved)
        throw EngineMissing(planned.source.file.string() + ": " + planned.plan.model_reason);
    return planned;
}

namespace {

SolvedCase unsolved(PlannedCase planned) {
    return {.source = std::move(planned.source),
            .plan = std::move(planned.plan),
            .solution = {},
            .division = {},
            .conversion = {},
            .rheogram = {},
            .ends = {},
            .structure = {},
            .clock = std::move(planned.clock)};
}

/// Stresses and rates from the torques that are there.
void convert(SolvedCase& solved, const std::vector<double>& end_factors);

/// c_L of OpenFOAM's steady rows: the torque over that of the endless rotor at the same speed, the
/// secondary flow in it. The numbers of rows and factors are those of the history.
std::vector<double> end_factors_of(SolvedCase& solved) {
    const solvers::Scene& scene = solved.source.scene;
    std::vector<double> factors;
    if (solved.solution.transient || scene.profile || !geometry::has_ends(scene.instrument))
        return factors;
    const double rate_per_speed =
        rheometry::conversion_for(scene.instrument, scene.conversion).rate_per_speed;
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    for (const rheometry::TorqueRow& row : solved.solution.history.rows) {
        const bool turns = row.steady_torque != 0.0;
        const double factor = turns ? row.torque / row.steady_torque : 1.0;
        factors.push_back(factor);
        if (!turns)
            continue;
        const double error = std::abs(row.torque_error / row.steady_torque);
        solved.ends.push_back({.speed = row.speed,
                               .shear_rate = rate_per_speed * row.speed,
                               .end_factor = factor,
                               .error = error,
                               .lower = unknown,
                               .upper = unknown,
                               .with_inertia = factor,
                               .with_inertia_error = error});
    }
    return factors;
}

/// Warns of another version, whether or not it comes to a result.
solvers::radial::RadialReport solved_with_openfoam(SolvedCase& solved,
                                                   const solvers::ProgressSink& progress,
                                                   const RunKeeping& keeping) {
    const solvers::openfoam::Installation installation = installation_for(solved.source);
    const std::string doubt = solvers::openfoam::doubt_about(installation);
    if (!doubt.empty())
        solved.plan.warnings.push_back(doubt);
    try {
        return solvers::openfoam::solve_with_openfoam(
            solved.source.scene, solved.plan, keeping.engine_folder, installation, progress);
    } catch (const solvers::openfoam::OpenFoamFailed& failure) {
        if (doubt.empty())
            throw;
        throw solvers::openfoam::OpenFoamFailed(fmt::format("{}. {}", failure.what(), doubt));
    }
}

} // namespace

SolvedCase solve_case(PlannedCase planned, const solvers::ProgressSink& progress,
                      const RunKeeping& keeping) {
    SolvedCase solved = unsolved(std::move(planned));
    const solvers::Scene& scene = solved.source.scene;
    std::vector<double> end_factors;
    if (scene.solver.engine == solvers::Engine::openfoam) {
        solved.solution = solved_with_openfoam(solved, progress, keeping);
        end_factors = end_factors_of(solved);
    } else if (scene.particles) {
        solvers::suspension::SuspensionReport report = solvers::suspension::solve_suspension(
            scene, solved.plan, progress, keeping.checkpointing, keeping.frames);
        solved.solution = std::move(report.solution);
        solved.structure = std::move(report.structure);
    } else if (solved.plan.vortices) {
        solved.solution = solvers::meridional::solve_with_vortices(scene, solved.plan, progress);
    } else if (solved.plan.model == "axisymmetric") {
        solvers::axisymmetric::AxisymmetricReport report =
            solvers::meridional::solve_bob(scene, solved.plan, progress);
        solved.solution = std::move(report.solution);
        end_factors = std::move(report.end_factor);
        if (!report.division.lines.front().empty())
            solved.division = std::move(report.division);
        solved.ends = std::move(report.ends);
    } else {
        solved.solution = solvers::radial::solve_radial(scene, solved.plan, progress);
        solvers::meridional::doubt_vortices_left_out(scene, solved.plan, solved.solution);
    }
    solved.clock.end_stage("solve");
    convert(solved, end_factors);
    return solved;
}

SolvedCase collect_case(PlannedCase planned, const std::filesystem::path& engine_folder) {
    SolvedCase solved = unsolved(std::move(planned));
    // Reading needs no program of OpenFOAM's, only what it wrote.
    solved.solution = solvers::openfoam::collect_from_openfoam(
        solved.source.scene, solved.plan, engine_folder,
        solvers::openfoam::find_installation().value_or(solvers::openfoam::Installation{}));
    solved.clock.end_stage("collect");
    convert(solved, end_factors_of(solved));
    return solved;
}

namespace {

void convert(SolvedCase& solved, const std::vector<double>& end_factors) {
    const solvers::Scene& scene = solved.source.scene;
    const rheometry::TorqueHistory& history = solved.solution.history;
    solved.conversion = rheometry::conversion_for(scene.instrument, scene.conversion);
    const std::vector<std::string> regimes = regimes_of(solved.plan, history.rows.size());
    const std::vector<double> wall_rates = rotor_wall_rates(scene, history);
    if (solved.conversion.end_factor_provisional && !end_factors.empty())
        convert_with_computed_ends(solved, end_factors, regimes, wall_rates);
    else
        solved.rheogram = rheometry::make_rheogram(history, solved.conversion, regimes, wall_rates);
    solved.clock.end_stage("convert");
}

} // namespace

Completeness completeness_of(const SolvedCase& solved) {
    if (solved.solution.interrupted)
        return Completeness::interrupted;
    return solved.solution.reached ? Completeness::complete : Completeness::not_reached;
}

std::vector<std::string> warnings_of(const SolvedCase& solved) {
    std::vector<std::string> warnings = solved.plan.warnings;
    const auto& notes = solved.solution.notes;
    warnings.insert(warnings.end(), notes.begin(), notes.end());
    const bool has_all_points = solved.rheogram.points.size() == solved.plan.rows.size();
    if (solved.solution.interrupted && has_all_points)
        warnings.push_back(
            fmt::format("Interrupted: every point is there, but not with the asked "
                        "accuracy of {:.3g} %; the largest estimated error is {:.3g} "
                        "%.",
                        100.0 * solved.source.scene.solver.accuracy,
                        100.0 * solved.solution.worst_relative_error));
    else if (solved.solution.interrupted)
        warnings.push_back(fmt::format("Interrupted: {} of {} points were finished.",
                                       solved.rheogram.points.size(), solved.plan.rows.size()));
    else if (!solved.solution.reached && !has_all_points &&
             solved.solution.worst_relative_error <= solved.source.scene.solver.accuracy)
        warnings.push_back(fmt::format("Only {} of {} points were finished.",
                                       solved.rheogram.points.size(), solved.plan.rows.size()));
    else if (!solved.solution.reached)
        warnings.push_back(fmt::format("The asked accuracy of {:.3g} % was not reached: the "
                                       "largest estimated error is {:.3g} %.",
                                       100.0 * solved.source.scene.solver.accuracy,
                                       100.0 * solved.solution.worst_relative_error));
    return warnings;
}

} // namespace searle::app
