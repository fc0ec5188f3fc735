#pragma once

#include <string>
#include <string_view>

namespace searle::casefile {

/// FNV-1a, 64 bits, as 16 hexadecimal digits: tells texts apart, does not protect them.
[[nodiscard]] std::string text_hash(std::string_view text);

} // namespace searle::casefile
