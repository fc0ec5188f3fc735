#include "casefile/reference.hpp"

#include "casefile/reading.hpp"
#include "casefile/toml_text.hpp"
#include "casefile/writing.hpp"

#include <fmt/format.h>

namespace searle::casefile {
namespace {

std::string without_article(std::string_view name) {
    const std::size_t space = name.find(' ');
    return std::string{space == std::string_view::npos ? name : name.substr(space + 1)};
}

std::string type_of(const Takes& takes) {
    std::vector<std::string> parts;
    for (const QuantityKind& kind : takes.quantities)
        if (kind.dimension != fraction.dimension)
            parts.push_back(without_article(kind.name));
    if (takes.integer)
        parts.emplace_back("whole number");
    if (takes.number)
        parts.emplace_back("number");
    if (takes.boolean)
        parts.emplace_back("true or false");
    if (takes.text)
        parts.emplace_back("text");
    if (!takes.words.empty())
        parts.emplace_back("name");
    std::string text;
    for (const std::string& part : parts)
        text += fmt::format("{}{}", text.empty() ? "" : " or ", part);
    if (takes.list && takes.fewest_items == takes.most_items)
        text = fmt::format("list of {}: {}", takes.fewest_items, text);
    else if (takes.list)
        text = fmt::format("list: {}", text);
    if (takes.table || takes.free_table)
        text += text.empty() ? "table" : " or table";
    if (takes.table_list)
        text += "list of tables";
    return text;
}

std::vector<std::string> units_of(const Takes& takes) {
    std::vector<std::string> units;
    for (const QuantityKind& kind : takes.quantities)
        units.emplace_back(kind.usual_units);
    return units;
}

class Collector {
public:
    void collect(const KeySet& keys, const std::string& path, const std::string& condition) {
        if (keys.selector)
            add_selector(*keys.selector, path, condition);
        const std::shared_ptr<const void> defaults = keys.defaults();
        for (const Key& key : keys.keys)
            add(key, path, condition, defaults.get());
        if (!keys.selector)
            return;
        for (const Selector::Alternative& alternative : keys.selector->alternatives)
            collect(
                *alternative.keys, path,
                fmt::format("{} = \"{}\"", joined(path, keys.selector->name), alternative.name));
    }

    std::vector<ReferenceRow> rows;

private:
    static std::string joined(const std::string& path, const std::string& name) {
        return path.empty() ? name : fmt::format("{}.{}", path, name);
    }

    static std::string section_of(const std::string& path, const Key* key) {
        if (path.empty())
            return key && key->takes.table ? key->name : std::string{};
        return path.substr(0, path.find('.'));
    }

    void add_selector(const Selector& selector, const std::string& path,
                      const std::string& condition) {
        ReferenceRow row;
        row.key = joined(path, selector.name);
        row.condition = condition;
        row.section = section_of(path, nullptr);
        row.type = "name";
        for (const Selector::Alternative& alternative : selector.alternatives)
            row.words.push_back({alternative.name, alternative.meaning});
        row.is_required = true;
        row.meaning = selector.sentence;
        row.example = quoted(selector.alternatives.front().name);
        rows.push_back(std::move(row));
    }

    void add(const Key& key, const std::string& path, const std::string& condition,
             const void* defaults) {
        const Takes& takes = key.takes;
        ReferenceRow row;
        row.key = joined(path, key.name);
        row.condition = condition;
        row.section = section_of(path, &key);
        row.type = type_of(takes);
        row.units = units_of(takes);
        row.words = takes.words;
        row.is_required = key.is_required;
        row.default_text = key.is_required ? "" : default_of(key, defaults);
        row.lower = takes.lower;
        row.upper = takes.upper;
        row.bounds = bounds_text(takes);
        row.meaning = key.sentence;
        row.example = example_as_toml(key);
        rows.push_back(std::move(row));
        if (key.table)
            collect(*key.table,
                    fmt::format("{}{}", joined(path, key.name), takes.table_list ? "[]" : ""),
                    condition);
    }

    static std::string default_of(const Key& key, const void* defaults) {
        if (!key.default_note.empty())
            return key.default_note;
        std::optional<Value> value;
        if (key.binding.load)
            value = key.binding.load(defaults);
        if (!value && !key.word_for_absent.empty())
            return quoted(key.word_for_absent);
        return value ? usual_text(key, *value) : "none";
    }
};

std::string names_of(const ReferenceRow& row) {
    std::string text;
    for (const Word& word : row.words)
        text += fmt::format("{}{}", text.empty() ? "" : " | ", word.name);
    return text;
}

std::string allowed_of(const ReferenceRow& row) {
    const std::string names = names_of(row);
    if (names.empty() || row.bounds.empty())
        return names.empty() ? row.bounds : names;
    return fmt::format("{}, or {}", row.bounds, names);
}

/// `auto`: what it means; `radial`: ...
std::string meanings_of_names(const ReferenceRow& row) {
    std::string text;
    for (const Word& word : row.words)
        if (!word.meaning.empty())
            text += fmt::format("{}`{}`: {}", text.empty() ? "" : "; ", word.name, word.meaning);
    return text;
}

std::string with_names(const ReferenceRow& row) {
    const std::string names = meanings_of_names(row);
    return names.empty() ? row.meaning : fmt::format("{} {}.", row.meaning, names);
}

std::string default_column(const ReferenceRow& row) {
    return row.is_required ? "required" : row.default_text;
}

std::string units_text(const ReferenceRow& row) {
    std::string text;
    for (const std::string& unit : row.units)
        text += fmt::format("{}{}", text.empty() ? "" : "; ", unit);
    return text;
}

std::string for_table(const std::string& text) {
    std::string escaped;
    for (const char sign : text) {
        if (sign == '|')
            escaped += '\\';
        escaped += sign;
    }
    return escaped;
}

} // namespace

std::vector<ReferenceRow> reference_rows(const KeySet& keys) {
    Collector collector;
    collector.collect(keys, "", "");
    return std::move(collector.rows);
}

std::string reference_text(const std::vector<ReferenceRow>& rows) {
    std::string text;
    std::string condition;
    for (const ReferenceRow& row : rows) {
        if (row.key == row.section && row.type == "table") {
            text += fmt::format("\n[{}]  {}{}\n", row.key, row.meaning,
                                row.is_required ? " Required." : "");
            condition.clear();
            continue;
        }
        if (row.condition != condition && !row.condition.empty())
            text += fmt::format("  with {}\n", row.condition);
        condition = row.condition;
        text += fmt::format("    {}  ({})  {}\n", row.key, row.type,
                            default_column(row) == "required"
                                ? "required"
                                : fmt::format("default {}", default_column(row)));
        text += fmt::format("        {}\n", row.meaning);
        if (const std::string allowed = allowed_of(row); !allowed.empty())
            text += fmt::format("        {}\n", allowed);
        for (const Word& word : row.words)
            if (!word.meaning.empty())
                text += fmt::format("            {}: {}\n", word.name, word.meaning);
        if (const std::string units = units_text(row); !units.empty())
            text += fmt::format("        units: {}\n", units);
    }
    return text;
}

std::string reference_markdown(const std::vector<ReferenceRow>& rows) {
    constexpr std::string_view head = "\n| key | type | unit | default | allowed | meaning |\n| "
                                      "--- | --- | --- | --- | --- | --- |\n";
    std::string text;
    std::string condition = "none yet";
    for (const ReferenceRow& row : rows) {
        if (row.key == row.section && row.type == "table") {
            text += fmt::format("\n## `[{}]`\n\n{}{}\n", row.key, row.meaning,
                                row.is_required ? " Required." : "");
            condition = "none yet";
            continue;
        }
        if (row.condition != condition) {
            if (!row.condition.empty())
                text += fmt::format("\nWith `{}`:\n", row.condition);
            text += head;
            condition = row.condition;
        }
        text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", row.key, row.type,
                            units_text(row), for_table(default_column(row)),
                            for_table(allowed_of(row)), for_table(with_names(row)));
    }
    return text;
}

} // namespace searle::casefile
