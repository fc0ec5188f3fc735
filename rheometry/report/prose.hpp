#pragma once

#include <string>
#include <string_view>

namespace searle::rheometry::report {

/// Plain text as HTML: escaped, with formula symbols set as such. "tau_0", "Re_c", "c_L", "M_bob"
/// get their Greek letters and subscripts, "^(3/4)" and "^2" become superscripts; everything else,
/// names of keys included, stays as it is.
[[nodiscard]] std::string prose_html(std::string_view text);

} // namespace searle::rheometry::report
