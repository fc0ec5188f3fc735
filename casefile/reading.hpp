#pragma once

#include "casefile/fault.hpp"
#include "casefile/key.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace searle::casefile {

/// What reading a tree left behind, apart from the values in the target.
struct Reading {
    std::vector<Fault> faults;
    std::map<std::string, Place> places;        ///< of the values, by dotted key
    std::map<std::string, std::string> written; ///< the values as written, by dotted key
    std::set<std::string> faulty;               ///< keys without a usable value
    /// False when lines were left out because of their syntax: a missing key may stand on one.
    bool reports_missing_keys = true;
    /// The keys of the whole file, for the section that a misplaced key belongs to; may be null.
    const KeySet* whole_file = nullptr;
};

/// Handed to the checks of a set of keys: keys are named relative to that set.
class Findings {
public:
    Findings(Reading& reading, std::string path) : reading_{reading}, path_{std::move(path)} {}

    /// The values of `keys` do not go together. Said at the first of them that stands in the file,
    /// the others are shown too; dropped when one of them has a fault of its own.
    void contradiction(const std::vector<std::string>& keys, std::string problem,
                       std::string allowed = "");
    /// The key stands in the file (or in --set).
    [[nodiscard]] bool given(const std::string& key) const;

private:
    [[nodiscard]] bool is_faulty(const std::string& full_key) const;

    Reading& reading_;
    std::string path_;
};

/// Reads a table into `target`, the struct that `keys` were declared for. Every fault goes to
/// `reading`.
/// @param path  dotted key of the table, empty for the whole file
void read_keys(const KeySet& keys, const Node& table, const std::string& path, void* target,
               Reading& reading);

/// Reads one value; no value and a fault when the key does not take it.
[[nodiscard]] std::optional<Value> read_value(const Key& key, const Node& node,
                                              const std::string& path, Reading& reading);

} // namespace searle::casefile
