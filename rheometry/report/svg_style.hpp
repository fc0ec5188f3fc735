#pragma once

#include <string_view>

namespace searle::rheometry::report {

/// Number of distinct series colours; colour k has the classes "line-k", "mark-k" (k = 0 ... count
/// - 1).
inline constexpr int series_colour_count = 8;

/// Style rules for all figures: literal colours by class, light and dark, light when printed.
/// Series colours follow Okabe & Ito, told apart with any kind of colour vision.
[[nodiscard]] std::string_view figure_style();

} // namespace searle::rheometry::report
