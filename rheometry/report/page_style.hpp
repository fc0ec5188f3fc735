#pragma once

#include <string_view>

namespace searle::rheometry::report {

/// Style rules of the page around the figures: wide and narrow screens, light, dark, print.
[[nodiscard]] std::string_view page_style();

} // namespace searle::rheometry::report
