#include "app/verb_new.hpp"

#include "app/exit_code.hpp"
#include "app/starting_case.hpp"
#include "casefile/nearest_name.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>

namespace searle::app {

int new_case(const NewOptions& options) {
    const std::vector<std::string> names = geometry_names();
    if (std::find(names.begin(), names.end(), options.geometry) != names.end()) {
        fmt::print("{}", starting_case(options.geometry));
        return ExitCode::done;
    }
    const auto nearest = casefile::nearest_name(options.geometry, names);
    fmt::print(stderr, "searle: there is no geometry \"{}\"; allowed: {}{}\n", options.geometry,
               fmt::join(names, ", "),
               nearest ? fmt::format("; did you mean {}?", *nearest) : std::string{});
    return ExitCode::wrong_usage;
}

} // namespace searle::app
