#include "app/report_page.hpp"

#include "app/mesh_description.hpp"
#include "app/protocol_phrase.hpp"
#include "geometry/mesh_error.hpp"
#include "rheometry/report/describe_fluid.hpp"
#include "rheometry/report/particle_stress.hpp"
#include "rheometry/report/report.hpp"
#include "solvers/suspension/suspension_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

namespace searle::app {
namespace {

namespace report = rheometry::report;

constexpr std::size_t largest_embedded_csv = 500'000;

rheometry::Conversion conversion_of(const Case& source) {
    return rheometry::conversion_for(source.scene.instrument, source.scene.conversion);
}

report::FluidDescription fluid_of(const Case& source) {
    return report::describe_fluid(source.scene.fluid.law, source.scene.fluid.density);
}

std::optional<report::ParticlesNote> particles_of(const Case& source) {
    using namespace solvers::suspension;
    if (!source.scene.particles)
        return std::nullopt;
    const ParticleSettings settings = choose(source.scene).settings;
    return report::ParticlesNote{.volume_fraction = settings.volume_fraction,
                                 .walls = settings.boundary == ParticleBoundary::walls,
                                 .carries_stress = settings.hydrodynamics != Hydrodynamics::drag};
}

report::Provenance provenance_of(const RunSummary& summary) {
    const auto version = summary.versions.find("searle");
    return {.case_file = summary.origin.file,
            .case_hash = summary.origin.hash,
            .program_version = version == summary.versions.end() ? "" : version->second,
            .created = summary.created,
            .engine = summary.solver.engine,
            .model = summary.solver.model,
            .model_reason = summary.solver.model_reason};
}

std::optional<report::VortexOnset> onset_of(const RunSummary& summary) {
    if (!summary.taylor)
        return std::nullopt;
    const TaylorNumbers& taylor = *summary.taylor;
    return report::VortexOnset{.critical_reynolds = taylor.critical_reynolds,
                               .reynolds = taylor.reynolds,
                               .wave_number = taylor.wave_number,
                               .critical_shear_rate = std::isfinite(taylor.onset_shear_rate)
                                                          ? taylor.onset_shear_rate
                                                          : 0.0,
                               .basis = taylor.basis};
}

std::vector<report::Fact> facts_of(const RunSummary& summary,
                                   const std::optional<report::ParticlesNote>& particles) {
    const SolverNote& solver = summary.solver;
    std::vector<report::Fact> facts{
        {"status", std::string(name_of(summary.completeness))},
        {"points", fmt::format("{} of {}", summary.rows, summary.rows_asked)},
        {"largest estimated error",
         fmt::format("{:.2g} of the stress", solver.worst_relative_error)}};
    if (particles) {
        facts.push_back({"particle steps", fmt::format("{}", solver.time_steps)});
        if (particles->walls) {
            facts.push_back({"cells across the gap", fmt::format("{}", solver.elements)});
            facts.push_back({"wall against bulk stress",
                             fmt::format("differ by up to {:.2g} of the stress, inertia and "
                                         "scatter included",
                                         solver.worst_torque_imbalance)});
        }
    } else if (summary.transient) {
        facts.push_back(
            {solver.model == "axisymmetric" ? "elements of the section" : "elements across the gap",
             fmt::format("{}", solver.elements)});
        facts.push_back({"grid levels", fmt::format("{}", solver.refinements)});
        facts.push_back({"time steps", fmt::format("{}", solver.time_steps)});
        facts.push_back({"linear systems solved", fmt::format("{}", solver.linear_solves)});
        facts.push_back({"torque balance", fmt::format("|M_bob - M_cup - dL/dt| / max |M| = {:.2g}",
                                                       solver.worst_torque_imbalance)});
    }
    return facts;
}

std::optional<report::MeshDescription> mesh_of(const RunRecord& record) {
    const auto shape = solvers::axisymmetric::section_shape(record.source.scene.instrument);
    if (!record.summary.mesh || !shape)
        return std::nullopt;
    try {
        return mesh_description(*shape, *record.summary.mesh);
    } catch (const geometry::MeshError&) {
        return std::nullopt; // a section that has no outline to be checked against
    }
}

} // namespace

std::string report_page(const RunRecord& record) {
    const RunSummary& summary = record.summary;
    const auto particles = particles_of(record.source);
    const solvers::Scene& scene = record.source.scene;
    report::ReportInput input{
        .title = summary.title.empty() ? summary.origin.name : summary.title,
        .provenance = provenance_of(summary),
        .instrument = scene.instrument,
        .fluid = fluid_of(record.source),
        .conversion = conversion_of(record.source),
        .protocol = protocol_phrase(scene.protocol, geometry::rotates(scene.instrument)),
        .source_lines = {summary.origin.lines.begin(), summary.origin.lines.end()},
        .rheogram = record.rheogram,
        .transient = summary.transient,
        .accuracy = scene.solver.accuracy,
        .validity = {},
        .vortex_onset = onset_of(summary),
        .warnings = summary.warnings,
        .remarks = summary.remarks,
        .timings = {},
        .solver_facts = facts_of(summary, particles),
        .mesh = mesh_of(record),
        .measured = {},
        .compared_with = {},
        .csv = record.csv.size() <= largest_embedded_csv ? record.csv : "",
        .particles = particles,
        .ends = record.ends,
        .fields = record.fields};
    for (const PlanNote& note : summary.plan)
        input.validity.push_back({note.what, note.solved, note.reason});
    for (const StageSeconds& stage : summary.timings)
        input.timings.push_back({stage.stage, stage.wall, stage.cpu});
    return report::render_report(input);
}

std::vector<std::string> remarks_on(const RunRecord& record) {
    const auto particles = particles_of(record.source);
    return particles ? report::particle_remarks(*particles, record.rheogram,
                                                fluid_of(record.source).true_stress)
                     : std::vector<std::string>{};
}

namespace {

report::OverlayInput overlay_of(const SweepSummary& summary,
                                const std::vector<RunRecord>& records) {
    const auto version = summary.versions.find("searle");
    report::OverlayInput input{
        .title = summary.title,
        .provenance = {.case_file = summary.case_file,
                       .case_hash = "",
                       .program_version = version == summary.versions.end() ? "" : version->second,
                       .created = summary.created,
                       .engine = "native",
                       .model = "",
                       .model_reason = ""},
        .swept_keys = summary.swept_keys,
        .runs = {},
        .measured = {},
        .warnings = summary.warnings,
        .remarks = summary.remarks};
    for (std::size_t i = 0; i < records.size(); ++i) {
        const SweepRun& run = summary.runs.at(i);
        const RunRecord& record = records[i];
        input.runs.push_back({.name = run.name,
                              .link = run.name + "/report.html",
                              .swept_values = run.swept_values,
                              .fluid = fluid_of(record.source),
                              .conversion = conversion_of(record.source),
                              .rheogram = record.rheogram,
                              .transient = record.summary.transient,
                              .accuracy = record.source.scene.solver.accuracy,
                              .wall_seconds = run.wall_seconds,
                              .warnings = record.summary.warnings,
                              .particles = particles_of(record.source)});
    }
    return input;
}

} // namespace

std::vector<std::string> remarks_on(const SweepSummary& summary,
                                    const std::vector<RunRecord>& records) {
    return report::particle_remarks(overlay_of(summary, records));
}

std::string overlay_page(const SweepSummary& summary, const std::vector<RunRecord>& records) {
    return report::render_overlay(overlay_of(summary, records));
}

} // namespace searle::app
