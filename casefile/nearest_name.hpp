#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace searle::casefile {

/// Number of letters to insert, delete, replace or swap with the next one to turn one text into the
/// other, whatever the case of letters and with '-', '_' and ' ' alike.
[[nodiscard]] int spelling_distance(std::string_view one, std::string_view other);

/// The name that was probably meant: the nearest one within a third of the letters (at least one).
/// The first of equals. Texts beyond 64 letters have none.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view meant,
                                                      std::span<const std::string> names);

} // namespace searle::casefile
