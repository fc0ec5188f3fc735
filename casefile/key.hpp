#pragma once

#include "casefile/node.hpp"
#include "casefile/value.hpp"

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace searle::casefile {

struct KeySet;
class Findings;

struct Word {
    std::string name;
    std::string meaning; ///< may be empty
};

struct Bound {
    double value{}; ///< SI
    bool included{};
    std::string text; ///< in the unit of the declaration: "0 m", "180 deg"
};

/// What the value of a key may be; several together where they are alternatives.
struct Takes {
    std::vector<QuantityKind> quantities; ///< a text with a unit of one of these kinds
    bool number = false;                  ///< a pure number
    bool integer = false;
    bool boolean = false;
    bool text = false;
    std::vector<Word> words; ///< one of these texts
    std::optional<Bound> lower;
    std::optional<Bound> upper;
    bool list = false; ///< a list of the above
    std::size_t fewest_items = 1;
    std::size_t most_items = 1000000;
    bool free_table = false; ///< a table of any content, kept as it is
    bool table = false;      ///< a table with the keys of Key::table
    bool table_list = false; ///< a list of such tables
};

/// How the value reaches the member it configures. The pointers are to the struct that the key's
/// set was declared for; Keys<Target> makes them, and is the only one to do so.
struct Binding {
    std::function<void(void*, const Value&)> store;
    std::function<std::optional<Value>(const void*)> load; ///< no value: the key is absent
    std::function<void(void*, const Node&)> keep;          ///< of a free table
    std::function<void*(void*)> open;                      ///< of a table: makes it
    std::function<const void*(const void*)> look;          ///< of a table: null when absent
    std::function<void*(void*)> append;                    ///< of a list of tables
    std::function<std::size_t(const void*)> count;
    std::function<const void*(const void*, std::size_t)> item;
};

/// One key, declared beside the struct that it configures.
struct Key {
    std::string name;
    std::string sentence;
    Takes takes;
    bool is_required = false;
    /// As a user would write it; for a key with a default that default, in its usual unit.
    std::string example_text;
    std::string default_note;       ///< for a default that other keys decide
    std::string word_for_absent;    ///< the word that stands for an empty optional: "auto"
    bool is_in_new = true;          ///< stands in the case that `searle new` prints
    bool is_needed_in_new = false;  ///< not required, and yet given there
    bool is_offered_in_new = false; ///< stands there behind '#'
    Binding binding;
    std::shared_ptr<const KeySet> table;

    // The words of a declaration, in the order in which they are usually said.

    Key& says(std::string text);
    Key& required();
    Key& example(std::string text);
    Key& defaults_to(std::string note);
    Key& measures(std::vector<QuantityKind> kinds);
    Key& measures(const QuantityKind& kind);
    Key& is_number();
    Key& is_integer();
    Key& is_boolean();
    Key& is_text();
    /// A word that may stand in place of a value.
    Key& word(std::string name, std::string meaning);
    /// The word that stands for an empty optional.
    Key& or_absent_as(std::string name, std::string meaning);
    Key& is_list(std::size_t fewest, std::size_t most);
    /// Bounds are texts in a usual unit, "0 m", or bare numbers, which are SI.
    Key& above(const std::string& bound);
    Key& at_least(const std::string& bound);
    Key& below(const std::string& bound);
    Key& at_most(const std::string& bound);
    Key& not_in_new();
    Key& given_in_new();
    Key& offered_in_new();
};

/// A key whose value decides which further keys the section has ("type", "model").
struct Selector {
    struct Alternative {
        std::string name;
        std::string meaning;
        std::shared_ptr<const KeySet> keys;
        std::function<void*(void*)> open;
        std::function<const void*(const void*)> look; ///< null when it is not the chosen one
    };

    std::string name;
    std::string sentence;
    std::vector<Alternative> alternatives;
};

/// The keys of a table.
struct KeySet {
    std::deque<Key> keys; // references stay valid while further keys are declared
    std::optional<Selector> selector;
    std::vector<std::function<void(const void*, Findings&)>> checks;
    /// A target with its defaults, for the reference.
    std::function<std::shared_ptr<const void>()> defaults;

    [[nodiscard]] const Key* find(std::string_view name) const;
};

/// The selectors of the sections, dotted: "geometry.type".
[[nodiscard]] std::set<std::string> selector_keys(const KeySet& whole_file);

/// The key's example as it stands in TOML.
[[nodiscard]] std::string example_as_toml(const Key& key);

/// What a key takes, for messages: `a length, at least 1 nm, such as "14 mm"`.
[[nodiscard]] std::string allowed_by(const Key& key);

/// "at least 1 nm and at most 1000 m"; empty without bounds.
[[nodiscard]] std::string bounds_text(const Takes& takes);

} // namespace searle::casefile
