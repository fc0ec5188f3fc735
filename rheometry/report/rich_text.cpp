#include "rheometry/report/rich_text.hpp"

#include "rheometry/report/svg_path.hpp"

#include <algorithm>
#include <cstddef>

namespace searle::rheometry::report {

namespace {

constexpr double index_size = 0.72;  // size of an index relative to its line
constexpr double index_raise = 0.42; // in units of the line's font size
constexpr double index_drop = 0.22;

struct CodePoint {
    char32_t value{};
    std::size_t length = 1; // bytes
    bool valid{};
};

CodePoint decode(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[at + k]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) {
        return {lead, 1, lead >= 0x20 && lead != 0x7f};
    }
    const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || at + length > text.size()) {
        return {};
    }
    char32_t value = lead & (0xffu >> (length + 1));
    for (std::size_t k = 1; k < length; ++k) {
        if ((byte(k) & 0xc0) != 0x80) {
            return {};
        }
        value = (value << 6) | (byte(k) & 0x3fu);
    }
    constexpr char32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = value >= 0xd800 && value <= 0xdfff;
    const bool forbidden = surrogate || value == 0xfffe || value == 0xffff || value > 0x10ffff ||
                           value < smallest[length] || (value >= 0x80 && value < 0xa0);
    if (forbidden) {
        return {};
    }
    return {value, length, true};
}

// Widths in units of the font size: the wider of Helvetica's and DejaVu Sans' for each class.
double advance(char32_t c) {
    if (c >= 0x300 && c < 0x370) {
        return 0.0;
    } // combining marks
    if (c >= '0' && c <= '9') {
        return 0.636;
    }
    switch (c) {
    case ' ':
    case '.':
    case ',':
    case ':':
    case ';':
    case 'i':
    case 'j':
    case 'l':
    case '|':
    case '\'':
    case 'I':
    case 0x2009:
    case 0x202f:
        return 0.318;
    case 'f':
    case 't':
    case 'r':
    case '(':
    case ')':
    case '/':
    case '-':
    case '[':
    case ']':
        return 0.4;
    case 'm':
    case 'w':
    case 'M':
    case 'W':
    case '%':
        return 0.96;
    case '+':
    case '=':
    case '<':
    case '>':
    case 0xb1:
    case 0xd7:
    case 0x2212:
        return 0.838;
    default:
        return c >= 0x2e80 ? 1.0 : (c >= 'A' && c <= 'Z' ? 0.71 : 0.6);
    }
}

} // namespace

std::string escaped(std::string_view text) {
    std::string out;
    out.reserve(text.size() + 16);
    const auto is_plain = [](char c) {
        return c >= ' ' && c < '\x7f' && c != '&' && c != '<' && c != '>' && c != '"' && c != '\'';
    };
    for (std::size_t at = 0; at < text.size();) {
        // Nearly all text is plain: it is copied in one go.
        std::size_t end = at;
        while (end < text.size() && is_plain(text[end]))
            ++end;
        out += text.substr(at, end - at);
        at = end;
        if (at == text.size())
            break;
        const char c = text[at];
        const CodePoint point = decode(text, at);
        if (!point.valid) {
            if (c == '\n' || c == '\t') {
                out += c;
            } else {
                out += c == '\r' ? " " : "\xEF\xBF\xBD";
            }
        } else {
            switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&#39;";
                break;
            default:
                out += text.substr(at, point.length);
            }
        }
        at += point.length;
    }
    return out;
}

double text_width(std::string_view text, double font_size) {
    double total = 0.0;
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint point = decode(text, at);
        total += advance(point.value);
        at += point.length;
    }
    return total * font_size;
}

RichText& RichText::add(std::string_view text, Style style) {
    if (text.empty()) {
        return *this;
    }
    if (!runs_.empty() && runs_.back().style == style) {
        runs_.back().text += text;
    } else {
        runs_.push_back({std::string{text}, style});
    }
    return *this;
}

RichText& RichText::append(const RichText& other) {
    for (const Run& run : std::vector<Run>{other.runs_}) {
        add(run.text, run.style);
    }
    return *this;
}

std::string RichText::svg(double font_size) const {
    std::string out;
    double raised = 0.0;
    for (const Run& run : runs_) {
        const bool index = run.style == Style::superscript || run.style == Style::subscript;
        const double wanted = run.style == Style::superscript ? index_raise * font_size
                              : run.style == Style::subscript ? -index_drop * font_size
                                                              : 0.0;
        const double move = raised - wanted; // SVG's y grows downwards
        raised = wanted;
        if (!index && run.style == Style::upright && move == 0.0) {
            out += escaped(run.text);
            continue;
        }
        out += "<tspan";
        if (move != 0.0) {
            out += " dy=\"" + pixels(move) + "\"";
        }
        if (index) {
            out += " font-size=\"" + pixels(index_size * font_size) + "px\"";
        }
        if (run.style == Style::italic) {
            out += " font-style=\"italic\"";
        }
        out += ">" + escaped(run.text) + "</tspan>";
    }
    return out;
}

std::string RichText::plain() const {
    std::string out;
    for (const Run& run : runs_) {
        if (run.style == Style::superscript) {
            out += "^";
        }
        if (run.style == Style::subscript) {
            out += "_";
        }
        out += escaped(run.text);
    }
    return out;
}

double RichText::width(double font_size) const {
    double total = 0.0;
    for (const Run& run : runs_) {
        const bool index = run.style == Style::superscript || run.style == Style::subscript;
        total += text_width(run.text, index ? index_size * font_size : font_size);
    }
    return total;
}

RichText RichText::shortened(double limit, double font_size) const {
    if (width(font_size) <= limit) {
        return *this;
    }
    const double room = limit - text_width("\u2026", font_size);
    RichText out;
    double used = 0.0;
    for (const Run& run : runs_) {
        const bool index = run.style == Style::superscript || run.style == Style::subscript;
        const double size = index ? index_size * font_size : font_size;
        for (std::size_t at = 0; at < run.text.size();) {
            const CodePoint point = decode(run.text, at);
            const double step = advance(point.value) * size;
            if (used + step > room) {
                return out.upright("\u2026");
            }
            out.add(std::string_view{run.text}.substr(at, point.length), run.style);
            used += step;
            at += point.length;
        }
    }
    return out;
}

} // namespace searle::rheometry::report
