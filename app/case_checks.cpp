#include "app/case_checks.hpp"

#include "casefile/reading.hpp"

#include <fmt/format.h>

namespace searle::app {
namespace {

using casefile::Findings;

void check_conversion(const CaseAsWritten& written, Findings& findings) {
    const geometry::Instrument instrument = geometry::instrument_of(written.geometry);
    const std::string_view name = geometry::name_of(instrument);
    const rheometry::ConversionSettings& conversion = written.conversion;
    if (conversion.definition && !rheometry::has_definition(instrument, *conversion.definition))
        findings.contradiction({"conversion.definition", "geometry.type"},
                               fmt::format("a {} has no definition \"{}\"", name,
                                           rheometry::name_of(*conversion.definition)),
                               "iso-3219, its only one");
    const bool is_box = std::holds_alternative<geometry::Box>(instrument);
    if (is_box && findings.given("conversion.end_factor"))
        findings.contradiction({"conversion.end_factor", "geometry.type"},
                               "a box has no ends to correct for", "no end_factor");
    else if (conversion.end_factor_computed && !geometry::has_ends(instrument))
        findings.contradiction({"conversion.end_factor", "geometry.type"},
                               fmt::format("a {} has no ends to compute the factor of", name),
                               "a number; \"computed\" is for the din-bob and for ends = true");
}

/// A speed of a kind that the instrument's drive does not have.
void check_speed_kind(const CaseAsWritten& written, const std::string& key,
                      rheometry::WrittenSpeedKind kind, Findings& findings) {
    const bool is_box = std::holds_alternative<geometry::Box>(written.geometry.instrument);
    if (is_box && kind == rheometry::WrittenSpeedKind::angular_velocity)
        findings.contradiction({key, "geometry.type"},
                               "an angular velocity, but the box does not turn",
                               "a shear rate or a speed of the wall, such as \"1 mm/s\"");
    if (!is_box && kind == rheometry::WrittenSpeedKind::wall_speed)
        findings.contradiction({key, "geometry.type"},
                               "the speed of a wall, but the instrument turns",
                               "a shear rate or an angular velocity, such as \"10 rpm\"");
}

void check_speeds(const CaseAsWritten& written, Findings& findings) {
    const auto kind_of = [](const casefile::Quantity& speed) {
        return static_cast<rheometry::WrittenSpeedKind>(speed.kind);
    };
    const auto& program = written.protocol.program;
    if (const auto* ramp = std::get_if<rheometry::RampAsWritten>(&program)) {
        check_speed_kind(written, "protocol.from", kind_of(ramp->from), findings);
        check_speed_kind(written, "protocol.to", kind_of(ramp->to), findings);
    } else if (const auto* steps = std::get_if<rheometry::StepsAsWritten>(&program)) {
        if (steps->angular_velocities.is_given())
            check_speed_kind(written, "protocol.angular_velocities",
                             rheometry::WrittenSpeedKind::angular_velocity, findings);
        if (steps->wall_speeds.is_given())
            check_speed_kind(written, "protocol.wall_speeds",
                             rheometry::WrittenSpeedKind::wall_speed, findings);
    } else if (const auto* pieces = std::get_if<rheometry::SegmentsAsWritten>(&program)) {
        for (std::size_t at = 0; at < pieces->segments.size(); ++at)
            check_speed_kind(written, fmt::format("protocol.segments.{}.to", at + 1),
                             kind_of(pieces->segments[at].to), findings);
    }
}

void check_solver(const CaseAsWritten& written, Findings& findings) {
    const solvers::SolverSettings& solver = written.solver;
    if (std::holds_alternative<geometry::Box>(written.geometry.instrument) &&
        solver.model == solvers::Model::axisymmetric)
        findings.contradiction({"solver.model", "geometry.type"}, "a box has no axis",
                               "auto, radial or 3d");
    if (solver.model == solvers::Model::radial && solver.secondary_flow == solvers::Switch::on)
        findings.contradiction({"solver.secondary_flow", "solver.model"},
                               "the radial model has no secondary flow",
                               "secondary_flow = \"auto\", or model = \"axisymmetric\"");
}

/// Settings that only OpenFOAM has. A resolved case holds their defaults, too.
void check_openfoam(const CaseAsWritten& written, Findings& findings) {
    const solvers::SolverSettings& solver = written.solver;
    if (solver.engine == solvers::Engine::openfoam)
        return;
    const std::pair<const char*, bool> settings[] = {
        {"solver.application", solver.application.has_value()},
        {"solver.processors", solver.processors != 1},
        {"solver.time_step", solver.time_step.has_value()},
        {"solver.viscosity_cap", solver.viscosity_cap.has_value()}};
    if (geometry::is_eccentric(geometry::instrument_of(written.geometry)))
        findings.contradiction({"geometry.offset", "solver.engine"},
                               "the native engine has the bob in the middle of the cup",
                               "engine = \"openfoam\" beside it, or offset = \"0 mm\"");
    for (const auto& [key, is_set] : settings)
        if (is_set)
            findings.contradiction({key, "solver.engine"}, "the native engine has no such setting",
                                   "engine = \"openfoam\" beside it");
}

void check_output(const CaseAsWritten& written, Findings& findings) {
    // A resolved case holds the default too.
    if (written.output.field_rows != solvers::OutputSettings{}.field_rows && !written.output.fields)
        findings.contradiction({"output.field_rows", "output.fields"}, "no fields are written",
                               "fields = true beside field_rows");
}

void check_trajectory(const CaseAsWritten& written, Findings& findings) {
    if (written.output.trajectory_strain && !written.particles)
        findings.contradiction({"output.trajectory_strain"}, "there are no particles to follow",
                               "a section [particles] beside it");
}

void check_suspension(const CaseAsWritten& written, Findings& findings) {
    if (written.coupling && !written.particles)
        findings.contradiction({"coupling"}, "there are no [particles] to couple the fluid with",
                               "[coupling] beside [particles]");
    const auto* steps = std::get_if<rheometry::StepsAsWritten>(&written.protocol.program);
    if (steps && steps->hold_strain && !written.particles)
        findings.contradiction({"protocol.hold_strain"}, "a hold in strain is for a suspension",
                               "hold = \"steady\" or a time, or a section [particles]");
}

} // namespace

void add_case_checks(casefile::Keys<CaseAsWritten>& keys) {
    keys.check(check_conversion);
    keys.check(check_speeds);
    keys.check(check_solver);
    keys.check(check_openfoam);
    keys.check(check_output);
    keys.check(check_trajectory);
    keys.check(check_suspension);
}

} // namespace searle::app
