#include "rheometry/tables/text_decoding.hpp"

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace searle::rheometry {
namespace {

void append_utf8(std::string& text, std::uint32_t code) {
    const auto put = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xC0 | (code >> 6));
        put(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        put(0xE0 | (code >> 12));
        put(0x80 | ((code >> 6) & 0x3F));
        put(0x80 | (code & 0x3F));
    } else {
        put(0xF0 | (code >> 18));
        put(0x80 | ((code >> 12) & 0x3F));
        put(0x80 | ((code >> 6) & 0x3F));
        put(0x80 | (code & 0x3F));
    }
}

std::uint32_t byte_at(std::string_view bytes, std::size_t index) {
    return static_cast<unsigned char>(bytes[index]);
}

enum class ByteOrder { little, big };

std::string utf8_from_utf16(std::string_view bytes, ByteOrder order) {
    if (bytes.size() % 2 != 0)
        throw std::invalid_argument("the UTF-16 text ends in the middle of a character");
    const auto unit = [&](std::size_t index) {
        const std::uint32_t first = byte_at(bytes, index);
        const std::uint32_t second = byte_at(bytes, index + 1);
        return order == ByteOrder::little ? first | (second << 8) : (first << 8) | second;
    };
    std::string text;
    text.reserve(bytes.size() / 2);
    for (std::size_t i = 0; i < bytes.size(); i += 2) {
        std::uint32_t code = unit(i);
        if (code >= 0xD800 && code < 0xE000) {
            const bool leads = code < 0xDC00 && i + 3 < bytes.size();
            const std::uint32_t trail = leads ? unit(i + 2) : 0;
            if (trail < 0xDC00 || trail >= 0xE000)
                throw std::invalid_argument("the UTF-16 text holds half of a surrogate pair");
            code = 0x10000 + ((code - 0xD800) << 10) + (trail - 0xDC00);
            i += 2;
        }
        append_utf8(text, code);
    }
    return text;
}

/// Length of the UTF-8 sequence that starts at `index`, 0 when there is no valid one.
std::size_t utf8_sequence_length(std::string_view bytes, std::size_t index) {
    const std::uint32_t lead = byte_at(bytes, index);
    if (lead < 0x80)
        return 1;
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || index + length > bytes.size())
        return 0;
    for (std::size_t k = 1; k < length; ++k)
        if ((byte_at(bytes, index + k) & 0xC0) != 0x80)
            return 0;
    return length;
}

bool is_utf8(std::string_view bytes) {
    for (std::size_t i = 0; i < bytes.size();) {
        const std::size_t length = utf8_sequence_length(bytes, i);
        if (length == 0)
            return false;
        i += length;
    }
    return true;
}

/// Code points of the bytes 0x80-0x9F in Windows-1252; the five that it leaves undefined stay as
/// they are.
constexpr std::array<std::uint16_t, 32> windows_1252_block{
    0x20AC, 0x0081, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x008D, 0x017D, 0x008F, 0x0090, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x009D, 0x017E, 0x0178};

std::string utf8_from_windows_1252(std::string_view bytes) {
    std::string text;
    text.reserve(bytes.size() + bytes.size() / 8);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const std::uint32_t byte = byte_at(bytes, i);
        append_utf8(text, byte >= 0x80 && byte < 0xA0 ? windows_1252_block[byte - 0x80] : byte);
    }
    return text;
}

bool has_zero_in_every_second_byte(std::string_view bytes, std::size_t first_zero) {
    return bytes.size() >= 4 && bytes[first_zero] == '\0' && bytes[first_zero + 2] == '\0' &&
           bytes[1 - first_zero] != '\0' && bytes[3 - first_zero] != '\0';
}

std::string decoded(std::string_view bytes) {
    if (bytes.starts_with("\xFF\xFE"))
        return utf8_from_utf16(bytes.substr(2), ByteOrder::little);
    if (bytes.starts_with("\xFE\xFF"))
        return utf8_from_utf16(bytes.substr(2), ByteOrder::big);
    if (has_zero_in_every_second_byte(bytes, 1))
        return utf8_from_utf16(bytes, ByteOrder::little);
    if (has_zero_in_every_second_byte(bytes, 0))
        return utf8_from_utf16(bytes, ByteOrder::big);
    if (bytes.starts_with("\xEF\xBB\xBF"))
        bytes.remove_prefix(3);
    return is_utf8(bytes) ? std::string(bytes) : utf8_from_windows_1252(bytes);
}

} // namespace

std::string decode_text(std::string_view bytes) {
    std::string text = decoded(bytes);
    if (text.find('\0') != std::string::npos)
        throw std::invalid_argument("this is not a text file: it holds zero bytes");
    return text;
}

} // namespace searle::rheometry
