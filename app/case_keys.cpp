#include "app/case_keys.hpp"

#include "app/case_checks.hpp"

namespace searle::app {
namespace {

/// What the keys are for: a mesh needs neither fluid nor protocol, and no check across sections.
enum class Use { whole_case, mesh };

casefile::Keys<CaseAsWritten> declared_case_keys(Use use) {
    casefile::Keys<CaseAsWritten> keys;
    keys.key("title", &CaseAsWritten::title)
        .is_text()
        .example("Water in a 1 mm gap")
        .says("Heading of the report.");
    keys.table("geometry", &CaseAsWritten::geometry, geometry::geometry_keys())
        .required()
        .says("The instrument.");
    const bool is_whole = use == Use::whole_case;
    keys.table("fluid", &CaseAsWritten::fluid, solvers::fluid_keys())
        .says("The fluid between the walls.")
        .is_required = is_whole;
    keys.table("protocol", &CaseAsWritten::protocol, rheometry::protocol_keys())
        .says("What the drive does, and where the rows of the result lie.")
        .is_required = is_whole;
    keys.table("conversion", &CaseAsWritten::conversion, rheometry::conversion_keys())
        .says("From torque and speed to stress and rate.");
    keys.table("solver", &CaseAsWritten::solver, solvers::solver_keys())
        .says("How the flow is solved, and how well.");
    keys.table("output", &CaseAsWritten::output, solvers::output_keys())
        .says("What is written beside the rheogram.");
    keys.table("mesh", &CaseAsWritten::mesh, geometry::mesh_keys())
        .not_in_new()
        .says("The mesh of models that need one; all of it may be left out.");
    keys.table("particles", &CaseAsWritten::particles, solvers::suspension::particle_keys())
        .not_in_new()
        .says("Spheres in the fluid between the walls of a box.");
    keys.table("coupling", &CaseAsWritten::coupling, solvers::suspension::coupling_keys())
        .not_in_new()
        .says("Exchange between particles and fluid; all of it may be left out.");
    keys.table("sweep", &CaseAsWritten::sweep, casefile::sweep_keys())
        .not_in_new()
        .says("Several cases in one file: each run with every combination of the varied values.");
    if (is_whole)
        add_case_checks(keys);
    return keys;
}

} // namespace

const casefile::Keys<CaseAsWritten>& case_keys() {
    static const casefile::Keys<CaseAsWritten> keys = declared_case_keys(Use::whole_case);
    return keys;
}

const casefile::Keys<CaseAsWritten>& mesh_case_keys() {
    static const casefile::Keys<CaseAsWritten> keys = declared_case_keys(Use::mesh);
    return keys;
}

void resolve(CaseAsWritten& written) {
    const geometry::Instrument instrument = geometry::instrument_of(written.geometry);
    rheometry::ConversionSettings& conversion = written.conversion;
    if (!conversion.definition)
        conversion.definition = rheometry::default_definition(instrument);
    const bool has_ends = geometry::rotates(instrument);
    if (has_ends && !conversion.end_factor && !conversion.end_factor_computed)
        conversion.end_factor = rheometry::default_end_factor(instrument);
}

solvers::Scene scene_of(const CaseAsWritten& written) {
    solvers::Scene scene;
    scene.title = written.title;
    scene.instrument = geometry::instrument_of(written.geometry);
    if (const auto* profile = std::get_if<geometry::Profile>(&written.geometry.instrument))
        scene.profile = *profile;
    scene.fluid = written.fluid;
    scene.protocol = rheometry::protocol_of(written.protocol);
    scene.conversion = written.conversion;
    scene.solver = written.solver;
    scene.output = written.output;
    scene.mesh = written.mesh;
    scene.particles = written.particles;
    scene.coupling = written.coupling.value_or(solvers::suspension::CouplingSettings{});
    return scene;
}

} // namespace searle::app
