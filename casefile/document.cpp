#include "casefile/document.hpp"

#include "casefile/toml_text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <system_error>

namespace searle::casefile {
namespace {

[[noreturn]] void refuse(const std::string& name, std::string problem, std::string allowed) {
    const auto source = Source::of_file(name, "");
    throw CaseError{
        {Fault{{Place{source, 0, 0, 1}}, "", std::move(problem), std::move(allowed), ""}}};
}

constexpr std::string_view how_to_start =
    "a case file; `searle new single-gap` prints one to start from";

} // namespace

std::string read_case_text(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::not_found)
        refuse(name, "there is no such file", "");
    if (status.type() == std::filesystem::file_type::directory)
        refuse(name, "is a directory", "a case file");
    if (status.type() == std::filesystem::file_type::none ||
        status.type() == std::filesystem::file_type::unknown)
        refuse(name, fmt::format("cannot be read: {}", error.message()), "");
    if (status.type() != std::filesystem::file_type::regular)
        refuse(name, "is not a regular file", "a case file");
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (!error && size > largest_case_file)
        refuse(name, fmt::format("is {:.1f} MB large", static_cast<double>(size) / 1e6),
               fmt::format("at most {:.1f} MB", static_cast<double>(largest_case_file) / 1e6));
    std::ifstream stream{file, std::ios::binary};
    std::string text{std::istreambuf_iterator<char>{stream}, {}};
    if (!stream.is_open() || stream.bad())
        refuse(name, "cannot be read; are you allowed to?", "");
    if (text.find('\0') != std::string::npos)
        refuse(name, "is binary: it holds zero bytes", std::string{how_to_start});
    if (std::all_of(text.begin(), text.end(),
                    [](unsigned char sign) { return std::isspace(sign) != 0; }))
        refuse(name, "is empty", std::string{how_to_start});
    return text;
}

Document parse_document(std::string_view text, std::string name) {
    ParsedToml parsed = parse_toml(text, Source::of_file(std::move(name), text));
    return {std::move(parsed.root), std::move(parsed.faults)};
}

namespace {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ')
        text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ')
        text.remove_suffix(1);
    return text;
}

std::vector<std::string> parts_of(std::string_view key) {
    std::vector<std::string> parts{std::string{}};
    char quote = 0;
    for (const char sign : key) {
        if (quote != 0 ? sign == quote : (sign == '"' || sign == '\''))
            quote = quote != 0 ? 0 : sign;
        else if (sign == '.' && quote == 0)
            parts.emplace_back();
        else
            parts.back() += sign;
    }
    for (std::string& part : parts)
        part = trimmed(part);
    return parts;
}

Fault fault_at(const Assignment& assignment, std::string problem, std::string allowed = "") {
    return {{assignment.key_place}, assignment.key, std::move(problem), std::move(allowed), ""};
}

/// The item of a list that a part of a key names, counted from 1; null when there is none.
Node* item_of(Node& list, std::string_view part) {
    std::size_t number{};
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    if (error != std::errc{} || end != part.data() + part.size() || number < 1 ||
        number > list.items.size())
        return nullptr;
    return &list.items[number - 1];
}

bool holds_one_of(const Node& table, const std::string& path,
                  const std::set<std::string>& selectors) {
    return std::any_of(table.entries.begin(), table.entries.end(), [&](const Entry& entry) {
        return selectors.contains(fmt::format("{}.{}", path, entry.key));
    });
}

void merge(Node& into, const Node& value, const std::string& path,
           const std::set<std::string>& selectors) {
    if (into.kind != Node::Kind::table || value.kind != Node::Kind::table ||
        holds_one_of(value, path, selectors)) {
        into = value;
        return;
    }
    for (const Entry& entry : value.entries) {
        if (Entry* existing = into.find(entry.key)) {
            existing->key_place = entry.key_place;
            merge(existing->value, entry.value, fmt::format("{}.{}", path, entry.key), selectors);
        } else {
            into.entries.push_back(entry);
        }
    }
}

} // namespace

void parse_override(std::string_view text, std::vector<Assignment>& assignments,
                    std::vector<Fault>& faults) {
    const auto source = Source::of_override(text);
    const std::size_t equals = text.find('=');
    const std::string_view key = trimmed(text.substr(0, equals));
    const std::vector<std::string> parts = parts_of(key);
    constexpr std::size_t most_parts = 8;
    if (equals == std::string_view::npos || parts.size() > most_parts ||
        std::any_of(parts.begin(), parts.end(), [](const auto& part) { return part.empty(); })) {
        faults.push_back(
            {{Place{source, 1, 1, static_cast<int>(std::max<std::size_t>(1, text.size()))}},
             "",
             "is not an assignment",
             "key=value with a dotted key, such as --set geometry.cup_radius=\"16 mm\"",
             ""});
        return;
    }
    const std::string_view value = trimmed(text.substr(equals + 1));
    const int column = static_cast<int>(equals) + 2;
    std::optional<Node> node = parse_toml_value(value, source, column);
    if (!node) {
        node.emplace();
        node->kind = Node::Kind::text;
        node->text = value;
        node->place = {source, 1, column,
                       static_cast<int>(std::max<std::size_t>(1, text.size() - equals - 1))};
    }
    assignments.push_back({std::string{key},
                           {source, 1, 1, static_cast<int>(std::max<std::size_t>(1, key.size()))},
                           std::move(*node)});
}

void assign(Node& root, const Assignment& assignment, const std::set<std::string>& selectors,
            std::vector<Fault>& faults) {
    const std::vector<std::string> parts = parts_of(assignment.key);
    Node* at = &root;
    for (std::size_t depth = 0; depth < parts.size(); ++depth) {
        const std::string& part = parts[depth];
        if (at->kind == Node::Kind::list) {
            Node* item = item_of(*at, part);
            if (!item) {
                faults.push_back(fault_at(assignment,
                                          fmt::format("\"{}\" names no item of the list", part),
                                          fmt::format("a number from 1 to {}", at->items.size())));
                return;
            }
            at = item;
        } else if (at->kind == Node::Kind::table) {
            Entry* entry = at->find(part);
            if (!entry) {
                at->entries.push_back({part, assignment.key_place, Node{}});
                entry = &at->entries.back();
                entry->value.place = assignment.value.place;
            }
            if (depth + 1 == parts.size())
                entry->key_place = assignment.key_place;
            at = &entry->value;
        } else {
            faults.push_back(fault_at(
                assignment, fmt::format("\"{}\" lies inside a value that is {}, not a table", part,
                                        at->kind_name())));
            return;
        }
    }
    merge(*at, assignment.value, assignment.key, selectors);
}

} // namespace searle::casefile
