#include "rheometry/tables/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace searle::rheometry {
namespace {

constexpr std::string_view no_break_space = "\xC2\xA0";

NumberText from_point_text(std::string_view text, DecimalMark mark) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc::invalid_argument || stopped != end)
        return {.outcome = NumberText::Outcome::not_a_number};
    if (error == std::errc::result_out_of_range)
        return {.outcome = NumberText::Outcome::out_of_range};
    return {.outcome = std::isfinite(value) ? NumberText::Outcome::number
                                            : NumberText::Outcome::not_finite,
            .value = value,
            .mark = mark};
}

/// One to three digits, the first not 0, a comma, and just three digits.
bool is_group_of_three(std::string_view text, std::size_t comma) {
    const std::size_t sign = text.front() == '-' ? 1 : 0;
    const std::size_t before = comma - sign;
    return comma > sign && before <= 3 && text[sign] != '0' && text.size() == comma + 4 &&
           text.find_first_not_of("0123456789,", sign) == std::string_view::npos;
}

} // namespace

std::string_view trimmed(std::string_view text) {
    while (true) {
        if (!text.empty() && (text.front() == ' ' || text.front() == '\t'))
            text.remove_prefix(1);
        else if (!text.empty() && (text.back() == ' ' || text.back() == '\t'))
            text.remove_suffix(1);
        else if (text.starts_with(no_break_space))
            text.remove_prefix(no_break_space.size());
        else if (text.ends_with(no_break_space))
            text.remove_suffix(no_break_space.size());
        else
            return text;
    }
}

NumberText read_number(std::string_view text) {
    text = trimmed(text);
    if (text.empty())
        return {};
    if (text.front() == '+' && text.size() > 1 && text[1] != '-')
        text.remove_prefix(1);
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos)
        return from_point_text(text, text.find('.') == std::string_view::npos ? DecimalMark::none
                                                                              : DecimalMark::point);
    std::array<char, 64> with_point{};
    if (text.size() > with_point.size() || text.find('.') != std::string_view::npos ||
        text.find(',', comma + 1) != std::string_view::npos)
        return {.outcome = NumberText::Outcome::not_a_number};
    text.copy(with_point.data(), text.size());
    with_point[comma] = '.';
    NumberText number = from_point_text({with_point.data(), text.size()}, DecimalMark::comma);
    number.may_be_thousands = is_group_of_three(text, comma);
    return number;
}

std::string number_text(double value) { return fmt::format("{:.17g}", value); }

} // namespace searle::rheometry
