#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace searle::app {

/// How much of what was asked for a result holds.
enum class Completeness {
    complete,
    interrupted, ///< the user stopped it; the rows are those that were finished
    not_reached  ///< the asked accuracy was not reached in every row
};

struct StageSeconds {
    std::string stage;
    double wall{};
    double cpu{};
};

/// What was solved or left out, with the number that decided (see solvers::PlanItem).
struct PlanNote {
    std::string what;
    bool solved{};
    std::string reason;
};

struct TaylorNumbers {
    double critical_reynolds{};
    double reynolds{};
    double wave_number{};
    double onset_shear_rate{}; ///< 1/s; NaN: not known
    std::string basis;
};

/// The case that a result comes from.
struct CaseOrigin {
    std::string file; ///< name without folders
    std::string name;
    std::string hash;
    std::map<std::string, int> lines;           ///< see Case::lines
    std::map<std::string, std::string> written; ///< see Case::written
};

/// Of the program and what it was built with, by name.
using Versions = std::map<std::string, std::string>;

/// What the conversion was; factors per N m and rad/s, for the box per N and m/s.
struct ConversionNote {
    std::string definition;
    double stress_per_torque{};
    double rate_per_speed{};
    double end_factor{};
};

/// What the solver did. Errors are relative to the stress of their row unless the name says Pa.
struct SolverNote {
    std::string engine;
    std::string model;
    std::string model_asked;
    std::string model_reason;
    double accuracy_asked{};
    double worst_relative_error{};
    double largest_stress_error{}; ///< Pa
    double worst_torque_imbalance{};
    int refinements{};
    int elements{};
    long time_steps{};
    long linear_solves{};
    long unknowns{};
};

/// The division of an instrument's section that the torques come from: enough to make its mesh
/// again.
struct MeshNote {
    int degree{}; ///< of the polynomials on the elements
    /// Positions of the lines by family, as solvers::axisymmetric::SectionLines has them; lengths
    /// in radii of the rotor.
    std::vector<std::vector<double>> lines;
};

/// summary.json of one run.
struct RunSummary {
    std::string title;
    CaseOrigin origin;
    std::string created; ///< UTC, ISO 8601
    Versions versions;
    Completeness completeness = Completeness::complete;
    long rows{};
    long rows_asked{};
    bool transient{};
    SolverNote solver;
    std::optional<MeshNote> mesh; ///< absent where the model needs none
    ConversionNote conversion;
    std::optional<TaylorNumbers> taylor;
    std::map<std::string, long> regimes; ///< rows by regime
    std::vector<PlanNote> plan;
    std::vector<std::string> warnings;
    std::vector<std::string> remarks; ///< what the result says of particles
    std::vector<StageSeconds> timings;
    std::vector<std::string> files; ///< of the result folder, this one included
};

/// One run of a sweep.
struct SweepRun {
    std::string name; ///< its subfolder
    std::vector<std::string> swept_values;
    Completeness completeness = Completeness::complete;
    long rows{};
    double wall_seconds{};
};

/// summary.json over a sweep.
struct SweepSummary {
    std::string title;
    std::string case_file; ///< name without folders
    std::string created;
    Versions versions;
    Completeness completeness = Completeness::complete;
    long runs_asked{};
    std::vector<std::string> swept_keys;
    std::vector<SweepRun> runs; ///< those that were made, in the sweep's order
    std::vector<std::string> warnings;
    std::vector<std::string> remarks; ///< what the result says of particles
    std::vector<std::string> files;   ///< of the whole folder, subfolders included
};

[[nodiscard]] std::string_view name_of(Completeness completeness);

[[nodiscard]] std::string summary_json(const RunSummary& summary);
[[nodiscard]] std::string summary_json(const SweepSummary& summary);

/// What a summary.json is of.
enum class SummaryKind { none, run, sweep };

/// none: not a summary.json that Searle wrote.
[[nodiscard]] SummaryKind kind_of_summary(std::string_view json);

/// Both read what summary_json wrote; numbers come back bit for bit. Throw std::runtime_error with
/// what is wrong with the text.
[[nodiscard]] RunSummary read_run_summary(std::string_view json);
[[nodiscard]] SweepSummary read_sweep_summary(std::string_view json);

/// The files that a summary.json lists; none when the text is not a summary of Searle's.
[[nodiscard]] std::vector<std::string> files_listed(std::string_view json);

} // namespace searle::app
