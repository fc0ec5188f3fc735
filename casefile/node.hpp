#pragma once

#include "casefile/source.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace searle::casefile {

struct Entry;

/// A value of a case file with the place where it stands.
struct Node {
    enum class Kind { text, integer, number, boolean, date, list, table };

    Kind kind = Kind::table;
    /// The value's first line; for a table of its own its [header].
    Place place;
    std::string text; ///< of a text
    std::int64_t integer{};
    double number{}; ///< of a number; may be NaN or infinite, as TOML allows
    bool boolean{};
    std::vector<Node> items;    ///< of a list
    std::vector<Entry> entries; ///< of a table, in the order of the file

    [[nodiscard]] const Entry* find(std::string_view key) const;
    [[nodiscard]] Entry* find(std::string_view key);
    /// As it could be written in a file, clipped to some 60 letters, for messages: "14 mm", [1, 2,
    /// ...].
    [[nodiscard]] std::string described() const;
    /// "a text", "a number", "a list", ...
    [[nodiscard]] std::string_view kind_name() const;
};

struct Entry {
    std::string key;
    Place key_place;
    Node value;
};

} // namespace searle::casefile
