#include "app/bench/campaign.hpp"

#include "app/bench/native_run.hpp"
#include "app/bench/peers.hpp"
#include "app/bench/work_precision.hpp"
#include "app/run_summary.hpp"
#include "app/versions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <utility>

namespace searle::app::bench {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double quick_seconds = 50.0;
constexpr double quick_peer_cost = 4.1;
/// A single computation that takes longer is left out, and says so.
constexpr double longest_run = 900.0;

/// A folder of its own, removed at the end.
class Workshop {
public:
    Workshop() {
        std::string name = (fs::temp_directory_path() / "searle-bench-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw std::runtime_error("no folder for temporary files: " + name);
        path_ = name;
    }
    ~Workshop() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;
    /// An empty folder; the one before is removed.
    [[nodiscard]] fs::path fresh() {
        std::error_code ignored;
        fs::remove_all(last_, ignored);
        last_ = path_ / std::to_string(++number_);
        fs::create_directories(last_);
        return last_;
    }

private:
    fs::path path_, last_;
    int number_{};
};

/// Measures one scene: in each round every accuracy and every peer once, in turns.
class SceneRun {
public:
    SceneRun(const BenchScene& scene, const CampaignOptions& options, Workshop& workshop,
             Clock::time_point end, const StopQuestion& stop)
        : scene_(scene), options_(options), workshop_(workshop), end_(end), stop_(stop) {
        result_.name = scene.name;
        result_.title = scene.title;
        result_.kind = scene.kind;
        if (scene.strain > 0.0)
            result_.cost_unit = "CPU s per unit strain";
    }

    SceneResult measured() {
        BenchScene used = scene_;
        if (options_.quick)
            used.reference_accuracy = std::min(1e-3, 10.0 * used.reference_accuracy);
        reference_ = reference_for(used, left(), stop_);
        result_.reference =
            reference_.fault.empty() ? reference_.text : "no reference: " + reference_.fault;
        result_.reference_error = reference_.error;
        const auto& accuracies = options_.quick ? scene_.quick_accuracies : scene_.accuracies;
        for (const double asked : accuracies)
            result_.points.push_back({.code = "searle",
                                      .setting = fmt::format("accuracy {:.0e}", asked),
                                      .asked = asked});
        if (options_.peers)
            add_peers();
        times_.resize(result_.points.size());
        for (int round = 0; round < options_.repeats && !over(); ++round)
            one_round(round, accuracies.size());
        for (std::size_t k = 0; k < result_.points.size(); ++k)
            finish(result_.points[k], times_[k]);
        if (std::ranges::any_of(times_, [](const auto& times) { return !times.empty(); }))
            add_published();
        std::erase_if(result_.points, [](const Measurement& point) {
            return !std::isfinite(point.cpu_median) && point.remark.empty();
        });
        time_whole_program();
        return std::move(result_);
    }

private:
    [[nodiscard]] double left() const {
        return std::min(longest_run, std::chrono::duration<double>(end_ - Clock::now()).count());
    }
    [[nodiscard]] bool over() const { return left() <= 0.0 || stop_(); }

    void add_peers() {
        for (auto* list : {&openfoam_peers, &particle_peers})
            for (Peer& peer : list(scene_)) {
                if (options_.quick && peer.cost > quick_peer_cost)
                    continue;
                result_.points.push_back({.code = peer.code, .setting = peer.setting});
                peers_.push_back(std::move(peer));
            }
    }

    void one_round(int round, std::size_t own) {
        for (std::size_t k = 0; k < result_.points.size() && !over(); ++k) {
            Measurement& point = result_.points[k];
            if (k < own) {
                // A computation of seconds needs no third round to be known to a few per cent.
                if (round == 0 || median(times_[k]) < 5.0)
                    own_point(point, times_[k]);
            } else if (round == 0 || (point.remark.empty() || peers_[k - own].cost < 10.0)) {
                if (round == 0 || median(times_[k]) < 10.0)
                    peer_point(peers_[k - own], point, times_[k]);
            }
        }
    }

    void own_point(Measurement& point, std::vector<double>& times) {
        const NativeRun run = run_native(case_of(scene_, point.asked), 0.1, left(), stop_);
        if (!run.fault.empty()) {
            if (run.fault != "interrupted")
                point.remark = run.fault;
            return;
        }
        const double per = scene_.strain > 0.0 ? scene_.strain : 1.0;
        for (const double seconds : run.cpu)
            times.push_back(seconds / per);
        point.true_error = true_error(scene_, reference_, run.torques);
        point.estimate = run.estimate;
        point.unknowns = run.unknowns;
        point.peak_MiB = run.peak_MiB;
        if (!run.reached)
            point.remark = "not reached, and says so";
    }

    void peer_point(const Peer& peer, Measurement& point, std::vector<double>& times) {
        const PeerRun run = peer.run(workshop_.fresh(), left(), stop_);
        if (!run.fault.empty()) {
            if (run.fault.find("interrupted") == std::string::npos)
                point.remark = run.fault;
            return;
        }
        times.push_back(run.cpu);
        if (!run.torques.empty())
            point.true_error = true_error(scene_, reference_, run.torques);
        if (!run.torques.empty() && !(point.true_error < 1.0)) {
            point.true_error = unknown;
            point.remark = "it diverged";
            times.clear();
            return;
        }
        point.unknowns = run.unknowns;
        point.peak_MiB = run.peak_MiB;
        if (!run.remark.empty())
            point.remark = run.remark;
    }

    static void finish(Measurement& point, const std::vector<double>& times) {
        if (times.empty())
            return;
        point.cpu_median = median(times);
        point.cpu_least = *std::ranges::min_element(times);
        point.repeats = static_cast<int>(times.size());
    }

    /// Figures that stand beside the scenes although their program is not run here.
    void add_published() {
        if (scene_.name == "suspension-coupled")
            result_.points.push_back({.code = "CFDEMcoupling + LIGGGHTS",
                                      .setting = "as the paper: 512 cells, step 1e-9 s",
                                      .cpu_median = 1430.0,
                                      .remark = "measured earlier on another machine"});
        const double dense = scene_.name == "suspension-dense"            ? 85.0
                             : scene_.name == "suspension-dense-friction" ? 178.0
                                                                          : 0.0;
        if (dense > 0.0)
            result_.points.push_back({.code = "LF_DEM",
                                      .setting = "lubrication and contacts, overdamped",
                                      .cpu_median = dense,
                                      .remark = "measured earlier on another machine"});
    }

    /// `searle run` from its start to the report in the folder.
    void time_whole_program() {
        if (over() || scene_.strain > 0.0)
            return;
        std::vector<double> seconds;
        for (int k = 0; k < (options_.quick ? 1 : 3) && !over(); ++k) {
            const fs::path folder = workshop_.fresh();
            std::ofstream(folder / "case.toml") << scene_.case_text;
            const Ended ended = run_program({fs::read_symlink("/proc/self/exe").string(), "run",
                                             "case.toml", "-o", "results", "--quiet"},
                                            folder, {}, left(), stop_);
            if (ended.fault.empty())
                seconds.push_back(ended.cpu);
        }
        result_.whole_program = median(seconds);
    }

    const BenchScene& scene_;
    const CampaignOptions& options_;
    Workshop& workshop_;
    Clock::time_point end_;
    const StopQuestion& stop_;
    SceneResult result_;
    Reference reference_;
    std::vector<Peer> peers_;
    std::vector<std::vector<double>> times_;
};

/// Searle's points whose true error is beyond the claimed one, with what the reference leaves open.
void note_broken_claims(BenchResult& result) {
    for (const SceneResult& scene : result.scenes)
        for (const Measurement& point : scene.points)
            if (point.code == "searle" && point.true_error > point.estimate + scene.reference_error)
                result.notes.push_back(
                    fmt::format("{}, {}: the true error {:.1e} is beyond the claimed {:.1e}",
                                scene.name, point.setting, point.true_error, point.estimate));
}

void note_missing_peers(BenchResult& result) {
    for (const auto& [program, package] :
         {std::pair{"pisoFoam", "openfoam"}, std::pair{"liggghts", "liggghts"},
          std::pair{"lmp", "lammps"}})
        if (!is_installed(program))
            result.notes.push_back(fmt::format(
                "{} is not installed, so it is not compared; to get it: apt-get install {}",
                program, package));
}

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name"))
            return line.substr(line.find(':') + 2);
    return "unknown processor";
}

} // namespace

std::string machine_text() {
    double loads[1] = {0.0};
    const bool known = getloadavg(loads, 1) == 1;
    return fmt::format("{}, {} processors{}", processor(), std::thread::hardware_concurrency(),
                       known ? fmt::format(", load {:.1f}", loads[0]) : "");
}

BenchResult measure(const CampaignOptions& options,
                    const std::function<void(const std::string&)>& tell, const StopQuestion& stop) {
    BenchResult result;
    result.version = program_version();
    result.created = present_time();
    result.quick = options.quick;
    result.machine = machine_text();
    Workshop workshop;
    const auto end =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(
                           std::chrono::duration<double>(options.quick ? quick_seconds : 1e6));
    for (std::size_t k = 0; k < options.scenes.size() && !stop(); ++k) {
        const BenchScene& scene = options.scenes[k];
        if (options.quick && (scene.long_run || scene.quick_accuracies.empty()))
            continue;
        if (Clock::now() > end) {
            result.notes.push_back(scene.name + " was left out: no time left");
            continue;
        }
        tell(fmt::format("{} of {}: {}", k + 1, options.scenes.size(), scene.name));
        SceneResult measured = SceneRun(scene, options, workshop, end, stop).measured();
        if (!measured.points.empty())
            result.scenes.push_back(std::move(measured));
    }
    result.interrupted = stop();
    note_broken_claims(result);
    if (options.peers)
        note_missing_peers(result);
    result.machine +=
        fmt::format("; at the end {}", machine_text().substr(machine_text().rfind("load")));
    return result;
}

} // namespace searle::app::bench
