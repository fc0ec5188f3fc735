#include "rheometry/report/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace searle::rheometry::report {

namespace {

constexpr std::string_view minus_sign = "\u2212";
constexpr std::string_view thin_space = "\u202f";

std::string superscript_integer(int number) {
    constexpr std::array<std::string_view, 10> digits{"\u2070", "\u00b9", "\u00b2", "\u00b3",
                                                      "\u2074", "\u2075", "\u2076", "\u2077",
                                                      "\u2078", "\u2079"};
    std::string out = number < 0 ? "\u207b" : "";
    for (const char c : std::to_string(std::abs(number))) {
        out += digits[static_cast<std::size_t>(c - '0')];
    }
    return out;
}

void drop_trailing_zeros(std::string& digits) {
    if (digits.find('.') == std::string::npos) {
        return;
    }
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') {
        digits.pop_back();
    }
}

/// The value with so many digits after the point, >= 0 and below 1e18 where the format is fixed.
std::string text_of(double value, std::chars_format format, int digits) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, format, digits).ptr;
    return {text.data(), end};
}

std::string number_text(double value, int digits, bool keep_zeros) {
    if (!std::isfinite(value)) {
        return "\u2013";
    }
    if (value == 0.0) {
        return "0";
    }
    digits = std::clamp(digits, 1, 17);
    // The exponent after rounding: 9.996 to three digits is 10.0.
    const std::string scientific =
        text_of(std::abs(value), std::chars_format::scientific, digits - 1);
    const std::size_t mark = scientific.find('e');
    const int exponent = std::atoi(scientific.c_str() + mark + 1);
    std::string text;
    if (exponent >= -4 && exponent < std::max(digits, 6)) {
        // Digits before the point beyond the significant ones are zeros.
        const double rounded = exponent < digits ? std::abs(value) : std::atof(scientific.c_str());
        text = text_of(rounded, std::chars_format::fixed, std::max(0, digits - 1 - exponent));
        if (!keep_zeros) {
            drop_trailing_zeros(text);
        }
    } else {
        std::string mantissa = scientific.substr(0, mark);
        if (!keep_zeros) {
            drop_trailing_zeros(mantissa);
        }
        text = mantissa == "1" ? "" : fmt::format("{0}{1}\u00d7{1}", mantissa, thin_space);
        text += "10" + superscript_integer(exponent);
    }
    return value < 0.0 ? fmt::format("{}{}", minus_sign, text) : text;
}

} // namespace

std::string significant(double value, int digits) { return number_text(value, digits, false); }

std::string significant_padded(double value, int digits) {
    return number_text(value, digits, true);
}

std::string rounded_to_error(double value, double error) {
    if (!std::isfinite(value) || value == 0.0) {
        return significant(value, 1);
    }
    if (!std::isfinite(error) || error <= 0.0) {
        return significant(value, 10);
    }
    const double leading = std::floor(std::log10(std::abs(value)));
    const double last = std::floor(std::log10(error)) - 1.0;
    const double digits = std::clamp(leading - last + 1.0, 3.0, 15.0);
    return significant_padded(value, static_cast<int>(digits));
}

std::optional<int> common_decimals(std::span<const double> values) {
    constexpr int digits = 7;
    constexpr double most_decades = 1e4;
    double largest = 0.0;
    double smallest = std::numeric_limits<double>::infinity();
    for (const double value : values) {
        if (!std::isfinite(value) || value == 0.0) {
            continue;
        }
        largest = std::max(largest, std::abs(value));
        smallest = std::min(smallest, std::abs(value));
    }
    if (largest < 1e-3 || largest >= 1e6 || largest > most_decades * smallest) {
        return std::nullopt;
    }
    const int most = std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(largest))));
    int needed = 0;
    for (const double value : values) {
        if (!std::isfinite(value)) {
            continue;
        }
        std::string text = fmt::format("{:.{}f}", value, most);
        drop_trailing_zeros(text);
        const std::size_t point = text.find('.');
        if (point != std::string::npos) {
            needed = std::max(needed, static_cast<int>(text.size() - point) - 1);
        }
    }
    return needed;
}

std::string with_decimals(double value, int decimals) {
    if (!std::isfinite(value)) {
        return "\u2013";
    }
    const std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
    const bool is_zero = text.find_first_not_of("0.") == std::string::npos;
    return value < 0.0 && !is_zero ? fmt::format("{}{}", minus_sign, text) : text;
}

std::string relative_text(double fraction, int digits) {
    if (!std::isfinite(fraction)) {
        return "\u2013";
    }
    if (fraction == 0.0) {
        return "0";
    }
    if (std::abs(fraction) < 1e-5) {
        return significant(fraction, digits);
    }
    return significant(100.0 * fraction, digits) + "\u00a0%";
}

DisplayUnit display_unit(std::string_view si_unit, double largest) {
    std::string name;
    for (const char c : si_unit) {
        if (c == '.') {
            name += "\u00a0";
        } else if (c == ' ') {
            name += "\u00a0";
        } else {
            name += c;
        }
    }
    if (si_unit == "1" || si_unit.empty()) {
        return {1.0, ""};
    }
    const bool length = si_unit == "m";
    const bool takes_prefix = si_unit.starts_with("Pa") || si_unit.starts_with("N") ||
                              si_unit == "s" || length || si_unit == "m/s";
    const double size = std::abs(largest);
    if (!takes_prefix || si_unit.find('^') != std::string_view::npos || !std::isfinite(size) ||
        size == 0.0) {
        if (const std::size_t power = name.find('^'); power != std::string::npos) {
            const std::string_view exponent = std::string_view{name}.substr(power + 1);
            const std::string raised = exponent == "2"   ? "\u00b2"
                                       : exponent == "3" ? "\u00b3"
                                       : exponent == "n" ? "\u207f"
                                                         : "^" + std::string{exponent};
            name = name.substr(0, power) + raised;
        }
        return {1.0, name};
    }
    // 0.9995 and 1 are shown alike, so the step to the next prefix leaves room for rounding.
    constexpr double rounding = 1.0 + 1e-9;
    if (length && size * rounding >= 1e-4 && size < 1.0) {
        return {1e3, "mm"};
    }
    struct Prefix {
        double per_si;
        std::string_view letter;
    };
    constexpr std::array<Prefix, 8> prefixes{{{1e-9, "G"},
                                              {1e-6, "M"},
                                              {1e-3, "k"},
                                              {1.0, ""},
                                              {1e3, "m"},
                                              {1e6, "\u00b5"},
                                              {1e9, "n"},
                                              {1e12, "p"}}};
    const std::size_t first = length || si_unit == "s" || si_unit == "m/s" ? 3 : 0;
    for (std::size_t k = first; k < prefixes.size(); ++k) {
        if (size * prefixes[k].per_si * rounding >= 1.0 || k + 1 == prefixes.size()) {
            return {prefixes[k].per_si, std::string{prefixes[k].letter} + name};
        }
    }
    return {1.0, name};
}

std::string quantity_text(double value, std::string_view si_unit, int digits) {
    const DisplayUnit unit = display_unit(si_unit, value);
    const std::string number = significant(value * unit.per_si, digits);
    return unit.name.empty() ? number : number + "\u00a0" + unit.name;
}

} // namespace searle::rheometry::report
