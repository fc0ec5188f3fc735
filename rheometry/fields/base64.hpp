#pragma once

#include <string>
#include <string_view>

namespace searle::rheometry::fields {

/// Bytes as text, RFC 4648 section 4, padded, without line breaks.
[[nodiscard]] std::string base64(std::string_view bytes);

/// The bytes of a base64 text; white space is skipped. Throws std::runtime_error for letters that
/// are none of base64's.
[[nodiscard]] std::string from_base64(std::string_view text);

} // namespace searle::rheometry::fields
