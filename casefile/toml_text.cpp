#include "casefile/toml_text.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <string>
#include <toml++/toml.h>
#include <utility>

namespace searle::casefile {
namespace {

using SourcePointer = std::shared_ptr<const Source>;

/// Where toml++ found something, as a place in the source.
class Places {
public:
    explicit Places(SourcePointer source) : source_{std::move(source)} {}
    /// Of an override's value: everything stands at one column of its only line.
    Places(SourcePointer source, int column) : source_{std::move(source)}, column_{column} {}

    [[nodiscard]] Place of(const toml::source_region& region) const {
        if (column_ > 0) {
            const auto rest = static_cast<int>(source_->lines.front().size()) - column_ + 1;
            return {source_, 1, column_, std::max(1, rest)};
        }
        Place place{source_, static_cast<int>(region.begin.line),
                    static_cast<int>(region.begin.column), 1};
        if (region.end.line == region.begin.line && region.end.column > region.begin.column)
            place.length = static_cast<int>(region.end.column - region.begin.column);
        else if (region.end.line > region.begin.line)
            place.length = 1000; // up to the end of the line; the excerpt is clipped to it
        return place;
    }

private:
    SourcePointer source_;
    int column_ = 0;
};

bool stands_before(const Place& one, const Place& other) {
    return std::pair{one.line, one.column} < std::pair{other.line, other.column};
}

Node node_of(const toml::node& value, const Places& places) {
    Node node;
    node.place = places.of(value.source());
    switch (value.type()) {
    case toml::node_type::table:
        node.kind = Node::Kind::table;
        for (const auto& [key, child] : *value.as_table())
            node.entries.push_back(
                {std::string{key.str()}, places.of(key.source()), node_of(child, places)});
        std::stable_sort(node.entries.begin(), node.entries.end(),
                         [](const Entry& one, const Entry& other) {
                             return stands_before(one.key_place, other.key_place);
                         });
        break;
    case toml::node_type::array:
        node.kind = Node::Kind::list;
        node.items.reserve(value.as_array()->size());
        for (const toml::node& item : *value.as_array())
            node.items.push_back(node_of(item, places));
        break;
    case toml::node_type::string:
        node.kind = Node::Kind::text;
        node.text = value.as_string()->get();
        break;
    case toml::node_type::integer:
        node.kind = Node::Kind::integer;
        node.integer = value.as_integer()->get();
        break;
    case toml::node_type::floating_point:
        node.kind = Node::Kind::number;
        node.number = value.as_floating_point()->get();
        break;
    case toml::node_type::boolean:
        node.kind = Node::Kind::boolean;
        node.boolean = value.as_boolean()->get();
        break;
    default:
        node.kind = Node::Kind::date;
        break;
    }
    return node;
}

/// A key with more parts than any case needs would nest as deep as it is long.
bool has_endless_key(std::string_view text) {
    constexpr int most_parts = 64;
    int dots = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char sign = text[at];
        if (sign == '"' || sign == '\'') {
            at = text.find_first_of(sign == '"' ? "\"\n" : "'\n", at + 1);
            if (at == std::string_view::npos)
                return false;
        } else if (sign == '#') {
            at = text.find('\n', at);
            if (at == std::string_view::npos)
                return false;
            dots = 0;
        } else if (sign == '.') {
            if (++dots >= most_parts)
                return true;
        } else if (std::string_view{"=,[]{}\n"}.find(sign) != std::string_view::npos) {
            dots = 0;
        }
    }
    return false;
}

std::string_view without_indent(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t");
    return first == std::string_view::npos ? std::string_view{} : line.substr(first);
}

/// The key of a line "key = ...", as it is written there; empty for any other line.
std::string_view key_of_line(std::string_view line) {
    const std::string_view rest = without_indent(line);
    std::size_t end = 0;
    while (end < rest.size() &&
           (std::isalnum(static_cast<unsigned char>(rest[end])) ||
            std::string_view{"_-.\"'"}.find(rest[end]) != std::string_view::npos))
        ++end;
    const std::string_view after = without_indent(rest.substr(end));
    return after.starts_with('=') ? rest.substr(0, end) : std::string_view{};
}

/// Line (from 1) of the same section on which `key`, or the header "[key]", stood before; 0: none.
int earlier_line(const Source& source, int line, std::string_view key, bool is_header) {
    const std::string header = fmt::format("[{}]", key);
    for (int earlier = line - 1; earlier >= 1; --earlier) {
        const std::string_view text = source.lines[static_cast<std::size_t>(earlier - 1)];
        if (is_header) {
            if (without_indent(text).starts_with(header))
                return earlier;
        } else {
            if (key_of_line(text) == key)
                return earlier;
            if (without_indent(text).starts_with('['))
                return 0;
        }
    }
    return 0;
}

Place start_of_line(const SourcePointer& source, int line, std::size_t length) {
    const std::string& text = source->lines[static_cast<std::size_t>(line - 1)];
    const std::size_t indent = text.size() - without_indent(text).size();
    return {source, line, static_cast<int>(indent) + 1, static_cast<int>(length)};
}

std::string without_scope(std::string_view description) {
    constexpr std::string_view scope = "Error while parsing ";
    const std::size_t colon = description.find(": ");
    if (description.starts_with(scope) && colon != std::string_view::npos)
        description.remove_prefix(colon + 2);
    return std::string{description};
}

/// What stands right of the '=', without a comment.
std::string_view value_of_line(std::string_view line) {
    std::string_view value = without_indent(line.substr(std::min(line.size(), line.find('=') + 1)));
    value = value.substr(0, value.find('#'));
    while (value.ends_with(' ') || value.ends_with('\t'))
        value.remove_suffix(1);
    return value;
}

/// The user wrote 14 mm or steady where "14 mm" or "steady" was meant.
bool lacks_quotes(std::string_view value) {
    const auto is_letter = [](char sign) {
        return std::isalpha(static_cast<unsigned char>(sign)) != 0 || sign == '%';
    };
    return std::any_of(value.begin(), value.end(), is_letter) &&
           value.find_first_of("\"'[]{}") == std::string_view::npos;
}

bool has_open_quote(std::string_view value) {
    return std::count(value.begin(), value.end(), '"') % 2 != 0;
}

struct SyntaxError {
    Fault fault;
    int line{};
    bool stands_alone{}; ///< the rest of the file makes sense without this line
};

SyntaxError syntax_error(const toml::parse_error& error, const SourcePointer& source) {
    const int last_line = std::max<int>(1, static_cast<int>(source->lines.size()));
    SyntaxError result;
    result.line = std::clamp(static_cast<int>(error.source().begin.line), 1, last_line);
    const int column = static_cast<int>(error.source().begin.column);
    const std::string& line = source->lines[static_cast<std::size_t>(result.line - 1)];
    const std::string_view key = key_of_line(line);
    const std::string description = without_scope(error.description());

    const bool redefined = description.find("cannot redefine existing") != std::string::npos;
    const bool header = without_indent(line).starts_with('[');
    if (redefined && (header || !key.empty())) {
        std::string_view name = key;
        if (header) {
            name = without_indent(line);
            name.remove_prefix(std::min(name.size(), name.find_first_not_of('[')));
            name = name.substr(0, name.find(']'));
        }
        result.fault.places.push_back(
            start_of_line(source, result.line, name.size() + (header ? 2 : 0)));
        if (const int earlier = earlier_line(*source, result.line, name, header)) {
            result.fault.problem =
                fmt::format("{} is given twice, first on line {}", name, earlier);
            result.fault.places.push_back(
                start_of_line(source, earlier, name.size() + (header ? 2 : 0)));
        } else {
            result.fault.problem = fmt::format("{} is given twice", name);
        }
        result.fault.allowed = header ? "each section once" : "each key once";
        result.stands_alone = !header;
        return result;
    }

    result.fault.places.push_back({source, result.line, std::max(1, column), 1});
    const std::string_view value = value_of_line(line);
    if (!key.empty() && (lacks_quotes(value) || has_open_quote(value))) {
        const bool no_quotes = lacks_quotes(value);
        result.fault.places.front() = start_of_line(source, result.line, line.size());
        result.fault.problem =
            fmt::format("{} is not TOML: {}", value,
                        no_quotes ? "a text, and a number with a unit, stand in quotes"
                                  : "a quote is not closed");
        if (no_quotes)
            result.fault.suggestion = fmt::format("{} = \"{}\"", key, value);
        result.stands_alone = value.find("\"\"\"") == std::string_view::npos;
        return result;
    }
    result.fault.problem = "not TOML: " + description;
    const std::size_t equals = line.find('=');
    const auto count = [&line](char sign) { return std::count(line.begin(), line.end(), sign); };
    result.stands_alone = !key.empty() && static_cast<std::size_t>(column) > equals + 1 &&
                          count('[') == count(']') && count('{') == count('}');
    return result;
}

std::size_t start_of(std::string_view text, int line) {
    std::size_t at = 0;
    for (int passed = 1; passed < line; ++passed) {
        const std::size_t end = text.find('\n', at);
        if (end == std::string_view::npos)
            return text.size();
        at = end + 1;
    }
    return at;
}

void blank_line(std::string& text, int line) {
    for (std::size_t at = start_of(text, line); at < text.size() && text[at] != '\n'; ++at)
        text[at] = ' ';
}

} // namespace

ParsedToml parse_toml(std::string_view text, SourcePointer source) {
    constexpr std::size_t most_syntax_faults = 20;
    ParsedToml parsed;
    parsed.root.place = {source, 0, 0, 1};
    if (has_endless_key(text)) {
        parsed.faults.push_back({{{source, 0, 0, 1}}, "", "a key has more than 64 parts", "", ""});
        return parsed;
    }
    std::string readable{text};
    int last_line = 0;
    while (true) {
        try {
            const toml::table table = toml::parse(std::string_view{readable});
            Node root = node_of(table, Places{source});
            root.place = parsed.root.place;
            parsed.root = std::move(root);
            return parsed;
        } catch (const toml::parse_error& thrown) {
            SyntaxError error = syntax_error(thrown, source);
            const bool goes_on =
                error.line > last_line && parsed.faults.size() < most_syntax_faults;
            if (!goes_on)
                return parsed;
            last_line = error.line;
            if (error.stands_alone) {
                blank_line(readable, error.line);
            } else {
                readable.resize(start_of(readable, error.line));
                error.fault.problem += "; the file is read up to here only";
                last_line = static_cast<int>(source->lines.size()) + 1;
            }
            parsed.faults.push_back(std::move(error.fault));
        }
    }
}

std::optional<Node> parse_toml_value(std::string_view text, SourcePointer source, int column) {
    if (has_endless_key(text) || text.find('\n') != std::string_view::npos)
        return std::nullopt;
    try {
        const toml::table table = toml::parse(fmt::format("value = {}", text));
        if (table.size() != 1)
            return std::nullopt;
        return node_of(*table.get("value"), Places{std::move(source), column});
    } catch (const toml::parse_error&) {
        return std::nullopt;
    }
}

} // namespace searle::casefile
