#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace searle::test {

/// A zip archive of parts that are stored as they are (APPNOTE.TXT 6.3, without compression).
inline std::string zip_of(const std::vector<std::pair<std::string, std::string>>& parts) {
    const auto little = [](std::uint32_t value, int bytes) {
        std::string text;
        for (int k = 0; k < bytes; ++k)
            text += static_cast<char>(value >> (8 * k) & 0xFFU);
        return text;
    };
    const auto checksum = [](const std::string& text) {
        std::uint32_t crc = 0xFFFFFFFFU;
        for (const char character : text) {
            crc ^= static_cast<unsigned char>(character);
            for (int bit = 0; bit < 8; ++bit)
                crc = crc >> 1U ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
        }
        return ~crc;
    };
    std::string archive;
    std::string directory;
    for (const auto& [name, text] : parts) {
        const auto size = static_cast<std::uint32_t>(text.size());
        const std::string facts = little(20, 2) + little(0, 2) + little(0, 2) + little(0, 4) +
                                  little(checksum(text), 4) + little(size, 4) + little(size, 4) +
                                  little(static_cast<std::uint32_t>(name.size()), 2) + little(0, 2);
        directory += "PK\x01\x02" + little(20, 2) + facts + little(0, 2) + little(0, 2) +
                     little(0, 2) + little(0, 4) +
                     little(static_cast<std::uint32_t>(archive.size()), 4) + name;
        archive += "PK\x03\x04" + facts + name + text;
    }
    const auto count = static_cast<std::uint32_t>(parts.size());
    const auto start = static_cast<std::uint32_t>(archive.size());
    return archive + directory + "PK\x05\x06" + little(0, 4) + little(count, 2) + little(count, 2) +
           little(static_cast<std::uint32_t>(directory.size()), 4) + little(start, 4) +
           little(0, 2);
}

} // namespace searle::test
