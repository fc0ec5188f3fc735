#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace searle::rheometry::report {

/// A line of text with symbols and indices, to be written as SVG or plain.
/// Every text is escaped on writing; input that is not valid UTF-8 is replaced by U+FFFD.
class RichText {
public:
    enum class Style { upright, italic, superscript, subscript };

    RichText() = default;
    explicit RichText(std::string_view upright_text) { upright(upright_text); }

    RichText& upright(std::string_view text) { return add(text, Style::upright); }
    RichText& italic(std::string_view text) { return add(text, Style::italic); }
    RichText& superscript(std::string_view text) { return add(text, Style::superscript); }
    RichText& subscript(std::string_view text) { return add(text, Style::subscript); }
    RichText& append(const RichText& other);

    [[nodiscard]] bool empty() const { return runs_.empty(); }
    /// Content of an SVG <text> element whose font size is `font_size` pixels.
    [[nodiscard]] std::string svg(double font_size) const;
    /// Letters only, escaped, for tooltips and attributes.
    [[nodiscard]] std::string plain() const;
    /// Estimated width in pixels; on the safe (wide) side for common sans-serif fonts.
    [[nodiscard]] double width(double font_size) const;
    /// The same text cut to at most `limit` pixels, with an ellipsis where it was cut.
    [[nodiscard]] RichText shortened(double limit, double font_size) const;

private:
    struct Run {
        std::string text;
        Style style;
    };
    RichText& add(std::string_view text, Style style);
    std::vector<Run> runs_;
};

/// Text made safe for the content and the quoted attributes of HTML and XML.
[[nodiscard]] std::string escaped(std::string_view text);

/// Estimated width in pixels of upright sans-serif text.
[[nodiscard]] double text_width(std::string_view text, double font_size);

} // namespace searle::rheometry::report
