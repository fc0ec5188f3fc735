#include "app/verb_stress.hpp"

#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/progress_line.hpp"
#include "app/stress/stress_campaign.hpp"
#include "app/usage_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>

namespace searle::app {

int stress(const StressOptions& options) {
    const std::vector<std::string> known = stress_families();
    for (const std::string& family : options.families)
        if (std::ranges::find(known, family) == known.end())
            throw UsageError(fmt::format("'{}' is no family of scenes; allowed: {}", family,
                                         fmt::join(known, ", ")));
    if (options.scenes < 1 || options.scenes > 10'000'000)
        throw UsageError("--scenes: 1 to 10000000 of each family");
    if (options.first < 1 || options.first > 1'000'000'000)
        throw UsageError("--first: 1 to 1000000000");
    if (options.minutes < 0.0 || options.scene_seconds <= 0.0)
        throw UsageError("--minutes and --scene-seconds: more than 0");
    if (std::filesystem::exists(options.folder) && !std::filesystem::is_directory(options.folder))
        throw UsageError(options.folder.string() + " is a file; results go to a folder");
    StressResult result;
    bool interrupted = false;
    {
        const InterruptWatch watch;
        ProgressLine line(options.quiet || options.json);
        result = run_stress(
            {.families = options.families.empty() ? usual_stress_families() : options.families,
             .first = options.first,
             .scenes = options.scenes,
             .seed = static_cast<std::uint64_t>(options.seed),
             .minutes = options.minutes,
             .scene_limit = options.scene_seconds,
             .folder = options.folder},
            [&watch] { return watch.requested(); },
            [&line](long done, long all, long failures) {
                line.show(static_cast<double>(done) / static_cast<double>(all),
                          fmt::format("{} of {} scenes, {} failures", done, all, failures));
            });
        interrupted = watch.requested();
    }
    const std::string text = options.json ? stress_json(result) : stress_text(result);
    std::fputs(text.c_str(), stdout);
    if (interrupted)
        return ExitCode::interrupted;
    return result.failures.empty() ? ExitCode::done : ExitCode::program_fault;
}

} // namespace searle::app
