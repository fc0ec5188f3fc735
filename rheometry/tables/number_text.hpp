#pragma once

#include <string>
#include <string_view>

namespace searle::rheometry {

enum class DecimalMark { none, point, comma };

/// A number as read from text.
struct NumberText {
    enum class Outcome {
        number,
        empty,        ///< nothing but blanks
        not_a_number, ///< text, or a number followed by something
        not_finite,   ///< "nan" or "inf" in any spelling; value is set
        out_of_range  ///< a number that a double cannot hold
    };
    Outcome outcome = Outcome::empty;
    double value{};
    /// The mark that the text holds; none for an integer.
    DecimalMark mark = DecimalMark::none;
    /// A comma that may as well separate thousands: "1,000", "12,500" (read as 1 and 12.5).
    bool may_be_thousands = false;
};

/// Reads one number; blanks around it, a leading + and a decimal comma are allowed, thousands
/// separators are not.
[[nodiscard]] NumberText read_number(std::string_view text);

/// Without blanks (no-break spaces included) at either end.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// With 17 significant digits, so that reading it back gives the same double.
[[nodiscard]] std::string number_text(double value);

} // namespace searle::rheometry
