#pragma once

#include <charconv>
#include <concepts>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace searle::geometry {

/// A file that is written piece by piece through a buffer. Numbers are written so that reading them
/// gives the same bits.
class TextStream {
public:
    /// Throws std::filesystem::filesystem_error when the file cannot be made.
    explicit TextStream(const std::filesystem::path& file);
    ~TextStream();
    TextStream(const TextStream&) = delete;
    TextStream& operator=(const TextStream&) = delete;

    TextStream& operator<<(std::string_view text);
    TextStream& operator<<(char letter);
    template <class Number>
    requires(std::integral<Number> || std::floating_point<Number>) TextStream&
    operator<<(Number number) {
        char digits[32];
        const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
        return *this << std::string_view{digits, static_cast<std::size_t>(end - digits)};
    }
    /// Bytes as they lie in memory.
    template <class Item>
    TextStream& raw(std::span<const Item> items) {
        return *this << std::string_view{reinterpret_cast<const char*>(items.data()),
                                         items.size_bytes()};
    }
    /// Writes the rest and closes. Throws std::filesystem::filesystem_error when the disk is full.
    void close();

private:
    void flush();

    std::filesystem::path path_;
    std::FILE* file_ = nullptr;
    std::string buffer_;
};

} // namespace searle::geometry
