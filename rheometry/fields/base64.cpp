#include "rheometry/fields/base64.hpp"

#include <array>
#include <cstdint>
#include <stdexcept>

namespace searle::rheometry::fields {
namespace {

constexpr std::string_view letters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::array<std::int8_t, 256> letter_values() {
    std::array<std::int8_t, 256> values{};
    values.fill(-1);
    for (std::size_t k = 0; k < letters.size(); ++k) {
        values[static_cast<unsigned char>(letters[k])] = static_cast<std::int8_t>(k);
    }
    return values;
}

} // namespace

std::string base64(std::string_view bytes) {
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8U;
            if (k < count) {
                group |= static_cast<unsigned char>(bytes[at + k]);
            }
        }
        for (std::size_t k = 0; k < 4; ++k) {
            out += k <= count ? letters[(group >> (18U - 6U * k)) & 63U] : '=';
        }
    }
    return out;
}

std::string from_base64(std::string_view text) {
    static const std::array<std::int8_t, 256> values = letter_values();
    std::string out;
    out.reserve(text.size() / 4 * 3);
    std::uint32_t group = 0;
    unsigned bits = 0;
    for (const char letter : text) {
        if (letter == ' ' || letter == '\n' || letter == '\r' || letter == '\t') {
            continue;
        }
        if (letter == '=') {
            break;
        }
        const std::int8_t value = values[static_cast<unsigned char>(letter)];
        if (value < 0) {
            throw std::runtime_error("a letter that base64 does not have");
        }
        group = group << 6U | static_cast<std::uint32_t>(value);
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            out += static_cast<char>(group >> bits & 255U);
        }
    }
    return out;
}

} // namespace searle::rheometry::fields
