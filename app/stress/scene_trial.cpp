#include "app/stress/scene_trial.hpp"

#include "app/engine_folder.hpp"
#include "app/stress/scene_truth.hpp"
#include "geometry/mesh_error.hpp"
#include "solvers/openfoam/openfoam_solver.hpp"
#include "solvers/suspension/suspension_motion.hpp"
#include "solvers/unsuitable_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <ctime>
#include <new>
#include <optional>
#include <sys/resource.h>
#include <unistd.h>

namespace searle::app {
namespace {

/// How a process that found no number to hand back says which verdict it came to.
struct Reason : std::runtime_error {
    Reason(Verdict verdict, const std::string& text)
        : std::runtime_error(fmt::format("{}: {}", name_of(verdict), text)) {}
};

/// What a truth may cost, over what the scene may take.
constexpr double truth_share = 1.0;

/// Share of the limit at which a suspension, or OpenFOAM, is stopped.
constexpr double stopped_at = 0.5;

/// OpenFOAM's cases of a scene, for as long as it is looked at.
class EngineScratch {
public:
    explicit EngineScratch(const Case& source)
        : folder_(std::filesystem::temp_directory_path() /
                  fmt::format("searle-stress-{}.openfoam", getpid())) {
        (void)open_engine_folder(folder_, source, true);
    }
    ~EngineScratch() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    EngineScratch(const EngineScratch&) = delete;
    EngineScratch& operator=(const EngineScratch&) = delete;
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path folder_;
};

void check_finite(const SolvedCase& solved) {
    for (const rheometry::RheogramPoint& point : solved.rheogram.points)
        if (!std::isfinite(point.shear_stress) || !std::isfinite(point.stress_error) ||
            !std::isfinite(point.shear_rate) || !std::isfinite(point.torque))
            throw Reason(Verdict::crashed, "a row holds a number that is none");
}

/// Verdict, worst ratio, largest claimed error, TruthBasis, Trial::taylor_ratio.
std::vector<double> judged(const RandomCase& scene, double limit) {
    std::vector<Case> cases = read_cases_text(scene.text, "scene.toml");
    if (cases.empty())
        throw Reason(Verdict::refused, "no case");
    // Of a mangled text that became a sweep the first case is run.
    Case& source = cases.front();
    // A suspension may be stiffer than any patience, and a mangled case ask for anything: it is
    // stopped as by a user, and what it has by then has to hold.
    const bool by_openfoam = source.scene.solver.engine == solvers::Engine::openfoam;
    const bool may_be_stopped = source.scene.particles || !scene.physical || by_openfoam;
    RunKeeping keeping;
    std::optional<EngineScratch> scratch;
    if (by_openfoam)
        keeping.engine_folder = scratch.emplace(source).folder();
    const std::clock_t begin = std::clock();
    // OpenFOAM's time is not this process's.
    const auto wall_begin = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return by_openfoam
                   ? std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_begin)
                         .count()
                   : static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    };
    const SolvedCase solved = solve_case(
        plan_case(std::move(source), StageClock()),
        [&](double, std::string_view) {
            if (may_be_stopped && seconds() > stopped_at * limit)
                throw solvers::Interrupted();
        },
        keeping);
    const double taken = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (taken > limit)
        throw Reason(Verdict::hung, fmt::format("took {:.0f} s", taken));
    check_finite(solved);
    const Completeness completeness = completeness_of(solved);
    const double claimed = solved.solution.worst_relative_error;
    const double code = completeness == Completeness::complete
                            ? static_cast<double>(Verdict::right)
                            : static_cast<double>(Verdict::gave_up);
    if (completeness == Completeness::not_reached && warnings_of(solved).empty())
        throw Reason(Verdict::crashed, "gave up without a reason");
    double taylor_ratio = 0.0;
    for (const solvers::RowForecast& row : solved.plan.rows)
        taylor_ratio = std::max(taylor_ratio, row.taylor_ratio);
    if (!scene.physical || solved.source.scene.particles)
        return {code, 0.0, claimed, static_cast<double>(TruthBasis::none), taylor_ratio};
    const SceneTruth truth = truth_of(solved, truth_share * limit);
    const auto& rows = solved.solution.history.rows;
    double worst = 0.0;
    for (std::size_t row = 0; row < std::min(rows.size(), truth.torque.size()); ++row) {
        const double distance = std::abs(rows[row].torque - truth.torque[row]);
        const double bars = rows[row].torque_error + truth.error[row];
        if (distance > 0.0)
            worst = std::max(worst, distance / bars);
    }
    return {worst > 1.0 ? static_cast<double>(Verdict::wrong) : code, worst, claimed,
            static_cast<double>(truth.basis), taylor_ratio};
}

/// The system ends the process when it has used so much CPU: what waits for a busy machine does not
/// hang.
void limit_cpu(double seconds) {
    const auto whole = static_cast<rlim_t>(std::ceil(seconds));
    const rlimit limit{whole, whole + 1};
    setrlimit(RLIMIT_CPU, &limit);
}

std::vector<double> told(const RandomCase& scene, double limit) {
    limit_cpu((1.0 + truth_share) * limit + 2.0);
    try {
        return judged(scene, limit);
    } catch (const Reason&) {
        throw;
    } catch (const CaseError& error) {
        throw Reason(Verdict::refused, error.what());
    } catch (const solvers::UnsuitableScene& error) {
        throw Reason(Verdict::refused, error.what());
    } catch (const EngineMissing& error) {
        throw Reason(Verdict::refused, error.what());
    } catch (const geometry::MeshError& error) {
        throw Reason(Verdict::refused, error.what());
    } catch (const solvers::suspension::StepFailure& error) {
        throw Reason(Verdict::gave_up, error.what());
    } catch (const solvers::openfoam::OpenFoamBlewUp& error) {
        throw Reason(Verdict::gave_up, error.what());
    } catch (const std::bad_alloc&) {
        throw Reason(Verdict::crashed, "memory ran out");
    } catch (const std::exception& error) {
        throw Reason(Verdict::crashed, error.what());
    }
}

} // namespace

std::string_view name_of(Verdict verdict) {
    switch (verdict) {
    case Verdict::right:
        return "RIGHT";
    case Verdict::gave_up:
        return "GAVE-UP";
    case Verdict::refused:
        return "REFUSED";
    case Verdict::wrong:
        return "WRONG";
    case Verdict::crashed:
        return "CRASHED";
    case Verdict::hung:
        break;
    }
    return "HUNG";
}

bool is_failure(Verdict verdict) {
    return verdict == Verdict::wrong || verdict == Verdict::crashed || verdict == Verdict::hung;
}

Trial try_scene(const RandomCase& scene, double limit, const bench::StopQuestion& stop) {
    constexpr double most_waiting = 20.0; // of wall clock over CPU: then it sleeps for ever
    const bench::Ended ended = bench::work_apart([&scene, limit] { return told(scene, limit); },
                                                 most_waiting * limit, stop);
    Trial trial;
    trial.cpu = ended.cpu;
    if (ended.timed_out || ended.cpu > (1.0 + truth_share) * limit + 1.0) {
        trial.verdict = Verdict::hung;
        trial.reason = fmt::format("not done within {:.0f} s", trial.cpu);
        return trial;
    }
    if (ended.values.size() == 5) {
        trial.verdict = static_cast<Verdict>(static_cast<int>(ended.values[0]));
        trial.worst_ratio = ended.values[1];
        trial.relative_error = ended.values[2];
        trial.truth = name_of(static_cast<TruthBasis>(static_cast<int>(ended.values[3])));
        trial.taylor_ratio = ended.values[4];
        if (trial.verdict == Verdict::wrong)
            trial.reason = fmt::format("{:.3g} error bars from {}", trial.worst_ratio, trial.truth);
        return trial;
    }
    trial.reason = ended.fault;
    if (ended.fault == fmt::format("ended by signal {}", SIGXCPU)) {
        trial.verdict = Verdict::hung;
        return trial;
    }
    for (const Verdict verdict :
         {Verdict::gave_up, Verdict::refused, Verdict::crashed, Verdict::hung})
        if (ended.fault.starts_with(name_of(verdict))) {
            trial.verdict = verdict;
            trial.reason = ended.fault.substr(name_of(verdict).size() + 2);
        }
    return trial;
}

} // namespace searle::app
