#pragma once

#include "casefile/unit.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace searle::casefile {

/// Units that nearly every case file has, with their meaning, so that reading one need not load
/// UDUNITS' database (a quarter of the time that `check` takes). A test holds each to the database.
[[nodiscard]] std::span<const std::pair<std::string_view, Unit>> common_units();

[[nodiscard]] std::optional<Unit> common_unit(std::string_view text);

} // namespace searle::casefile
