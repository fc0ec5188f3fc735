#include "solvers/openfoam/level_run.hpp"

#include "solvers/openfoam/case_folder.hpp"
#include "solvers/openfoam/child_process.hpp"
#include "solvers/openfoam/disk_space.hpp"
#include "solvers/openfoam/installation.hpp"
#include "solvers/openfoam/level_reading.hpp"
#include "solvers/openfoam/log_tail.hpp"
#include "solvers/openfoam/row_start.hpp"
#include "solvers/openfoam/run_script.hpp"
#include "solvers/unsuitable_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace searle::solvers::openfoam {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// The programs of one level, one after the other.
class LevelPrograms {
public:
    LevelPrograms(const LevelTask& task, const LevelCase& level, const ProgressSink& progress)
        : task_(task), level_(level), progress_(progress) {}

    /// Runs to the end or until something stops it; what happened is in `result`.
    void run(LevelResult& result) {
        if (is_parallel() && !fs::exists(task_.folder / "processor0"))
            decompose();
        remove_half_written_times(field_places());
        if (runs_row_by_row(task_.plan))
            run_rows(result);
        else
            run_in_one(result);
        if (is_parallel() && result.failure.empty() && !result.interrupted)
            reconstruct();
    }
    /// A program that found no room ends in any way, or not at all.
    void fail_if_disk_is_full(const std::string& program) const {
        if (disk_is_full(task_.folder))
            throw DiskFull(fmt::format(
                "{}: the disk is full, {} could not write. What is there is kept: with room "
                "made, the same command goes on from there",
                task_.folder.string(), program));
    }

private:
    [[nodiscard]] bool is_parallel() const { return task_.scene.solver.processors > 1; }
    [[nodiscard]] std::string application() const {
        return std::string(name_of(task_.plan.application));
    }
    [[nodiscard]] fs::path log() const { return task_.folder / ("log." + application()); }
    /// Where the newest fields stand.
    [[nodiscard]] fs::path fields_folder() const {
        return is_parallel() ? task_.folder / "processor0" : task_.folder;
    }

    /// Where fields stand: the case, or each processor's folder.
    [[nodiscard]] std::vector<fs::path> field_places() const {
        if (!is_parallel())
            return {task_.folder};
        std::vector<fs::path> places;
        for (int part = 0; part < task_.scene.solver.processors; ++part)
            places.push_back(task_.folder / fmt::format("processor{}", part));
        return places;
    }

    int start(std::vector<std::string> command, const std::string& stage) {
        is_solving_ = stage == application();
        return run_program({.command = std::move(command),
                            .folder = task_.folder,
                            .log = task_.folder / ("log." + stage),
                            .project = task_.installation.project},
                           [this] { watch(); });
    }

    void decompose() {
        const auto cells = level_.mesh().mesh.cells.size();
        if (cells < static_cast<std::size_t>(task_.scene.solver.processors))
            throw UnsuitableScene(
                fmt::format("solver.processors = {}: the coarsest mesh has {} cells; at most one "
                            "process a cell",
                            task_.scene.solver.processors, cells));
        if (start({"decomposePar"}, "decomposePar") != 0) {
            std::error_code ignored; // a part of them would pass for all
            for (const fs::path& place : field_places())
                fs::remove_all(place, ignored);
            fail_if_disk_is_full("decomposePar");
            throw UnsuitableScene(fmt::format("decomposePar failed: {}",
                                              (task_.folder / "log.decomposePar").string()));
        }
    }

    /// Rows that are runs of their own all stay: those of the next level start from them.
    void reconstruct() {
        std::vector<std::string> command{"reconstructPar"};
        if (!runs_row_by_row(task_.plan))
            command.emplace_back("-latestTime");
        if (start(command, "reconstructPar") != 0)
            fail_if_disk_is_full("reconstructPar");
    }

    [[nodiscard]] std::vector<std::string> solver_command() const {
        if (!is_parallel())
            return {application()};
        return {"mpirun",      "--oversubscribe",
                "-np",         fmt::format("{}", task_.scene.solver.processors),
                application(), "-parallel"};
    }

    /// Finds the time that the next program starts from. What an earlier one wrote from there
    /// before it was killed goes: OpenFOAM would put its own into another file beside it.
    void prepare_start() {
        const std::vector<std::string> times = times_in(fields_folder());
        start_ = times.empty() ? "0" : times.back();
        for (const char* object : {"torque_bob", "torque_cup"})
            fs::remove_all(task_.folder / "postProcessing" / object / start_);
    }

    void run_in_one(LevelResult& result) {
        if (stop_asked_) {
            result.interrupted = true;
            return;
        }
        set_control(task_.folder, "stopAt", "endTime");
        const double end = end_time(level_.facts());
        prepare_start();
        const double from = std::stod(start_);
        if (from > end - 0.5 * level_.facts().time_step)
            return;
        // OpenFOAM counts its intervals from where it starts, and writes at the end only where one
        // ends there.
        if (from > 0.0)
            set_control(task_.folder, "writeInterval",
                        fmt::format("{:.17g}", (end - from) / writes_in_a_run));
        note_end(start(solver_command(), application()), result);
    }

    void run_rows(LevelResult& result) {
        const auto rows = task_.plan.speeds.speeds.size();
        for (row_ = 0; row_ < rows; ++row_) {
            if (row_is_finished(task_, row_))
                continue;
            const RowStart from{.plan = task_.plan,
                                .folder = task_.folder,
                                .coarser = task_.coarser,
                                .places = field_places(),
                                .row = row_};
            map_start(from);
            if (stop_asked_) {
                result.interrupted = true;
                return;
            }
            prepare_start();
            set_control(task_.folder, "endTime", from.end());
            set_control(task_.folder, "stopAt", "endTime");
            set_control(task_.folder, "writeInterval",
                        fmt::format("{:.17g}", end_of_row(task_.plan, row_) - std::stod(start_)));
            is_settled_ = false;
            note_end(start(solver_command(), application()), result);
            if (result.interrupted || !result.failure.empty())
                return;
            settle_row(from.end());
            if (!row_is_finished(task_, row_)) // told by the torques that are missing
                return;
            from.clear();
        }
    }

    /// A row that cannot be mapped starts from the row before.
    void map_start(const RowStart& from) {
        if (!from.can_be_mapped())
            return;
        from.prepare();
        int code = 0;
        try {
            code = start(from.command(), "mapFields");
            if (code == 0 && is_parallel() && !stop_asked_)
                code = start(from.distribution(), "mapFields");
        } catch (const StartFailure&) {
            code = -1; // an installation without it
        }
        if (code != 0 || stop_asked_)
            from.clear();
        if (code != 0 && !stop_asked_)
            fail_if_disk_is_full("mapFields");
    }

    /// A row that converged early stands where the next one starts. Fields without a flux are not
    /// what the solver wrote.
    void settle_row(const std::string& end) {
        for (const fs::path& place : field_places()) {
            const std::vector<std::string> times = times_in(place);
            if (!times.empty() && times.back() != end && fs::exists(place / times.back() / "phi"))
                fs::rename(place / times.back(), place / end);
        }
    }

    void note_end(int code, LevelResult& result) const {
        if (stop_asked_) {
            result.interrupted = true;
            return;
        }
        if (code == 0)
            return;
        fail_if_disk_is_full(application());
        result.blew_up = true;
        const LogTail tail = log_tail(log());
        std::string why = code == 136 || code == 8
                              ? "a number grew beyond all bounds (floating-point exception)"
                          : !tail.fatal.empty() ? tail.fatal
                                                : fmt::format("exit code {}", code);
        result.failure = fmt::format(
            "{} ended at {} {:.6g}{}: {}. A shorter solver.time_step or a "
            "coarser mesh may hold it; its log: {}",
            application(), task_.plan.steady ? "iteration" : "t =", tail.time.value_or(0.0),
            tail.courant ? fmt::format(", Courant number {:.3g}", *tail.courant) : std::string{},
            why, log().string());
    }

    /// Called while a program runs: tells how far it is, and stops it cleanly when asked to.
    void watch() {
        const auto now = Clock::now();
        if (stop_asked_) {
            if (now - *stop_asked_ > std::chrono::seconds(30))
                throw Interrupted();
            return;
        }
        try {
            if (is_solving_ && now - last_look_ > std::chrono::milliseconds(500)) {
                last_look_ = now;
                look();
            }
            progress_(fraction_, stage_);
        } catch (const Interrupted&) {
            // The solver writes the step it is in and ends: a later run goes on from there.
            set_control(task_.folder, "stopAt", "writeNow");
            stop_asked_ = now;
        }
    }

    /// A row whose torque stands still ends where it is, as `Allrun` has it.
    void end_settled_row() {
        if (is_settled_)
            return;
        // What still moves is told by a few of the last ones.
        constexpr int few = 20;
        for (const int count : {few, settled_iterations + 200}) {
            const std::vector<LoadSample> loads = last_loads(
                task_.folder / "postProcessing/torque_bob", start_, level_.component(), count);
            if (loads.size() < static_cast<std::size_t>(count == few ? few : settled_iterations))
                return;
            const auto [least, most] =
                std::ranges::minmax(loads, {}, [](const LoadSample& load) { return load.value; });
            if (!(most.value - least.value < settled_share * std::abs(most.value)))
                return;
        }
        set_control(task_.folder, "stopAt", "writeNow");
        is_settled_ = true;
    }

    void look() {
        if (runs_row_by_row(task_.plan))
            end_settled_row();
        const LogTail tail = log_tail(log());
        const double done = tail.time.value_or(0.0);
        fraction_ = std::clamp(done / end_time(level_.facts()), 0.0, 1.0);
        stage_ =
            runs_row_by_row(task_.plan)
                ? fmt::format(
                      "{}, {} cells: row {}, iteration {:.0f}", application(),
                      level_.mesh().mesh.cells.size(), row_ + 1,
                      std::max(0.0, done - static_cast<double>(row_) * task_.plan.iterations))
            : task_.plan.steady
                ? fmt::format("{}, {} cells: iteration {:.0f} of {:.0f}", application(),
                              level_.mesh().mesh.cells.size(), done, end_time(level_.facts()))
                : fmt::format("{}, {} cells: t = {:.4g} s, Courant number {:.2g}", application(),
                              level_.mesh().mesh.cells.size(), done, tail.courant.value_or(0.0));
    }

    const LevelTask& task_;
    const LevelCase& level_;
    const ProgressSink& progress_;
    std::size_t row_ = 0;
    std::string start_ = "0"; ///< time that the program running started from
    bool is_solving_ = false; ///< the program running is the solver
    bool is_settled_ = false; ///< the row was told to end
    double fraction_ = 0.0;
    std::string stage_ = "openfoam";
    Clock::time_point last_look_ = Clock::now();
    std::optional<Clock::time_point> stop_asked_;
};

std::size_t rows_of(const FoamPlan& plan) {
    return plan.steady ? plan.speeds.speeds.size() : plan.history.row_times.size();
}

bool is_there(const fs::path& folder) { return fs::exists(folder / "system" / "controlDict"); }

} // namespace

void prepare_level(const LevelTask& task) {
    if (!is_there(task.folder)) {
        const LevelCase level(task);
        write_case(task.folder, level.facts());
    }
}

LevelResult run_level(const LevelTask& task, const ProgressSink& progress) {
    const LevelCase level(task);
    if (!is_there(task.folder)) {
        write_case(task.folder, level.facts());
    } else if (const auto changed = changed_files(task.folder, level.facts()); !changed.empty()) {
        throw UnsuitableScene(fmt::format(
            "{}: {} {} not what this case writes; going on from there would mix two cases. "
            "--force starts anew; searle collect reads a case that was changed on purpose",
            task.folder.string(), fmt::join(changed, ", "), changed.size() == 1 ? "is" : "are"));
    }
    LevelResult ran;
    LevelPrograms programs(task, level, progress);
    programs.run(ran);
    LevelResult result = read_results(task, level);
    result.interrupted = ran.interrupted;
    result.blew_up = ran.blew_up;
    if (!ran.failure.empty())
        result.failure = ran.failure;
    if (const std::size_t rows = rows_of(task.plan);
        result.failure.empty() && !result.interrupted && result.torque.size() < rows) {
        programs.fail_if_disk_is_full(std::string(name_of(task.plan.application)));
        result.failure = fmt::format(
            "{} ended without a fault, but its torques stop after row {} of {}; its case: {}.",
            name_of(task.plan.application), result.torque.size(), rows, task.folder.string());
    }
    return result;
}

LevelResult read_level(const LevelTask& task) {
    const LevelCase level(task);
    // Steady rows stand at other iterations in each program.
    const std::string application = control_entry(task.folder, "application");
    if (task.plan.steady && application != name_of(task.plan.application))
        throw UnsuitableScene(fmt::format(
            "{}: its steady rows are {}'s, which this version has {} for; collect it with the "
            "version that wrote it, or write it anew",
            task.folder.string(), application, name_of(task.plan.application)));
    LevelResult result = read_results(task, level);
    const std::string version =
        version_in_log(task.folder / fmt::format("log.{}", name_of(task.plan.application)));
    if (!version.empty() && version != supported_version.substr(1)) // without its v
        result.notes.push_back(fmt::format("{}: OpenFOAM {} solved it; the case is written for {}, "
                                           "and other versions read some of its entries "
                                           "differently or not at all.",
                                           task.folder.string(), version, supported_version));
    if (const auto changed = changed_files(task.folder, level.facts()); !changed.empty())
        result.notes.push_back(fmt::format("{}: {} {} changed since searle wrote {}; the result is "
                                           "of the case as it was run.",
                                           task.folder.string(), fmt::join(changed, ", "),
                                           changed.size() == 1 ? "was" : "were",
                                           changed.size() == 1 ? "it" : "them"));
    return result;
}

} // namespace searle::solvers::openfoam
