#include "app/verb_bench.hpp"

#include "app/bench/bench_text.hpp"
#include "app/bench/campaign.hpp"
#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/result_folder.hpp"
#include "app/usage_error.hpp"
#include "casefile/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace searle::app {
namespace {

std::vector<bench::BenchScene> chosen_scenes(const std::vector<std::string>& names) {
    if (names.empty())
        return bench::bench_scenes();
    std::vector<std::string> known;
    for (const bench::BenchScene& scene : bench::bench_scenes())
        known.push_back(scene.name);
    std::vector<bench::BenchScene> chosen;
    for (const std::string& name : names) {
        const std::size_t before = chosen.size();
        for (const bench::BenchScene& scene : bench::bench_scenes())
            if (scene.name.starts_with(name) &&
                std::ranges::find(chosen, scene.name, &bench::BenchScene::name) == chosen.end())
                chosen.push_back(scene);
        const bool matches = std::ranges::any_of(
            known, [&](const std::string& each) { return each.starts_with(name); });
        if (chosen.size() == before && !matches) {
            const auto meant = casefile::nearest_name(name, known);
            throw UsageError(fmt::format("bench: there is no scene '{}'{}; there are {}", name,
                                         meant ? fmt::format(" (did you mean '{}'?)", *meant) : "",
                                         fmt::join(known, ", ")));
        }
    }
    return chosen;
}

std::string list_of_scenes() {
    std::string text;
    for (const bench::BenchScene& scene : bench::bench_scenes())
        text += fmt::format("{:<27} {}\n", scene.name, scene.title);
    return text;
}

} // namespace

int bench_scenes_verb(const BenchOptions& options) {
    if (options.list) {
        std::fputs(list_of_scenes().c_str(), stdout);
        return ExitCode::done;
    }
    bench::CampaignOptions campaign;
    campaign.scenes = chosen_scenes(options.names);
    campaign.quick = options.quick;
    campaign.peers = !options.no_peers;
    campaign.repeats = options.quick ? 1 : 3;
    check_output_place(options.folder, options.replace);
    const InterruptWatch watch;
    const bench::BenchResult result = bench::measure(
        campaign,
        [&](const std::string& line) {
            if (!options.quiet)
                std::fputs(fmt::format("searle: {}\n", line).c_str(), stderr);
        },
        [&] { return watch.requested(); });
    if (result.scenes.empty()) {
        std::fputs("searle: interrupted before the first scene; nothing was written\n", stderr);
        return ExitCode::interrupted;
    }
    const std::string json = bench::bench_json(result);
    // The folder knows its own by the list in its summary.json.
    write_result_folder(
        options.folder,
        {{"bench.csv", bench::bench_csv(result)},
         {"bench.html", bench::bench_page(result)},
         {"bench.json", json},
         {"bench.md", bench::benchmark_tables(result)},
         {"readme.md", bench::readme_block(result)},
         {"summary.json", "{\n  \"program\": \"searle\",\n  \"kind\": \"bench\",\n"
                          "  \"files\": [\"bench.csv\", \"bench.html\", "
                          "\"bench.json\", \"bench.md\", \"readme.md\", \"summary.json\"]\n}\n"}},
        options.replace);
    if (options.json)
        std::fputs(json.c_str(), stdout);
    else if (options.readme)
        std::fputs(bench::readme_block(result).c_str(), stdout);
    else
        std::fputs(bench::bench_text(result).c_str(), stdout);
    if (!options.quiet)
        std::fputs(fmt::format("searle: {}\n", (options.folder / "bench.html").string()).c_str(),
                   stderr);
    if (result.interrupted) {
        std::fputs("searle: interrupted; what was measured is kept\n", stderr);
        return ExitCode::interrupted;
    }
    return ExitCode::done;
}

} // namespace searle::app
