#include "casefile/fault.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace searle::casefile {
namespace {

constexpr std::size_t longest_excerpt = 110;
constexpr std::size_t most_faults_in_text = 100;

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// Byte at which the character with this number (from 0) starts.
std::size_t byte_of_character(std::string_view text, std::size_t character) {
    std::size_t at = 0;
    for (; at < text.size(); ++at) {
        if (continues_character(text[at]))
            continue;
        if (character-- == 0)
            break;
    }
    return at;
}

std::size_t count_characters(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char byte) { return !continues_character(byte); }));
}

/// Control signs would move the cursor of a terminal.
std::string printable(std::string_view text) {
    std::string result;
    for (const char byte : text)
        result += byte == '\t'
                      ? ' '
                      : (static_cast<unsigned char>(byte) < 0x20U || byte == 0x7f ? '?' : byte);
    return result;
}

std::string excerpt(const Place& place) {
    if (place.line < 1 || place.line > static_cast<int>(place.source->lines.size()))
        return {};
    const std::string& line = place.source->lines[static_cast<std::size_t>(place.line - 1)];
    std::size_t column = static_cast<std::size_t>(std::max(place.column, 1) - 1);
    std::size_t start = 0;
    std::string_view before, after;
    const std::size_t characters = count_characters(line);
    column = std::min(column, characters);
    if (characters > longest_excerpt) {
        start = column > 30 ? column - 30 : 0;
        before = start > 0 ? "..." : "";
        after = characters > start + longest_excerpt ? "..." : "";
    }
    const std::size_t first = byte_of_character(line, start);
    const std::string_view rest = std::string_view{line}.substr(first);
    const std::string_view shown = rest.substr(0, byte_of_character(rest, longest_excerpt));
    const std::size_t shown_characters = count_characters(shown);
    const std::size_t carets = std::clamp<std::size_t>(
        static_cast<std::size_t>(std::max(place.length, 1)), 1,
        std::max<std::size_t>(1, shown_characters - std::min(shown_characters, column - start)));
    const std::string number = place.source->is_file ? fmt::format("{:>5}", place.line) : "     ";
    return fmt::format("\n{} | {}{}{}\n      | {}{}", number, before, printable(shown), after,
                       std::string(before.size() + column - start, ' '), std::string(carets, '^'));
}

std::string position(const Place& place) {
    if (!place.source->is_file || place.line < 1)
        return place.source->name;
    return fmt::format("{}:{}:{}", place.source->name, place.line, place.column);
}

bool comes_first(const Fault& one, const Fault& other) {
    if (one.places.empty() || other.places.empty())
        return one.places.size() < other.places.size();
    const Place& a = one.places.front();
    const Place& b = other.places.front();
    if (a.source->is_file != b.source->is_file)
        return a.source->is_file;
    return std::pair{a.line, a.column} < std::pair{b.line, b.column};
}

} // namespace

std::string Fault::text() const {
    std::string result;
    if (!places.empty())
        result += position(places.front()) + ": ";
    if (!key.empty())
        result += key + ": ";
    result += problem;
    for (std::size_t at = 0; at < places.size(); ++at) {
        if (at > 0 && places[at].source != places.front().source)
            result += "\n  and " + position(places[at]);
        result += excerpt(places[at]);
    }
    if (!allowed.empty())
        result += "\n      = allowed: " + allowed;
    if (!suggestion.empty())
        result += "\n      = did you mean " + suggestion + "?";
    return result;
}

CaseError::CaseError(std::vector<Fault> faults) : faults_{std::move(faults)} {
    std::stable_sort(faults_.begin(), faults_.end(), comes_first);
    for (std::size_t at = 0; at < std::min(faults_.size(), most_faults_in_text); ++at)
        text_ += faults_[at].text() + "\n";
    text_ += faults_.size() == 1 ? "1 fault" : fmt::format("{} faults", faults_.size());
    if (faults_.size() > most_faults_in_text)
        text_ += fmt::format(", of which the first {} are shown", most_faults_in_text);
}

} // namespace searle::casefile
