#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace searle::rheometry {

// What an isolated call found travels to its caller as bytes: plain values, and texts and columns
// led by their length.

class ByteWriter {
public:
    template <class Value>
    void put(const Value& value) {
        static_assert(std::is_trivially_copyable_v<Value>);
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void put_text(std::string_view text) {
        put(static_cast<std::uint64_t>(text.size()));
        bytes_ += text;
    }
    void put_column(std::span<const double> column) {
        put_text({reinterpret_cast<const char*>(column.data()), column.size_bytes()});
    }
    [[nodiscard]] std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
};

/// Throws std::length_error where the bytes end too early.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
    template <class Value>
    [[nodiscard]] Value get() {
        Value value{};
        std::memcpy(&value, next(sizeof value).data(), sizeof value);
        return value;
    }
    [[nodiscard]] std::string get_text() { return std::string(next(get<std::uint64_t>())); }
    [[nodiscard]] std::vector<double> get_column() {
        const std::string_view bytes = next(get<std::uint64_t>());
        std::vector<double> column(bytes.size() / sizeof(double));
        if (!column.empty())
            std::memcpy(column.data(), bytes.data(), column.size() * sizeof(double));
        return column;
    }

private:
    std::string_view next(std::size_t count) {
        if (count > bytes_.size())
            throw std::length_error("the reading process sent too little");
        const std::string_view piece = bytes_.substr(0, count);
        bytes_.remove_prefix(count);
        return piece;
    }

    std::string_view bytes_;
};

} // namespace searle::rheometry
