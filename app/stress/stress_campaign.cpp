#include "app/stress/stress_campaign.hpp"

#include "app/result_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view header =
    "family,number,seed,kind,verdict,worst_ratio,claimed_error,cpu_s,truth,reason,taylor_ratio\n";

/// Without what would break a table's line.
std::string one_line(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return c == '\n' || c == '\r' || c == ',' || c == '"'; }, ' ');
    return text.substr(0, 300);
}

std::string row_of(const std::string& family, long number, std::uint64_t seed,
                   const std::string& kind, const Trial& trial) {
    return fmt::format("{},{},{},{},{},{:.6g},{:.3g},{:.3g},{},{},{:.4g}\n", family, number, seed,
                       kind, name_of(trial.verdict), trial.worst_ratio, trial.relative_error,
                       trial.cpu, trial.truth, one_line(trial.reason), trial.taylor_ratio);
}

Verdict verdict_of(const std::string& name) {
    for (const Verdict verdict :
         {Verdict::right, Verdict::gave_up, Verdict::refused, Verdict::wrong, Verdict::hung})
        if (name == name_of(verdict))
            return verdict;
    return Verdict::crashed;
}

using DoneScenes = std::map<std::pair<std::string, long>, std::pair<std::string, Trial>>;

/// What an earlier sweep of the same seed has done; a line cut off is no line.
DoneScenes done_in(const fs::path& file, std::uint64_t seed) {
    DoneScenes done;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        std::vector<std::string> cells;
        std::istringstream parts(line);
        for (std::string cell; std::getline(parts, cell, ',');)
            cells.push_back(cell);
        if (cells.size() < 9 || cells[2] != std::to_string(seed))
            continue;
        Trial trial;
        trial.verdict = verdict_of(cells[4]);
        trial.truth = cells[8];
        trial.worst_ratio = std::strtod(cells[5].c_str(), nullptr);
        trial.relative_error = std::strtod(cells[6].c_str(), nullptr);
        trial.cpu = std::strtod(cells[7].c_str(), nullptr);
        trial.reason = cells.size() > 9 ? cells[9] : "";
        trial.taylor_ratio = cells.size() > 10 ? std::strtod(cells[10].c_str(), nullptr) : 0.0;
        done[{cells[0], std::strtol(cells[1].c_str(), nullptr, 10)}] = {cells[3], trial};
    }
    return done;
}

/// Case files of what failed and of what gave up; the others are drawn again from their number.
void keep_case(const fs::path& folder, const std::string& name, const Trial& trial,
               const RandomCase& scene) {
    if (!is_failure(trial.verdict) && trial.verdict != Verdict::gave_up)
        return;
    const fs::path place = folder / (is_failure(trial.verdict) ? "failures" : "gave-up");
    fs::create_directories(place);
    replace_file(place / name, scene.text);
}

void count(Tally& tally, const Trial& trial) {
    ++tally.count[trial.verdict];
    if (trial.taylor_ratio <= 1.0) {
        ++tally.below_onset;
        tally.right_below_onset += trial.verdict == Verdict::right ? 1 : 0;
    }
    tally.cpu += trial.cpu;
}

std::string tally_line(const std::string& name, const Tally& tally) {
    std::string line = fmt::format("  {:<40} {:>6}", name, tally.total());
    for (const Verdict verdict : {Verdict::right, Verdict::gave_up, Verdict::refused,
                                  Verdict::wrong, Verdict::crashed, Verdict::hung}) {
        const auto found = tally.count.find(verdict);
        line += fmt::format(" {:>8}", found == tally.count.end() ? 0 : found->second);
    }
    return line + fmt::format(" {:>9.1f}\n", tally.cpu);
}

} // namespace

long Tally::total() const {
    long sum = 0;
    for (const auto& [verdict, number] : count)
        sum += number;
    return sum;
}

long Tally::failures() const {
    long sum = 0;
    for (const auto& [verdict, number] : count)
        sum += is_failure(verdict) ? number : 0;
    return sum;
}

StressResult run_stress(const StressPlan& plan, const bench::StopQuestion& stop,
                        const std::function<void(long, long, long)>& told) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    const auto time_is_up = [&] {
        return plan.minutes > 0.0 &&
               std::chrono::duration<double>(Clock::now() - begin).count() > 60.0 * plan.minutes;
    };
    fs::create_directories(plan.folder);
    const fs::path table = plan.folder / "stress.csv";
    const DoneScenes done = done_in(table, plan.seed);
    const bool is_new = !fs::exists(table) || fs::file_size(table) == 0;
    std::ofstream rows(table, std::ios::app);
    if (is_new)
        rows << header;
    StressResult result;
    const long all = plan.scenes * static_cast<long>(plan.families.size());
    long finished = 0;
    // Family by family in turn, so that a time limit cuts all of them alike.
    for (long number = plan.first; number < plan.first + plan.scenes; ++number)
        for (const std::string& family : plan.families) {
            if (stop() || time_is_up()) {
                result.stopped = true;
                return result;
            }
            const auto earlier = done.find({family, number});
            Trial trial;
            std::string kind;
            if (earlier != done.end()) {
                kind = earlier->second.first;
                trial = earlier->second.second;
            } else {
                const RandomCase scene = random_case(family, plan.seed, number);
                kind = scene.kind;
                trial = try_scene(scene, plan.scene_limit, stop);
                if (stop() && trial.verdict == Verdict::crashed) { // the interrupt, not the scene
                    result.stopped = true;
                    return result;
                }
                rows << row_of(family, number, plan.seed, kind, trial) << std::flush;
                if (!rows)
                    throw OutputWriteError(table.string() + ": cannot be written");
                keep_case(plan.folder, fmt::format("{}-{}.toml", family, number), trial, scene);
            }
            count(result.families[family], trial);
            count(result.kinds[family][kind], trial);
            if (is_failure(trial.verdict))
                result.failures.push_back(fmt::format("{}-{} ({}): {}, {}", family, number, kind,
                                                      name_of(trial.verdict), trial.reason));
            told(++finished, all, static_cast<long>(result.failures.size()));
        }
    return result;
}

std::string stress_text(const StressResult& result) {
    std::string text =
        fmt::format("  {:<40} {:>6} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9}\n", "scenes", "",
                    "RIGHT", "GAVE-UP", "REFUSED", "WRONG", "CRASHED", "HUNG", "CPU, s");
    for (const auto& [family, tally] : result.families) {
        text += tally_line(family, tally);
        for (const auto& [kind, part] : result.kinds.at(family))
            text += tally_line("  " + kind, part);
        if (tally.below_onset < tally.total())
            text += fmt::format("  {}, below the onset of Taylor vortices: {} of {} scenes RIGHT "
                                "({:.1f} %)\n",
                                family, tally.right_below_onset, tally.below_onset,
                                100.0 * static_cast<double>(tally.right_below_onset) /
                                    static_cast<double>(std::max(1L, tally.below_onset)));
    }
    for (const std::string& failure : result.failures)
        text += "  " + failure + '\n';
    return text;
}

std::string stress_json(const StressResult& result) {
    std::string text = "{\n  \"complete\": " + std::string(result.stopped ? "false" : "true");
    for (const auto& [family, tally] : result.families) {
        text += fmt::format(",\n  \"{}\": {{\"scenes\": {}, \"failures\": {}", family,
                            tally.total(), tally.failures());
        for (const auto& [verdict, number] : tally.count)
            text += fmt::format(", \"{}\": {}", name_of(verdict), number);
        text += fmt::format(", \"below_onset\": {}, \"right_below_onset\": {}, \"cpu_s\": {:.3f}}}",
                            tally.below_onset, tally.right_below_onset, tally.cpu);
    }
    return text + "\n}\n";
}

} // namespace searle::app
