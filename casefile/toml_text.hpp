#pragma once

#include "casefile/fault.hpp"
#include "casefile/node.hpp"

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace searle::casefile {

struct ParsedToml {
    Node root; ///< what could be read; the lines with a fault are left out
    /// Faults of the syntax. TOML stops at the first; a line that stands for itself ("key = ...")
    /// is then skipped and reading goes on, so that one run shows them all.
    std::vector<Fault> faults;
};

/// Reads TOML 1.0. Every place in the result refers to `source`, which must hold the same text.
[[nodiscard]] ParsedToml parse_toml(std::string_view text, std::shared_ptr<const Source> source);

/// A single value, as on the right-hand side of a key; no value for a text that is not TOML.
/// Its places all refer to the column `column` of the one line of `source`.
[[nodiscard]] std::optional<Node>
parse_toml_value(std::string_view text, std::shared_ptr<const Source> source, int column);

} // namespace searle::casefile
