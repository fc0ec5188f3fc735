#pragma once

#include "casefile/key.hpp"

#include <optional>
#include <string>
#include <vector>

namespace searle::casefile {

/// One key of a case file as the reference shows it.
struct ReferenceRow {
    std::string key;       ///< dotted; "[]" after a list of tables: "protocol.segments[].to"
    std::string condition; ///< `geometry.type = "box"`; empty: always
    std::string section;   ///< the part of `key` before the first dot; empty for `title`
    std::string type;      ///< "length", "number", "whole number", "name", "table", ...
    std::vector<std::string> units; ///< usual ones; empty for what has none
    std::vector<Word> words;        ///< names that the key takes
    bool is_required{};
    std::string default_text; ///< as it stands in TOML, or a remark; empty for required keys
    std::optional<Bound> lower;
    std::optional<Bound> upper;
    std::string bounds; ///< both as a text
    std::string meaning;
    std::string example; ///< as it stands in TOML
};

/// Every key, in the order of declaration.
[[nodiscard]] std::vector<ReferenceRow> reference_rows(const KeySet& keys);

/// The reference for a terminal.
[[nodiscard]] std::string reference_text(const std::vector<ReferenceRow>& rows);

/// The reference as tables of Markdown, one for each section and alternative.
[[nodiscard]] std::string reference_markdown(const std::vector<ReferenceRow>& rows);

} // namespace searle::casefile
