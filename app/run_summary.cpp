#include "app/run_summary.hpp"

#include "app/field_files.hpp"
#include "app/versions.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <limits>

namespace searle::app {
namespace {

std::string_view name_of(solvers::Model model) {
    switch (model) {
    case solvers::Model::radial:
        return "radial";
    case solvers::Model::axisymmetric:
        return "axisymmetric";
    case solvers::Model::three_dimensional:
        return "3d";
    case solvers::Model::automatic:
        break;
    }
    return "auto";
}

/// Rows at rest are left out: no accuracy is asked of them.
double largest_stress_error(const SolvedCase& solved) {
    const std::vector<rheometry::TorqueRow>& rows = solved.solution.history.rows;
    double largest = 0.0;
    for (std::size_t k = 0; k < solved.rheogram.points.size(); ++k)
        if (k >= rows.size() || !rows[k].rests)
            largest = std::max(largest, solved.rheogram.points[k].stress_error);
    return largest;
}

SolverNote solver_note(const SolvedCase& solved) {
    const solvers::radial::RadialReport& solution = solved.solution;
    const solvers::SolverSettings& settings = solved.source.scene.solver;
    return {.engine = settings.engine == solvers::Engine::openfoam ? "openfoam" : "native",
            .model = solved.plan.model,
            .model_asked = std::string(name_of(settings.model)),
            .model_reason = solved.plan.model_reason,
            .accuracy_asked = settings.accuracy,
            .worst_relative_error = solution.worst_relative_error,
            .largest_stress_error = largest_stress_error(solved),
            .worst_torque_imbalance = solution.worst_torque_imbalance,
            .refinements = solution.refinements,
            .elements = solution.elements,
            .time_steps = solution.time_steps,
            .linear_solves = solution.linear_solves,
            .unknowns = solution.unknowns};
}

} // namespace

std::string present_time() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&now, &parts);
    std::array<char, 32> text{};
    const std::size_t length =
        std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    return {text.data(), length};
}

RunSummary run_summary(const SolvedCase& solved, const std::string& created) {
    const rheometry::Conversion& conversion = solved.conversion;
    RunSummary summary{
        .title = solved.source.scene.title,
        .origin = {.file = solved.source.file.filename().string(),
                   .name = solved.source.name,
                   .hash = solved.source.hash,
                   .lines = solved.source.lines,
                   .written = solved.source.written},
        .created = created,
        .versions = all_versions(),
        .completeness = completeness_of(solved),
        .rows = static_cast<long>(solved.rheogram.points.size()),
        .rows_asked = static_cast<long>(solved.plan.rows.size()),
        .transient = solved.solution.transient,
        .solver = solver_note(solved),
        .mesh = {},
        .conversion = {.definition = std::string(rheometry::name_of(conversion.definition)),
                       .stress_per_torque = conversion.stress_per_torque,
                       .rate_per_speed = conversion.rate_per_speed,
                       .end_factor = conversion.end_factor},
        .taylor = {},
        .regimes = {},
        .plan = {},
        .warnings = warnings_of(solved),
        .remarks = {},
        .timings = solved.clock.stages(),
        .files = {"case.toml", "report.html", "rheogram.csv", "summary.json"}};
    if (solved.division)
        summary.mesh = MeshNote{solved.division->degree,
                                {solved.division->lines.begin(), solved.division->lines.end()}};
    if (!solved.ends.empty())
        summary.files.emplace_back("end_factor.csv");
    for (std::string& name : field_file_names(solved.solution.fields))
        summary.files.push_back(std::move(name));
    std::sort(summary.files.begin(), summary.files.end());
    if (solved.plan.taylor)
        summary.taylor =
            TaylorNumbers{.critical_reynolds = solved.plan.taylor->critical_reynolds,
                          .reynolds = solved.plan.taylor->reynolds,
                          .wave_number = solved.plan.taylor->wave_number,
                          .onset_shear_rate = solved.plan.taylor->onset_shear_rate.value_or(
                              std::numeric_limits<double>::quiet_NaN()),
                          .basis = solved.plan.taylor->basis};
    for (const rheometry::RheogramPoint& point : solved.rheogram.points)
        ++summary.regimes[point.regime];
    for (const solvers::PlanItem& item : solved.plan.items)
        summary.plan.push_back({item.what, item.solved, item.reason});
    return summary;
}

} // namespace searle::app
