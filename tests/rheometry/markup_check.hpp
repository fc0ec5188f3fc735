#pragma once

#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace searle::test {

/// What is wrong with a piece of XML (tags that do not balance, attributes without quotes, a bare
/// '&' or '<'), or nothing. Knows elements, attributes, the declaration and <style> text.
inline std::string markup_fault(std::string_view text) {
    std::vector<std::string> open;
    const auto is_name = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == ':' || c == '_';
    };
    std::size_t at = 0;
    const auto context = [&] { return std::string{text.substr(at, 60)}; };
    const auto entity_is_whole = [&](std::size_t where) {
        const std::size_t end = text.find(';', where);
        return end != std::string_view::npos && end - where <= 8 && end > where + 1;
    };
    while (at < text.size()) {
        if (text[at] == '&') {
            if (!entity_is_whole(at)) {
                return "bare & at: " + context();
            }
            ++at;
            continue;
        }
        if (text[at] != '<') {
            ++at;
            continue;
        }
        if (text.substr(at, 2) == "<?") {
            at = text.find("?>", at) + 2;
            continue;
        }
        const bool closes = at + 1 < text.size() && text[at + 1] == '/';
        std::size_t end = at + (closes ? 2 : 1);
        const std::size_t name_start = end;
        while (end < text.size() && is_name(text[end])) {
            ++end;
        }
        const std::string name{text.substr(name_start, end - name_start)};
        if (name.empty()) {
            return "bare < at: " + context();
        }
        bool empty_element = false;
        for (;;) {
            while (end < text.size() && std::isspace(static_cast<unsigned char>(text[end])) != 0) {
                ++end;
            }
            if (end >= text.size()) {
                return "unfinished tag at: " + context();
            }
            if (text[end] == '>') {
                break;
            }
            if (text.substr(end, 2) == "/>") {
                empty_element = true;
                ++end;
                break;
            }
            const std::size_t attribute_start = end;
            while (end < text.size() && is_name(text[end])) {
                ++end;
            }
            if (end == attribute_start || text.substr(end, 2) != "=\"") {
                return "attribute without a quoted value at: " + context();
            }
            const std::size_t value_start = end + 2;
            end = text.find('"', value_start);
            if (end == std::string_view::npos) {
                return "open quote at: " + context();
            }
            const std::string_view value = text.substr(value_start, end - value_start);
            if (value.find('<') != std::string_view::npos) {
                return "< in an attribute at: " + context();
            }
            ++end;
        }
        if (closes) {
            if (open.empty() || open.back() != name) {
                return "</" + name + "> closes nothing at: " + context();
            }
            open.pop_back();
        } else if (!empty_element) {
            open.push_back(name);
        }
        at = end + 1;
        if (name == "style" && !closes) {
            at = text.find("</style>", at);
        }
    }
    return open.empty() ? "" : "<" + open.back() + "> is never closed";
}

/// The first "nan" or "inf" that stands where a number would, with what is around it, or nothing.
inline std::string not_a_number_in(std::string_view text) {
    for (const std::string_view word : {"nan", "inf"}) {
        for (std::size_t at = text.find(word); at != std::string_view::npos;
             at = text.find(word, at + 1)) {
            const auto is_letter = [&](std::size_t k) {
                return k < text.size() && std::isalpha(static_cast<unsigned char>(text[k])) != 0;
            };
            if (!is_letter(at + 3) && (at == 0 || !is_letter(at - 1))) {
                return std::string{text.substr(at < 30 ? 0 : at - 30, 60)};
            }
        }
    }
    return "";
}

/// Every <svg> element of a page.
inline std::vector<std::string> drawings_in(std::string_view page) {
    std::vector<std::string> drawings;
    constexpr std::string_view end_tag = "</svg>";
    for (std::size_t at = page.find("<svg"); at != std::string_view::npos;
         at = page.find("<svg", at)) {
        const std::size_t end = page.find(end_tag, at);
        drawings.emplace_back(page.substr(at, end + end_tag.size() - at));
        at = end;
    }
    return drawings;
}

/// How often a text stands in another.
inline std::size_t count_of(std::string_view text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos;
         at = text.find(part, at + part.size())) {
        ++count;
    }
    return count;
}

} // namespace searle::test
