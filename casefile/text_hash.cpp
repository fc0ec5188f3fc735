#include "casefile/text_hash.hpp"

#include <cstdint>
#include <fmt/format.h>

namespace searle::casefile {

std::string text_hash(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char sign : text) {
        hash ^= static_cast<unsigned char>(sign);
        hash *= 0x100000001b3U;
    }
    return fmt::format("{:016x}", hash);
}

} // namespace searle::casefile
