#pragma once

#include <string>
#include <string_view>

namespace searle::rheometry {

/// The bytes of a text file as UTF-8 without a byte order mark. UTF-16 is known by its mark, or
/// without one by its zero bytes; bytes that are not UTF-8 are taken as Windows-1252 (what
/// spreadsheet programs write in western locales). Throws std::invalid_argument for UTF-16 that
/// ends within a character or holds half a surrogate pair, and for text that holds a zero byte:
/// such a file is not text.
[[nodiscard]] std::string decode_text(std::string_view bytes);

} // namespace searle::rheometry
