#include "casefile/key.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <stdexcept>

namespace searle::casefile {
namespace {

/// Bounds are part of the program: a text that cannot be read is a fault of the program.
Bound bound_of(const Takes& takes, const std::string& text, bool included) {
    double number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc{} && end == text.data() + text.size())
        return {number, included, text};
    const auto parsed = parse_quantity(text, takes.quantities);
    if (const auto* quantity = std::get_if<Quantity>(&parsed))
        return {quantity->value, included, text};
    throw std::logic_error(fmt::format("a key is declared with the bound \"{}\"", text));
}

std::string joined(const std::vector<std::string>& parts, std::string_view last_word) {
    std::string text;
    for (std::size_t at = 0; at < parts.size(); ++at) {
        if (at > 0)
            text += at + 1 == parts.size() ? fmt::format(" {} ", last_word) : ", ";
        text += parts[at];
    }
    return text;
}

std::string item_text(const Takes& takes) {
    std::vector<std::string> parts;
    for (const QuantityKind& kind : takes.quantities)
        if (kind.dimension != fraction.dimension)
            parts.emplace_back(kind.name);
    if (takes.integer)
        parts.emplace_back("a whole number");
    if (takes.number)
        parts.emplace_back(takes.quantities.empty() ? "a number" : "a number or a text in %");
    if (takes.text)
        parts.emplace_back("a text");
    std::string text = joined(parts, "or");
    const std::string bounds = bounds_text(takes);
    if (!bounds.empty())
        text += fmt::format("{}{}", text.empty() ? "" : ", ", bounds);
    std::vector<std::string> names;
    for (const Word& word : takes.words)
        names.push_back(fmt::format("\"{}\"", word.name));
    if (takes.boolean)
        names.emplace_back("true or false");
    if (!names.empty())
        text += (text.empty() ? "" : ", or ") + joined(names, "or");
    return text;
}

} // namespace

Key& Key::says(std::string text) {
    sentence = std::move(text);
    return *this;
}
Key& Key::required() {
    is_required = true;
    return *this;
}
Key& Key::example(std::string text) {
    example_text = std::move(text);
    return *this;
}
Key& Key::defaults_to(std::string note) {
    default_note = std::move(note);
    return *this;
}
Key& Key::measures(std::vector<QuantityKind> kinds) {
    takes.quantities = std::move(kinds);
    return *this;
}
Key& Key::measures(const QuantityKind& kind) { return measures(std::vector{kind}); }
Key& Key::is_number() {
    takes.number = true;
    return *this;
}
Key& Key::is_integer() {
    takes.integer = true;
    return *this;
}
Key& Key::is_boolean() {
    takes.boolean = true;
    return *this;
}
Key& Key::is_text() {
    takes.text = true;
    return *this;
}
Key& Key::word(std::string word_name, std::string meaning) {
    takes.words.push_back({std::move(word_name), std::move(meaning)});
    return *this;
}
Key& Key::or_absent_as(std::string word_name, std::string meaning) {
    word_for_absent = word_name;
    return word(std::move(word_name), std::move(meaning));
}
Key& Key::is_list(std::size_t fewest, std::size_t most) {
    takes.list = true;
    takes.fewest_items = fewest;
    takes.most_items = most;
    return *this;
}
Key& Key::above(const std::string& bound) {
    takes.lower = bound_of(takes, bound, false);
    return *this;
}
Key& Key::at_least(const std::string& bound) {
    takes.lower = bound_of(takes, bound, true);
    return *this;
}
Key& Key::below(const std::string& bound) {
    takes.upper = bound_of(takes, bound, false);
    return *this;
}
Key& Key::at_most(const std::string& bound) {
    takes.upper = bound_of(takes, bound, true);
    return *this;
}
Key& Key::not_in_new() {
    is_in_new = false;
    return *this;
}
Key& Key::given_in_new() {
    is_needed_in_new = true;
    return *this;
}
Key& Key::offered_in_new() {
    is_offered_in_new = true;
    return *this;
}

const Key* KeySet::find(std::string_view name) const {
    const auto found =
        std::find_if(keys.begin(), keys.end(), [name](const Key& key) { return key.name == name; });
    return found == keys.end() ? nullptr : &*found;
}

std::set<std::string> selector_keys(const KeySet& whole_file) {
    std::set<std::string> keys;
    for (const Key& section : whole_file.keys)
        if (section.table && section.table->selector)
            keys.insert(fmt::format("{}.{}", section.name, section.table->selector->name));
    return keys;
}

std::string example_as_toml(const Key& key) {
    const std::string& text = key.example_text;
    if (text.empty() || text.front() == '[' || text.front() == '{')
        return text;
    double number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_bare = (error == std::errc{} && end == text.data() + text.size()) ||
                         (key.takes.boolean && (text == "true" || text == "false"));
    return is_bare && !key.takes.text ? text : fmt::format("\"{}\"", text);
}

std::string bounds_text(const Takes& takes) {
    std::string text;
    if (takes.lower)
        text +=
            fmt::format("{} {}", takes.lower->included ? "at least" : "above", takes.lower->text);
    if (takes.lower && takes.upper)
        text += " and ";
    if (takes.upper)
        text +=
            fmt::format("{} {}", takes.upper->included ? "at most" : "below", takes.upper->text);
    return text;
}

std::string allowed_by(const Key& key) {
    const Takes& takes = key.takes;
    std::vector<std::string> parts;
    const std::string item = item_text(takes);
    if (takes.list)
        parts.push_back(
            takes.fewest_items == takes.most_items
                ? fmt::format("a list of {}, each {}", takes.fewest_items, item)
                : fmt::format("a list of at least {}, each {}", takes.fewest_items, item));
    else if (!item.empty())
        parts.push_back(item);
    if (takes.table || takes.free_table)
        parts.emplace_back("a table");
    if (takes.table_list)
        parts.emplace_back("a list of tables");
    std::string text = joined(parts, "or");
    const std::string example = example_as_toml(key);
    if (!example.empty() && (takes.words.empty() || !takes.quantities.empty() || takes.number))
        text += ", such as " + example;
    return text;
}

} // namespace searle::casefile
