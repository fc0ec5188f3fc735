#pragma once

#include "casefile/fault.hpp"
#include "casefile/node.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace searle::casefile {

/// Larger files are refused unread, bytes.
inline constexpr std::uintmax_t largest_case_file = 4U << 20U;

/// A case file as a tree, before any key has a meaning.
struct Document {
    Node root;
    std::vector<Fault> syntax_faults;
};

/// The file's text. Throws CaseError with one fault for a file that is missing, a directory, no
/// regular file, too large, binary (it holds a zero byte), not readable, or without any letter.
[[nodiscard]] std::string read_case_text(const std::filesystem::path& file);

/// The tree of a text; `name` stands for the file in messages.
[[nodiscard]] Document parse_document(std::string_view text, std::string name);

/// A value to put into a tree, with where it came from.
struct Assignment {
    std::string key; ///< dotted; items of lists count from 1: "protocol.segments.1.to"
    Place key_place;
    Node value;
};

/// Reads "key=value" of --set; the value is TOML, or else a text: geometry.cup_radius=16 mm.
/// A fault for a text without '=' or without a key goes to `faults`.
void parse_override(std::string_view text, std::vector<Assignment>& assignments,
                    std::vector<Fault>& faults);

/// Puts the value at its key, making the tables that lead there. A table is merged key by key into
/// the one that stands there, unless it holds one of `selectors` (dotted: "geometry.type"), whose
/// value decides what else the section holds: then it takes the section's place. A key that leads
/// through a value that is no table is a fault.
void assign(Node& root, const Assignment& assignment, const std::set<std::string>& selectors,
            std::vector<Fault>& faults);

} // namespace searle::casefile
