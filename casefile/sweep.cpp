#include "casefile/sweep.hpp"

#include "casefile/reading.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <set>

namespace searle::casefile {
namespace {

constexpr std::size_t most_cases = 10000;
constexpr std::size_t most_keys = 64;
constexpr std::size_t most_values = 2'000'000; // of all cases together: some 500 MB
constexpr std::size_t longest_name = 120;

bool is_plain(char sign) {
    return std::isalnum(static_cast<unsigned char>(sign)) != 0 ||
           std::string_view{"._-+=,"}.find(sign) != std::string_view::npos;
}

/// "14.5 mm" -> "14.5mm", "100 1/s" -> "100_per_s".
std::string plain_name(std::string_view value) {
    std::string name;
    for (std::size_t at = 0; at < value.size(); ++at) {
        if (value.substr(at).starts_with(" 1/")) {
            name += "_per_";
            at += 2;
        } else if (value[at] == '/') {
            name += "_per_";
        } else if (value[at] == '%') {
            name += "percent";
        } else if (is_plain(value[at])) {
            name += value[at];
        }
    }
    return name;
}

std::string last_part(std::string_view key) {
    const std::size_t dot = key.rfind('.');
    return std::string{dot == std::string_view::npos ? key : key.substr(dot + 1)};
}

/// One list of values for one key.
struct Variation {
    std::string key;
    Place key_place;
    std::vector<Node> values;
    std::string label; ///< in names

    [[nodiscard]] std::string name_of(std::size_t at) const {
        const Node& value = values[at];
        const bool is_scalar = value.kind != Node::Kind::table && value.kind != Node::Kind::list;
        const std::string text =
            plain_name(value.kind == Node::Kind::text ? value.text : value.described());
        return fmt::format("{}={}", label, is_scalar ? text : std::to_string(at + 1));
    }
};

/// The values that a copy of a node holds; a long text counts as several.
std::size_t size_of(const Node& node) {
    std::size_t size = 1 + node.text.size() / 64;
    for (const Node& item : node.items)
        size += size_of(item);
    for (const Entry& entry : node.entries)
        size += size_of(entry.value) + entry.key.size() / 64;
    return size;
}

/// The assignments of a table: a quoted dotted key as it is, a table key by key, so that
/// geometry.cup_radius with and without quotes mean the same.
void collect(const Node& table, const std::string& path, std::vector<Assignment>& assignments) {
    for (const Entry& entry : table.entries)
        assignments.push_back(
            {path.empty() ? entry.key : path + "." + entry.key, entry.key_place, entry.value});
}

class Expansion {
public:
    Expansion(const Node& root, const Sweep& sweep, const std::vector<Assignment>& overrides,
              const std::set<std::string>& selectors, std::vector<Fault>& faults)
        : sweep_{sweep}, overrides_{overrides}, selectors_{selectors}, faults_{faults}, base_{
                                                                                            root} {
        std::erase_if(base_.entries, [](const Entry& entry) { return entry.key == "sweep"; });
    }

    std::vector<SweptCase> all() {
        if (sweep_.vary)
            find_variations(*sweep_.vary, "");
        if (variations_.size() > most_keys) {
            fault(base_.place, "sweep.vary", "the sweep varies too many keys",
                  fmt::format("at most {}", most_keys));
            return {};
        }
        label_variations();
        refuse_doubled_overrides();
        const std::size_t count = case_count();
        if (count > most_cases)
            fault(variations_.empty() ? base_.place : variations_.back().key_place,
                  variations_.empty() ? "sweep" : "sweep.vary", "the sweep has too many cases",
                  fmt::format("at most {}", most_cases));
        else if (largest_case() > most_values / count)
            fault(base_.place, "sweep", "the sweep's cases hold too much together",
                  fmt::format("at most {} values", most_values));
        if (sweep_.runs.empty() && variations_.empty() && faults_.empty())
            fault(base_.place, "sweep", "the sweep names no case", "vary, or [[sweep.runs]]");
        if (!faults_.empty())
            return {};
        std::vector<SweptCase> cases;
        if (sweep_.runs.empty())
            vary({"", base_}, 0, cases);
        for (const SweepRun& run : sweep_.runs)
            vary({run.name, with(run)}, 0, cases);
        refuse_doubled_names(cases);
        return cases;
    }

private:
    void fault(const Place& place, std::string key, std::string problem, std::string allowed) {
        faults_.push_back({{place}, std::move(key), std::move(problem), std::move(allowed), ""});
    }

    /// Counted up to the first that is too many.
    [[nodiscard]] std::size_t case_count() const {
        std::size_t count = std::max<std::size_t>(1, sweep_.runs.size());
        for (const Variation& variation : variations_)
            if (count <= most_cases)
                count *= variation.values.size();
        return count;
    }

    /// Values of a case that takes the largest of everything.
    [[nodiscard]] std::size_t largest_case() const {
        std::size_t of_a_run = 0;
        for (const SweepRun& run : sweep_.runs)
            if (run.set)
                of_a_run = std::max(of_a_run, size_of(*run.set));
        std::size_t all = size_of(base_) + of_a_run;
        for (const Variation& variation : variations_) {
            std::size_t of_a_value = 0;
            for (const Node& value : variation.values)
                of_a_value = std::max(of_a_value, size_of(value));
            all += of_a_value;
        }
        return all;
    }

    void find_variations(const Node& table, const std::string& path) {
        for (const Entry& entry : table.entries) {
            const std::string key = path.empty() ? entry.key : path + "." + entry.key;
            if (entry.value.kind == Node::Kind::table)
                find_variations(entry.value, key);
            else if (entry.value.kind == Node::Kind::list && !entry.value.items.empty())
                variations_.push_back({key, entry.key_place, entry.value.items, last_part(key)});
            else
                fault(entry.value.place, "sweep.vary",
                      fmt::format("{} = {} is no list of values", key, entry.value.described()),
                      "a list with at least one value");
        }
    }

    void label_variations() {
        for (Variation& variation : variations_) {
            const auto same =
                std::count_if(variations_.begin(), variations_.end(), [&](const auto& other) {
                    return last_part(other.key) == last_part(variation.key);
                });
            variation.label = plain_name(same > 1 ? variation.key : last_part(variation.key));
        }
    }

    void refuse_doubled_overrides() {
        std::vector<Assignment> swept;
        for (const Variation& variation : variations_)
            swept.push_back({variation.key, variation.key_place, {}});
        for (const SweepRun& run : sweep_.runs)
            if (run.set)
                collect(*run.set, "", swept);
        for (const Assignment& override_ : overrides_)
            for (const Assignment& assignment : swept) {
                const auto within = [](const std::string& inner, const std::string& outer) {
                    return inner == outer || inner.starts_with(outer + ".");
                };
                if (!within(override_.key, assignment.key) &&
                    !within(assignment.key, override_.key))
                    continue;
                faults_.push_back({{override_.key_place, assignment.key_place},
                                   override_.key,
                                   "is set by the sweep too",
                                   "keys that the sweep leaves alone",
                                   ""});
                break;
            }
    }

    Node with(const SweepRun& run) {
        Node root = base_;
        std::vector<Assignment> assignments;
        if (run.set)
            collect(*run.set, "", assignments);
        for (const Assignment& assignment : assignments)
            assign(root, assignment, selectors_, faults_);
        return root;
    }

    void vary(const SweptCase& start, std::size_t depth, std::vector<SweptCase>& cases) {
        if (depth == variations_.size()) {
            cases.push_back(start);
            for (const Assignment& override_ : overrides_)
                assign(cases.back().root, override_, selectors_, faults_);
            return;
        }
        const Variation& variation = variations_[depth];
        for (std::size_t at = 0; at < variation.values.size(); ++at) {
            SweptCase next{start.name, start.root};
            assign(next.root, {variation.key, variation.key_place, variation.values[at]},
                   selectors_, faults_);
            next.name += fmt::format("{}{}", next.name.empty() ? "" : ",", variation.name_of(at));
            vary(next, depth + 1, cases);
        }
    }

    void refuse_doubled_names(const std::vector<SweptCase>& cases) {
        std::set<std::string> names;
        for (const SweptCase& one : cases) {
            if (one.name.size() > longest_name)
                fault(base_.place, "sweep", fmt::format("the name {} is too long", one.name),
                      fmt::format("at most {} letters", longest_name));
            if (!names.insert(one.name).second)
                fault(base_.place, "sweep", fmt::format("two cases are named {}", one.name),
                      "a name of its own for each, and no value twice");
        }
    }

    const Sweep& sweep_;
    const std::vector<Assignment>& overrides_;
    const std::set<std::string>& selectors_;
    std::vector<Fault>& faults_;
    Node base_;
    std::vector<Variation> variations_;
};

} // namespace

Keys<Sweep> sweep_keys() {
    Keys<SweepRun> run;
    run.key("name", &SweepRun::name)
        .is_text()
        .required()
        .example("slow")
        .says("Name of the case and of its result folder: letters, digits, . _ - + = ,");
    run.free_table("set", &SweepRun::set)
        .example(R"({ "protocol.duration" = "70 s" })")
        .says("What this case changes: keys, or a section; one with its type replaces it whole.");
    run.check([](const SweepRun& read, Findings& findings) {
        const bool plain = !read.name.empty() && read.name.size() <= longest_name &&
                           std::all_of(read.name.begin(), read.name.end(), is_plain) &&
                           read.name.front() != '.' && read.name.front() != '-';
        if (!plain)
            findings.contradiction({"name"}, "the name cannot be a folder's name",
                                   "letters, digits and . _ - + = , starting with none of . and -");
    });

    Keys<Sweep> keys;
    keys.free_table("vary", &Sweep::vary)
        .example(R"({ "geometry.cup_radius" = ["15 mm", "16 mm"] })")
        .says("Keys with a list of values each; every combination is a case.");
    keys.tables("runs", &Sweep::runs, run).says("Cases of their own, each a [[sweep.runs]].");
    return keys;
}

std::vector<SweptCase> cases_of(const Node& root, const Sweep& sweep,
                                const std::vector<Assignment>& overrides,
                                const std::set<std::string>& selectors,
                                std::vector<Fault>& faults) {
    return Expansion{root, sweep, overrides, selectors, faults}.all();
}

} // namespace searle::casefile
