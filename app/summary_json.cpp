#include "app/summary_json.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

namespace searle::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;

/// JSON has no NaN and no infinity; null stands for both.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

double number(const Json& json, const char* key) {
    const Json& value = json.at(key);
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

[[noreturn]] void changed(const std::string& what) {
    throw std::runtime_error("summary.json has been changed: " + what);
}

/// The JSON library would cast a number of any size.
template <class Whole>
Whole whole(const Json& value) {
    if (!value.is_number_integer())
        changed("a whole number is expected, not " + value.dump());
    const auto found = value.get<std::int64_t>();
    const bool wraps = value.is_number_unsigned() && found < 0;
    if (wraps || !std::in_range<Whole>(found))
        changed(value.dump() + " is beyond the range of this number");
    return static_cast<Whole>(found);
}

template <class Whole>
std::map<std::string, Whole> wholes(const Json& object) {
    std::map<std::string, Whole> found;
    for (const auto& [key, value] : object.items())
        found.emplace(key, whole<Whole>(value));
    return found;
}

/// A name that stands for a folder must not lead out of the result.
std::string folder_name(const Json& value) {
    std::string name = value;
    if (name.find('/') != std::string::npos || name == "..")
        changed("'" + name + "' is no name of a folder");
    return name;
}

Completeness completeness_from(const std::string& name) {
    for (const Completeness each :
         {Completeness::complete, Completeness::interrupted, Completeness::not_reached})
        if (name == name_of(each))
            return each;
    throw std::runtime_error("summary.json: status '" + name + "' is not known");
}

Json to_json(const StageSeconds& stage) {
    return {{"stage", stage.stage}, {"wall_s", stage.wall}, {"cpu_s", stage.cpu}};
}

Json to_json(const PlanNote& note) {
    return {{"what", note.what}, {"solved", note.solved}, {"reason", note.reason}};
}

Json to_json(const SolverNote& solver) {
    return {{"engine", solver.engine},
            {"model", solver.model},
            {"model_asked", solver.model_asked},
            {"model_reason", solver.model_reason},
            {"accuracy_asked", solver.accuracy_asked},
            {"worst_relative_error", number(solver.worst_relative_error)},
            {"largest_stress_error_Pa", number(solver.largest_stress_error)},
            {"worst_torque_imbalance", number(solver.worst_torque_imbalance)},
            {"grid_levels", solver.refinements},
            {"elements", solver.elements},
            {"time_steps", solver.time_steps},
            {"linear_solves", solver.linear_solves},
            {"unknowns", solver.unknowns}};
}

SolverNote solver_from(const Json& json) {
    return {.engine = json.at("engine"),
            .model = json.at("model"),
            .model_asked = json.at("model_asked"),
            .model_reason = json.at("model_reason"),
            .accuracy_asked = number(json, "accuracy_asked"),
            .worst_relative_error = number(json, "worst_relative_error"),
            .largest_stress_error = number(json, "largest_stress_error_Pa"),
            .worst_torque_imbalance = number(json, "worst_torque_imbalance"),
            .refinements = whole<int>(json.at("grid_levels")),
            .elements = whole<int>(json.at("elements")),
            .time_steps = whole<long>(json.at("time_steps")),
            .linear_solves = whole<long>(json.at("linear_solves")),
            .unknowns = whole<long>(json.at("unknowns"))};
}

Json beginning(const char* kind, const std::string& title, const std::string& created,
               Completeness completeness, const Versions& versions) {
    return {{"program", "searle"},
            {"kind", kind},
            {"format", format},
            {"title", title},
            {"status", name_of(completeness)},
            {"interrupted", completeness == Completeness::interrupted},
            {"created", created},
            {"versions", versions}};
}

/// The text as JSON when it is a summary of this program, else null.
Json parsed(std::string_view text) {
    Json json = Json::parse(text, nullptr, false);
    const bool ours = json.is_object() && json.value("program", Json()) == "searle" &&
                      json.value("files", Json()).is_array();
    return ours ? json : Json(nullptr);
}

std::string text_at(const Json& json, const char* key) {
    const Json value = json.value(key, Json());
    return value.is_string() ? value.get<std::string>() : std::string();
}

template <class Read>
auto read_or_explain(std::string_view text, const char* kind, Read read) {
    const Json json = parsed(text);
    if (json.is_null() || text_at(json, "kind") != kind)
        throw std::runtime_error(std::string("summary.json is not that of a ") + kind);
    try {
        return read(json);
    } catch (const Json::exception& error) {
        changed(error.what());
    }
}

} // namespace

std::string_view name_of(Completeness completeness) {
    switch (completeness) {
    case Completeness::interrupted:
        return "interrupted";
    case Completeness::not_reached:
        return "accuracy not reached";
    case Completeness::complete:
        break;
    }
    return "complete";
}

std::string summary_json(const RunSummary& summary) {
    Json json =
        beginning("run", summary.title, summary.created, summary.completeness, summary.versions);
    const CaseOrigin& origin = summary.origin;
    json["case"] = {{"file", origin.file},
                    {"name", origin.name},
                    {"hash", origin.hash},
                    {"lines", origin.lines},
                    {"written", origin.written}};
    json["rows"] = summary.rows;
    json["rows_asked"] = summary.rows_asked;
    json["transient"] = summary.transient;
    json["solver"] = to_json(summary.solver);
    json["mesh"] = nullptr;
    if (summary.mesh)
        json["mesh"] = {{"degree", summary.mesh->degree},
                        {"lines_in_rotor_radii", summary.mesh->lines}};
    json["conversion"] = {{"definition", summary.conversion.definition},
                          {"stress_per_torque", summary.conversion.stress_per_torque},
                          {"rate_per_speed", summary.conversion.rate_per_speed},
                          {"end_factor", summary.conversion.end_factor}};
    json["taylor"] = nullptr;
    if (summary.taylor)
        json["taylor"] = {{"critical_reynolds", number(summary.taylor->critical_reynolds)},
                          {"reynolds", number(summary.taylor->reynolds)},
                          {"wave_number", number(summary.taylor->wave_number)},
                          {"onset_shear_rate_1_s", number(summary.taylor->onset_shear_rate)},
                          {"basis", summary.taylor->basis}};
    json["regimes"] = summary.regimes;
    json["plan"] = Json::array();
    for (const PlanNote& note : summary.plan)
        json["plan"].push_back(to_json(note));
    json["warnings"] = summary.warnings;
    json["remarks"] = summary.remarks;
    json["timings"] = Json::array();
    for (const StageSeconds& stage : summary.timings)
        json["timings"].push_back(to_json(stage));
    json["files"] = summary.files;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string summary_json(const SweepSummary& summary) {
    Json json =
        beginning("sweep", summary.title, summary.created, summary.completeness, summary.versions);
    json["case"] = {{"file", summary.case_file}};
    json["runs_asked"] = summary.runs_asked;
    json["swept_keys"] = summary.swept_keys;
    json["runs"] = Json::array();
    for (const SweepRun& run : summary.runs)
        json["runs"].push_back({{"name", run.name},
                                {"swept_values", run.swept_values},
                                {"status", name_of(run.completeness)},
                                {"rows", run.rows},
                                {"wall_s", run.wall_seconds}});
    json["warnings"] = summary.warnings;
    json["remarks"] = summary.remarks;
    json["files"] = summary.files;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

SummaryKind kind_of_summary(std::string_view text) {
    const Json json = parsed(text);
    const std::string kind = json.is_null() ? "" : text_at(json, "kind");
    return kind == "run"     ? SummaryKind::run
           : kind == "sweep" ? SummaryKind::sweep
                             : SummaryKind::none;
}

RunSummary read_run_summary(std::string_view text) {
    return read_or_explain(text, "run", [](const Json& json) {
        RunSummary summary{.title = json.at("title"),
                           .origin = {.file = json.at("case").at("file"),
                                      .name = folder_name(json.at("case").at("name")),
                                      .hash = json.at("case").at("hash"),
                                      .lines = wholes<int>(json.at("case").at("lines")),
                                      .written = json.at("case").at("written")},
                           .created = json.at("created"),
                           .versions = json.at("versions"),
                           .completeness = completeness_from(json.at("status")),
                           .rows = whole<long>(json.at("rows")),
                           .rows_asked = whole<long>(json.at("rows_asked")),
                           .transient = json.at("transient"),
                           .solver = solver_from(json.at("solver")),
                           .mesh = {},
                           .conversion = {},
                           .taylor = {},
                           .regimes = wholes<long>(json.at("regimes")),
                           .plan = {},
                           .warnings = json.at("warnings"),
                           .remarks = json.value("remarks", std::vector<std::string>{}),
                           .timings = {},
                           .files = json.at("files")};
        if (const Json mesh = json.value("mesh", Json()); !mesh.is_null())
            summary.mesh = MeshNote{.degree = whole<int>(mesh.at("degree")),
                                    .lines = mesh.at("lines_in_rotor_radii")};
        const Json& conversion = json.at("conversion");
        summary.conversion = {.definition = conversion.at("definition"),
                              .stress_per_torque = conversion.at("stress_per_torque"),
                              .rate_per_speed = conversion.at("rate_per_speed"),
                              .end_factor = conversion.at("end_factor")};
        if (const Json& taylor = json.at("taylor"); !taylor.is_null())
            summary.taylor =
                TaylorNumbers{.critical_reynolds = number(taylor, "critical_reynolds"),
                              .reynolds = number(taylor, "reynolds"),
                              .wave_number = number(taylor, "wave_number"),
                              // Absent from the earliest result folders.
                              .onset_shear_rate = taylor.contains("onset_shear_rate_1_s")
                                                      ? number(taylor, "onset_shear_rate_1_s")
                                                      : std::numeric_limits<double>::quiet_NaN(),
                              .basis = taylor.at("basis")};
        for (const Json& note : json.at("plan"))
            summary.plan.push_back({note.at("what"), note.at("solved"), note.at("reason")});
        for (const Json& stage : json.at("timings"))
            summary.timings.push_back({stage.at("stage"), stage.at("wall_s"), stage.at("cpu_s")});
        return summary;
    });
}

SweepSummary read_sweep_summary(std::string_view text) {
    return read_or_explain(text, "sweep", [](const Json& json) {
        SweepSummary summary{.title = json.at("title"),
                             .case_file = json.at("case").at("file"),
                             .created = json.at("created"),
                             .versions = json.at("versions"),
                             .completeness = completeness_from(json.at("status")),
                             .runs_asked = whole<long>(json.at("runs_asked")),
                             .swept_keys = json.at("swept_keys"),
                             .runs = {},
                             .warnings = json.at("warnings"),
                             .remarks = json.value("remarks", std::vector<std::string>{}),
                             .files = json.at("files")};
        for (const Json& run : json.at("runs"))
            summary.runs.push_back({.name = folder_name(run.at("name")),
                                    .swept_values = run.at("swept_values"),
                                    .completeness = completeness_from(run.at("status")),
                                    .rows = whole<long>(run.at("rows")),
                                    .wall_seconds = run.at("wall_s")});
        return summary;
    });
}

std::vector<std::string> files_listed(std::string_view text) {
    std::vector<std::string> files;
    const Json json = parsed(text);
    if (!json.is_null())
        for (const Json& file : json.at("files"))
            if (file.is_string())
                files.push_back(file);
    return files;
}

} // namespace searle::app
