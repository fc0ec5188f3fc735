#pragma once

#include "casefile/document.hpp"
#include "casefile/keys.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace searle::casefile {

/// One case of a sweep that is given by itself.
struct SweepRun {
    std::string name;
    std::optional<Node> set; ///< table: dotted key -> value, or section -> table
};

/// The section [sweep]: several cases in one file.
struct Sweep {
    std::optional<Node> vary; ///< table: dotted key -> list of values
    std::vector<SweepRun> runs;
};

[[nodiscard]] Keys<Sweep> sweep_keys();

/// A case of a sweep, before any key has a meaning.
struct SweptCase {
    std::string name; ///< letters, digits and . _ - + = , only: usable as a folder's name
    Node root;        ///< without the sweep
};

/// All cases: every run (or the file itself, without runs) with every combination of the varied
/// values, the first varied key changing slowest. Names come from the runs and the values, e.g.
/// "slow,cup_radius=15mm". Faults: a name twice, a list that is none or empty, too many cases, a
/// key in both the sweep and `overrides`.
[[nodiscard]] std::vector<SweptCase> cases_of(const Node& root, const Sweep& sweep,
                                              const std::vector<Assignment>& overrides,
                                              const std::set<std::string>& selectors,
                                              std::vector<Fault>& faults);

} // namespace searle::casefile
