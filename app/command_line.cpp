#include "app/command_line.hpp"

#include "app/exit_code.hpp"
#include "app/failures.hpp"
#include "app/grammar.hpp"
#include "casefile/nearest_name.hpp"

#include <algorithm>
#include <cstdio>

namespace searle::app {

namespace {

int refuse(const std::string& message) {
    std::fputs(fmt::format("searle: {}\n", message).c_str(), stderr);
    return ExitCode::wrong_usage;
}

} // namespace

int run_command_line(int count, const char* const* words) {
    Grammar grammar;
    if (count < 2) {
        std::fputs(grammar.program().help().c_str(), stderr);
        return ExitCode::wrong_usage;
    }
    const std::string first = words[1];
    const std::vector<std::string> verbs = grammar.verb_names();
    if (!first.starts_with('-') && std::find(verbs.begin(), verbs.end(), first) == verbs.end()) {
        const auto meant = casefile::nearest_name(first, verbs);
        return refuse(fmt::format("there is no verb '{}'{}; `searle --help` lists them", first,
                                  meant ? fmt::format(" (did you mean '{}'?)", *meant) : ""));
    }
    try {
        grammar.program().parse(count, words);
    } catch (const CLI::Success& asked) { // --help and --version
        return grammar.program().exit(asked);
    } catch (const CLI::Error& error) {
        return refuse(fmt::format("{}; `searle {} --help` shows the usage", error.what(), first));
    }
    return with_failures_told(grammar.chosen());
}

} // namespace searle::app
