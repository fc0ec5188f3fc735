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
    std::string geometry(geometry::name_of(scene.instrument));
    if (const auto* gap = std::get_if<geometry::ConcentricCylinders>(&scene.instrument);
        gap && scene.profile) {
        geometry =
            fmt::format("profile (for conversions a single gap of {:g}/{:g} mm, {:g} mm high)",
                        1e3 * gap->bob_radius, 1e3 * gap->cup_radius, 1e3 * gap->height);
    }
    return fmt::format("{}, {}, {}", geometry, laws::flow::name_of(scene.fluid.law), protocol);
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
    return ExitCode::done;
}

} // namespace searle::app
