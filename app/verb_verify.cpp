#include "app/verb_verify.hpp"

#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/usage_error.hpp"
#include "app/verify/verify_text.hpp"
#include "casefile/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace searle::app {
namespace {

std::vector<const verify::Check*> chosen_checks(const std::vector<std::string>& names) {
    std::vector<std::string> known;
    for (const verify::Check& check : verify::all_checks())
        known.push_back(check.name);
    for (const std::string& name : names)
        if (std::ranges::none_of(known, [&](const auto& each) { return each.starts_with(name); })) {
            const auto meant = casefile::nearest_name(name, known);
            throw UsageError(
                fmt::format("verify: there is no check '{}'{}; `searle verify --list` shows them",
                            name, meant ? fmt::format(" (did you mean '{}'?)", *meant) : ""));
        }
    std::vector<const verify::Check*> chosen;
    for (const verify::Check& check : verify::all_checks())
        if (names.empty() || std::ranges::any_of(names, [&](const std::string& name) {
                return check.name.starts_with(name);
            }))
            chosen.push_back(&check);
    return chosen;
}

} // namespace

int verify_installation(const VerifyOptions& options) {
    const std::vector<const verify::Check*> checks = chosen_checks(options.names);
    if (options.list) {
        for (const verify::Check* check : checks)
            std::fputs(fmt::format("{:<34} {}\n", check->name, check->subject).c_str(), stdout);
        return ExitCode::done;
    }
    const bool lines = !options.json && !options.markdown;
    const InterruptWatch watch;
    std::vector<verify::CheckResult> results;
    double seconds = 0.0;
    for (const verify::Check* check : checks) {
        if (watch.requested())
            break;
        results.push_back(verify::done(*check));
        seconds += results.back().seconds;
        if (lines) {
            std::fputs(verify::check_line(results.back()).c_str(), stdout);
            std::fflush(stdout);
        }
    }
    const auto passed = std::ranges::count(results, true, &verify::CheckResult::passed);
    if (options.json)
        std::fputs(verify::checks_json(results).c_str(), stdout);
    else if (options.markdown)
        std::fputs(verify::verification_page(results).c_str(), stdout);
    else
        std::fputs(
            fmt::format("{} of {} passed, {:.1f} s of CPU\n", passed, results.size(), seconds)
                .c_str(),
            stdout);
    if (results.size() < checks.size()) {
        std::fputs(fmt::format("searle: interrupted after {} of {} checks\n", results.size(),
                               checks.size())
                       .c_str(),
                   stderr);
        return ExitCode::interrupted;
    }
    return static_cast<std::size_t>(passed) == results.size() ? ExitCode::done
                                                              : ExitCode::program_fault;
}

} // namespace searle::app
