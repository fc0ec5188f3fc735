#pragma once

#include <string>
#include <string_view>

namespace searle::casefile {

/// A unit's text with its superscripts, products and blanks beyond ASCII written out: s⁻¹ -> s^-1.
[[nodiscard]] std::string ascii_signs(std::string_view unit);

/// The unit's text in the spelling of UDUNITS-2: aliases of rheometry replaced, superscripts and
/// other signs beyond ASCII written out. A text that needs nothing is returned as it is.
[[nodiscard]] std::string udunits_spelling(std::string_view unit);

} // namespace searle::casefile
