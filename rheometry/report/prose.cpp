#include "rheometry/report/prose.hpp"

#include "rheometry/report/rich_text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace searle::rheometry::report {

namespace {

struct Symbol {
    std::string_view word;
    std::string_view html;
    bool stands_alone; ///< a symbol also without an index
};
constexpr std::array<Symbol, 13> symbols{{{"tau", "<i>\u03c4</i>", true},
                                          {"eta", "<i>\u03b7</i>", true},
                                          {"omega", "<i>\u03c9</i>", true},
                                          {"gamma", "<i>\u03b3</i>", true},
                                          {"delta", "<i>\u03b4</i>", true},
                                          {"nu", "<i>\u03bd</i>", true},
                                          {"rho", "<i>\u03c1</i>", true},
                                          {"Re", "Re", false},
                                          {"c", "<i>c</i>", false},
                                          {"R", "<i>R</i>", false},
                                          {"M", "<i>M</i>", false},
                                          {"T", "<i>T</i>", false},
                                          {"k", "<i>k</i>", false}}};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

// The exponent after '^': "(...)" without its brackets, or digits with a sign. Its length in the
// text is 0 when there is none.
struct Exponent {
    std::string_view text;
    std::size_t length{};
};
Exponent exponent_at(std::string_view rest) {
    if (rest.starts_with('(')) {
        const std::size_t end = rest.find(')');
        const bool closed = end != std::string_view::npos && end > 1;
        return closed ? Exponent{rest.substr(1, end - 1), end + 1} : Exponent{};
    }
    std::size_t end = rest.starts_with('-') ? 1 : 0;
    const std::size_t first_digit = end;
    while (end < rest.size() && is_digit(rest[end])) {
        ++end;
    }
    return end > first_digit ? Exponent{rest.substr(0, end), end} : Exponent{};
}

std::string word_html(std::string_view word) {
    const std::size_t mark = word.find('_');
    const std::string_view head = word.substr(0, mark);
    const auto* symbol = std::find_if(symbols.begin(), symbols.end(),
                                      [&](const Symbol& known) { return known.word == head; });
    if (symbol == symbols.end()) {
        return escaped(word);
    }
    if (mark == std::string_view::npos) {
        return symbol->stands_alone ? std::string{symbol->html} : std::string{word};
    }
    const std::string_view index = word.substr(mark + 1);
    const bool is_index = !index.empty() && index.find('_') == std::string_view::npos;
    return is_index ? std::string{symbol->html} + "<sub>" + escaped(index) + "</sub>"
                    : escaped(word);
}

} // namespace

std::string prose_html(std::string_view text) {
    std::string out;
    std::size_t at = 0;
    while (at < text.size()) {
        if (text[at] == '^') {
            const Exponent exponent = exponent_at(text.substr(at + 1));
            if (exponent.length > 0) {
                out += "<sup>" + escaped(exponent.text) + "</sup>";
                at += 1 + exponent.length;
                continue;
            }
        }
        std::size_t end = at;
        if (is_letter(text[at])) {
            while (end < text.size() && is_word(text[end])) {
                ++end;
            }
            // "geometry.tau" or "tau.x" are keys, "end-tau" a name.
            const bool in_name = at > 0 && (text[at - 1] == '.' || text[at - 1] == '-') && at > 1 &&
                                 is_word(text[at - 2]);
            const std::string_view word = text.substr(at, end - at);
            out += in_name ? escaped(word) : word_html(word);
        } else {
            while (end < text.size() && !is_letter(text[end]) && (text[end] != '^' || end == at)) {
                ++end;
            }
            out += escaped(text.substr(at, end - at));
        }
        at = end;
    }
    return out;
}

} // namespace searle::rheometry::report
