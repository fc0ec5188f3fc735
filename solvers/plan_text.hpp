#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace searle::solvers {

/// "0.031 %": a share as a percentage with two digits; "less than 1e-10 %" below that.
[[nodiscard]] std::string percent(double share);

/// "all 100 rows", "none of 100 rows", "3 of 100 rows".
[[nodiscard]] std::string rows_of(std::size_t count, std::size_t total);

} // namespace searle::solvers
