#include "solvers/openfoam/openfoam_solver.hpp"

#include "solvers/openfoam/level_run.hpp"
#include "solvers/openfoam/transport.hpp"
#include "solvers/plan_rows.hpp"
#include "solvers/row_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace searle::solvers::openfoam {
namespace {

namespace fs = std::filesystem;

/// Time of a row, s, and the drive's speed there.
std::pair<double, double> moment_of(const Plan& plan, std::size_t row) {
    return {plan.rows[row].time, plan.rows[row].speed};
}

/// Whether a plug grows or melts at a row in time, or the rotor comes to rest: a viscosity changes
/// by so much in a step there that the error falls by less than first order, and that of the steps
/// may cancel that of the cells on two levels (measured).
bool is_delicate(const Scene& scene, const FoamPlan& plan, const RowForecast& row) {
    return !plan.steady && !is_newtonian(scene) &&
           (std::abs(row.speed) < 1e-2 * plan.history.fastest_speed() ||
            row.regime.find("partly-sheared") != std::string::npos);
}

/// What is left of the error on a level of what the level before had: 1/4 for a scheme of second
/// order. First order: of laws whose viscosity is capped the stress has a kink; in time PISO alone
/// lags behind the turn of the velocity across a wedge by a step, and relaxed corrections, those of
/// a viscosity and those across periodic sides leave a part of each step's change behind.
double expected_decay(const Scene& scene, const FoamPlan& plan, const RowForecast& row) {
    if (is_delicate(scene, plan, row))
        return 0.8;
    const bool second_order =
        plan.steady ? !needs_viscosity_cap(scene.fluid.law)
                    : plan.application == FoamApplication::pimple_foam && plan.relaxation == 0.0 &&
                          (plan.one_cell_along || plan.vortices) && is_newtonian(scene);
    const bool has_kink = needs_viscosity_cap(scene.fluid.law);
    // Around an edge of a rotor's end the stress is infinite: order 4/3 (270 degrees of fluid).
    const bool has_edges = scene.profile || geometry::has_ends(scene.instrument);
    return second_order ? (has_edges ? 0.4 : 0.25) : has_kink && !plan.steady ? 0.6 : 0.5;
}

/// Of chords, whose effect on the flow inside is not counted.
constexpr double chord_margin = 1.5;

/// Last levels, the finest first; the others may be missing.
struct LastLevels {
    const LevelResult& finest;
    const LevelResult* before{};
    const LevelResult* first{};
};

double difference(const LevelResult& fine, const LevelResult& coarse, std::size_t row) {
    return std::abs(fine.torque[row] - coarse.torque[row]);
}

/// Error of a row by Richardson's estimate d q / (1 - q), d the last difference and q its decay
/// from level to level, times 3: Roache's safety factor for an order that was not observed (1998,
/// Verification and Validation in Computational Science and Engineering, chapter 5).
double level_error(const LastLevels& levels, double expected_decay, std::size_t row) {
    const double last = difference(levels.finest, *levels.before, row);
    double decay = expected_decay;
    if (levels.first != nullptr && row < levels.first->torque.size()) {
        const double earlier = difference(*levels.before, *levels.first, row);
        decay = std::clamp(earlier > 0.0 ? last / earlier : 1.0, 0.25, 0.75);
    }
    return 3.0 * last * decay / (1.0 - decay);
}

/// Where the levels are a quarter apart they are too coarse for Richardson's estimate, and may
/// cross at later rows: these are off by as much.
void carry_large_errors(std::vector<rheometry::TorqueRow>& rows) {
    constexpr double large = 0.25;
    constexpr double margin = 1.5;
    double carried = 0.0;
    for (rheometry::TorqueRow& row : rows) {
        const double own = row.torque_error;
        row.torque_error = std::max(own, carried);
        if (own > large * std::abs(row.torque))
            carried = std::max(carried, margin * own);
    }
}

/// The rows of the last level with the error that the levels before it tell.
rheometry::TorqueHistory history_of(const Scene& scene, const Plan& plan, const FoamPlan& foam,
                                    const LastLevels& levels) {
    rheometry::TorqueHistory history;
    const LevelResult& last = levels.finest;
    const std::size_t known =
        levels.before == nullptr ? 0 : std::min(last.torque.size(), levels.before->torque.size());
    for (std::size_t row = 0; row < last.torque.size(); ++row) {
        const auto [time, speed] = moment_of(plan, row);
        const radial::SteadyInstrumentFlow steady =
            radial::steady_instrument_flow(scene.instrument, scene.fluid.law, speed);
        const double torque = last.torque[row];
        double error = std::abs(torque);
        if (row < known) {
            const double decay = expected_decay(scene, foam, plan.rows[row]);
            error = level_error(levels, decay, row);
            // Two levels may cross in one row of a history: a neighbour's relative error counts
            // too.
            for (std::size_t at = row == 0 ? 0 : row - 1;
                 !foam.steady && at < std::min(row + 2, known); ++at)
                error = std::max(error, level_error(levels, decay, at) *
                                            std::min(1.0, std::abs(torque / last.torque[at])));
            // Of a start at 1e-9 of the rotor's speed, and of iterations that end at 1e-11.
            constexpr double least = 1e-8;
            error += last.unsettled[row] + least * std::abs(torque) +
                     std::abs(torque) * (chord_margin * last.chord_error + foam.cap_error[row]);
        }
        if (foam.hold > 0.0)
            error += hold_share * scene.solver.accuracy * std::abs(torque);
        if (foam.end_flow_left_out && scene.solver.secondary_flow == Switch::automatic)
            error += left_out_margin * plan.rows[row].end_flow_share * std::abs(torque);
        if (foam.quasi_steady)
            error += left_out_inertia(scene, plan.rows[row]) * std::abs(torque);
        // The imbalance is the whole run's: corrections that do not converge put a row off by five
        // times as much (measured), on both levels alike. Below a half the row stays a result.
        constexpr double imbalance_margin = 10.0;
        if (!foam.steady && last.imbalance && *last.imbalance > balance_limit)
            error = std::max(error,
                             std::min(0.45, imbalance_margin * *last.imbalance) * std::abs(torque));
        history.rows.push_back({.time = time,
                                .speed = speed,
                                .torque = torque,
                                .torque_error = std::isfinite(error) ? error : std::abs(torque),
                                .steady_torque = steady.torque,
                                .yield_radius = steady.yield_radius,
                                .rotor_wall_rate = steady.rotor_wall_rate});
    }
    if (!foam.steady)
        carry_large_errors(history.rows);
    return history;
}

/// Levels so far, coarsest first, and the report that they make.
class Levels {
public:
    Levels(const Scene& scene, const Plan& plan, const FoamPlan& foam)
        : scene_(scene), plan_(plan), foam_(foam) {
        report_.transient = !foam.steady;
    }

    void add(LevelResult level) {
        results_.push_back(std::move(level));
        const LevelResult& last = results_.back();
        report_.linear_solves += last.steps;
        // Two levels that both finished say more than one that broke off; one alone tells no error.
        const bool tells_first_error = !last.failure.empty() && results_.size() == 2;
        if (!is_complete(last) && results_.size() > 1 && !tells_first_error &&
            last.torque.size() < results_.front().torque.size()) {
            results_.pop_back();
            return;
        }
        take_last();
        const bool is_doubtful =
            !last.failure.empty() ||
            (results_.size() > 1 && report_.worst_torque_imbalance > balance_limit);
        if (is_doubtful && leave_out_nonsense() == 0 && results_.size() > 1) {
            results_.pop_back();
            take_last();
        }
    }

    [[nodiscard]] bool meets_accuracy() const {
        return results_.size() > 1 && report_.worst_relative_error <= scene_.solver.accuracy;
    }

    /// Whether two levels are too few, and there may be more.
    [[nodiscard]] bool wants_a_third() const {
        return results_.size() == 2 && foam_.levels > 2 &&
               std::ranges::any_of(plan_.rows, [this](const RowForecast& row) {
                   return is_delicate(scene_, foam_, row);
               });
    }

    /// Whether a further level is of no use: the accuracy is met and the torques balance, or no
    /// level will make them.
    [[nodiscard]] bool is_settled() const {
        const bool may_balance = foam_.application != FoamApplication::non_newtonian_ico_foam;
        const bool may_be_met = error_of_all_levels() <= scene_.solver.accuracy;
        return results_.size() > 1 &&
               (!may_be_met || (meets_accuracy() && !wants_a_third() &&
                                (report_.worst_torque_imbalance <= balance_limit || !may_balance)));
    }

    /// Makes the report of what is there; `note`: how it ended, empty where all went well.
    radial::RadialReport report(bool interrupted, const std::string& failure) {
        report_.interrupted = interrupted;
        report_.refinements = static_cast<int>(results_.size());
        if (!failure.empty())
            report_.notes.push_back(failure);
        if (!left_out_.empty())
            report_.notes.push_back(left_out_);
        if (results_.size() == 1 && !interrupted)
            report_.notes.emplace_back(
                "Only one level was solved, so nothing tells its error: 100 % is claimed.");
        for (const std::string& note :
             results_.empty() ? std::vector<std::string>{} : results_.back().notes)
            report_.notes.push_back(note);
        const bool unbalanced = note_imbalance();
        report_.reached = failure.empty() && !unbalanced && meets_accuracy() &&
                          report_.history.rows.size() == plan_.rows.size();
        return std::move(report_);
    }

    [[nodiscard]] bool is_empty() const { return results_.empty() || report_.history.rows.empty(); }

private:
    [[nodiscard]] bool is_complete(const LevelResult& level) const {
        return level.torque.size() == plan_.rows.size();
    }

    /// The largest error of a row that no level makes less: of chords, unless levels refine around,
    /// and of the cap.
    [[nodiscard]] double error_of_all_levels() const {
        const double chords = foam_.coarsest_angular_cells > 0 ? 0.0 : results_.back().chord_error;
        return chord_margin * chords + std::ranges::max(foam_.cap_error);
    }

    void take_last() {
        left_out_.clear();
        const LevelResult& last = results_.back();
        const std::size_t count = results_.size();
        report_.history = history_of(scene_, plan_, foam_,
                                     {.finest = last,
                                      .before = count > 1 ? &results_[count - 2] : nullptr,
                                      .first = count > 2 ? &results_[count - 3] : nullptr});
        report_.worst_relative_error = worst_relative_error(report_.history.rows);
        report_.elements = static_cast<int>(last.cells);
        report_.unknowns = static_cast<long>(4 * last.cells);
        report_.time_steps = foam_.steady ? 0 : last.steps;
        report_.worst_torque_imbalance = last.imbalance.value_or(0.0);
    }

    /// A run that goes wrong grows without bounds before it ends: rows up to the last one whose
    /// error is told and below half of its torque are kept.
    /// @return how many
    std::size_t leave_out_nonsense() {
        std::vector<rheometry::TorqueRow>& rows = report_.history.rows;
        const auto means_something = [](const rheometry::TorqueRow& row) {
            return row.torque_error < 0.5 * std::abs(row.torque);
        };
        const auto last = std::find_if(rows.rbegin(), rows.rend(), means_something);
        const auto kept = static_cast<std::size_t>(rows.rend() - last);
        if (kept < rows.size()) {
            left_out_ = kept + 1 < rows.size() ? fmt::format("Rows {} to {}", kept + 1, rows.size())
                                               : fmt::format("Row {}", rows.size());
            left_out_ += " of the run that went wrong are left out: nothing bounds their error.";
            rows.resize(kept);
            report_.worst_relative_error = worst_relative_error(rows);
        }
        return kept;
    }

    bool note_imbalance() {
        if (report_.worst_torque_imbalance <= balance_limit)
            return false;
        std::string why =
            "A finer mesh, a shorter solver.time_step or more iterations may mend it.";
        if (foam_.application == FoamApplication::non_newtonian_ico_foam)
            why = "This is the known defect of this package's nonNewtonianIcoFoam, whose explicit "
                  "term acts on every second cell only; no refinement mends it. pimpleFoam and "
                  "pisoFoam are right.";
        report_.notes.push_back(fmt::format(
            "The torques on bob and cup differ by {:.2g} % more than the fluid's angular momentum "
            "accounts for (limit {:.2g} %). {}",
            100.0 * report_.worst_torque_imbalance, 100.0 * balance_limit, why));
        return true;
    }

    const Scene& scene_;
    const Plan& plan_;
    const FoamPlan& foam_;
    std::vector<LevelResult> results_;
    std::string left_out_; ///< which rows, a sentence
    radial::RadialReport report_;
};

} // namespace

fs::path level_folder(const fs::path& engine_folder, int level) {
    return engine_folder / fmt::format("level-{}", level + 1);
}

namespace {

LevelTask task_of(const Scene& scene, const FoamPlan& plan, int level,
                  const fs::path& engine_folder, const Installation& installation) {
    return {scene,        plan,
            level,        level_folder(engine_folder, level),
            installation, level > 0 ? level_folder(engine_folder, level - 1) : fs::path{}};
}

} // namespace

void write_levels(const Scene& scene, const FoamPlan& plan, const fs::path& engine_folder,
                  const Installation& installation) {
    for (int level = 0; level < 2; ++level)
        prepare_level(task_of(scene, plan, level, engine_folder, installation));
}

radial::RadialReport solve_with_openfoam(const Scene& scene, const Plan& plan,
                                         const fs::path& engine_folder,
                                         const Installation& installation,
                                         const ProgressSink& progress) {
    const FoamPlan foam = plan_foam(scene, plan);
    Levels levels(scene, plan, foam);
    // Each level takes four times as long as the one before, or eight.
    const int expected = std::min(foam.levels, 2);
    for (int level = 0; level < foam.levels; ++level) {
        const ProgressSink sink = [&](double fraction, std::string_view stage) {
            const double share = level + 1 < expected ? 0.2 : 0.8;
            const double start = level + 1 < expected ? 0.0 : 0.2;
            progress(std::min(1.0, start + share * fraction), stage);
        };
        LevelResult result =
            run_level(task_of(scene, foam, level, engine_folder, installation), sink);
        const bool interrupted = result.interrupted;
        const std::string failure = result.failure;
        const bool blew_up = result.blew_up;
        if (!result.torque.empty() || levels.is_empty())
            levels.add(std::move(result));
        if (!failure.empty() && levels.is_empty()) {
            const std::string why = failure + "; no row is kept, for nothing bounds their errors";
            if (blew_up)
                throw OpenFoamBlewUp(why);
            throw OpenFoamFailed(why);
        }
        if (interrupted || !failure.empty())
            return levels.report(interrupted, failure);
        if (levels.is_settled())
            break;
    }
    return levels.report(false, "");
}

radial::RadialReport collect_from_openfoam(const Scene& scene, const Plan& plan,
                                           const fs::path& engine_folder,
                                           const Installation& installation) {
    const FoamPlan foam = plan_foam(scene, plan);
    Levels levels(scene, plan, foam);
    for (int level = 0; level < foam.levels; ++level) {
        const fs::path folder = level_folder(engine_folder, level);
        if (!fs::exists(folder / "system" / "controlDict"))
            break;
        LevelResult result = read_level(task_of(scene, foam, level, engine_folder, installation));
        if (!result.torque.empty())
            levels.add(std::move(result));
    }
    if (levels.is_empty())
        throw OpenFoamFailed(engine_folder.string() +
                             ": no row was finished there; Allrun in each level's folder runs it");
    return levels.report(false, "");
}

} // namespace searle::solvers::openfoam
