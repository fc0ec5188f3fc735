#include "app/starting_case.hpp"

#include "app/case_keys.hpp"
#include "casefile/document.hpp"
#include "casefile/reading.hpp"
#include "casefile/writing.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace searle::app {
namespace {

void add_needed_values(const casefile::KeySet& keys, std::string& text) {
    for (const casefile::Key& key : keys.keys)
        if (key.is_required || key.is_needed_in_new)
            text += fmt::format("{} = {}\n", key.name, casefile::example_as_toml(key));
}

/// The examples of all keys that must be given; the first alternative where several are possible.
std::string needed_values(const std::string& geometry) {
    std::string text;
    for (const casefile::Key& section : case_keys().set()->keys) {
        if (!section.is_required || !section.table)
            continue;
        text += fmt::format("[{}]\n", section.name);
        if (const auto& selector = section.table->selector) {
            const auto& alternatives = selector->alternatives;
            const auto chosen =
                std::find_if(alternatives.begin(), alternatives.end(),
                             [&geometry](const auto& one) { return one.name == geometry; });
            const auto& used = chosen == alternatives.end() ? alternatives.front() : *chosen;
            text += fmt::format("{} = \"{}\"\n", selector->name, used.name);
            add_needed_values(*used.keys, text);
        }
        add_needed_values(*section.table, text);
    }
    return text;
}

constexpr std::string_view heading =
    "# A case for searle: `searle check FILE`, `searle plan FILE`, "
    "`searle run FILE`.\n"
    "# Every key that exists: `searle schema`.\n\n";

} // namespace

std::vector<std::string> geometry_names() {
    const std::shared_ptr<const casefile::KeySet> keys = geometry::geometry_keys().set();
    std::vector<std::string> names;
    for (const casefile::Selector::Alternative& alternative : keys->selector->alternatives)
        names.push_back(alternative.name);
    return names;
}

std::string starting_case(const std::string& geometry) {
    const casefile::Document document =
        casefile::parse_document(needed_values(geometry), "the examples");
    CaseAsWritten written;
    casefile::Reading reading;
    casefile::read_keys(*case_keys().set(), document.root, "", &written, reading);
    if (!reading.faults.empty())
        throw std::logic_error(casefile::CaseError{reading.faults}.what());
    written.title = fmt::format("Water in a {}", geometry);
    resolve(written);
    return std::string{heading} +
           casefile::write_toml(*case_keys().set(), &written, casefile::WritingStyle::annotated);
}

} // namespace searle::app
