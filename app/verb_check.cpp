#include "app/verb_check.hpp"

#include "app/case_reader.hpp"
#include "app/exit_code.hpp"
#include "app/protocol_phrase.hpp"

#include <cstdio>
#include <fmt/format.h>

namespace searle::app {
namespace {

std::string summary_of(const Case& one) {
    const solvers::Scene& scene = one.scene;
    const std::string protocol =
        protocol_phrase(scene.protocol, geometry::rotates(scene.instrument));
    return fmt::format("{}, {}, {}", geometry::name_of(scene.instrument),
                       laws::flow::name_of(scene.fluid.law), protocol);
}

} // namespace

int check(const CheckOptions& options) {
    const std::vector<Case> cases = read_cases(options.case_file, options.overrides);
    if (cases.size() > 1)
        fmt::print("{}: valid, {} cases\n", options.case_file.string(), cases.size());
    for (const Case& one : cases)
        fmt::print("{}: {}\n",
                   cases.size() > 1 ? "  " + one.name : options.case_file.string() + ": valid",
                   summary_of(one));
    for (const Case& one : cases)
        if (one.scene.has_particles) {
            fmt::print("[particles] and [coupling] are valid; this version cannot run them.\n");
            break;
        }
    return ExitCode::done;
}

} // namespace searle::app
