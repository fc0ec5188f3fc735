#include "casefile/node.hpp"

#include "casefile/quantity.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace searle::casefile {
namespace {

constexpr std::size_t longest_description = 60;

std::string clipped(std::string text) {
    if (text.size() <= longest_description)
        return text;
    std::size_t end = longest_description - 3;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
        --end;
    return text.substr(0, end) + "...";
}

std::string list_description(const std::vector<Node>& items) {
    std::string text = "[";
    for (const Node& item : items) {
        if (text.size() > longest_description)
            break;
        text += fmt::format("{}{}", text.size() > 1 ? ", " : "", item.described());
    }
    return text + "]";
}

std::string table_description(const std::vector<Entry>& entries) {
    std::string text = "{";
    for (const Entry& entry : entries) {
        if (text.size() > longest_description)
            break;
        text += fmt::format("{} {} = {}", text.size() > 1 ? "," : "", entry.key,
                            entry.value.described());
    }
    return text + " }";
}

} // namespace

const Entry* Node::find(std::string_view key) const {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [key](const Entry& entry) { return entry.key == key; });
    return found == entries.end() ? nullptr : &*found;
}

Entry* Node::find(std::string_view key) {
    return const_cast<Entry*>(static_cast<const Node&>(*this).find(key));
}

std::string Node::described() const {
    switch (kind) {
    case Kind::text:
        return fmt::format("\"{}\"", clipped(text));
    case Kind::integer:
        return std::to_string(integer);
    case Kind::number:
        return shortest(number);
    case Kind::boolean:
        return boolean ? "true" : "false";
    case Kind::date:
        return "a date or time of day";
    case Kind::list:
        return clipped(list_description(items));
    case Kind::table:
        return clipped(table_description(entries));
    }
    return {};
}

std::string_view Node::kind_name() const {
    switch (kind) {
    case Kind::text:
        return "a text";
    case Kind::integer:
        return "a whole number";
    case Kind::number:
        return "a number";
    case Kind::boolean:
        return "true or false";
    case Kind::date:
        return "a date or time of day";
    case Kind::list:
        return "a list";
    case Kind::table:
        return "a table";
    }
    return {};
}

} // namespace searle::casefile
