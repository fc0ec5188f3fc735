#include "rheometry/tables/number_columns.hpp"

#include <fmt/format.h>
#include <limits>

namespace searle::rheometry {
namespace {

constexpr std::string_view allowed = "allowed: a number such as 0.015, 1.5e-2 or 0,015";

std::string shown(std::string_view text) {
    constexpr std::size_t longest = 40;
    if (text.size() <= longest)
        return fmt::format("\"{}\"", text);
    std::size_t cut = longest;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0) == 0x80)
        --cut;
    return fmt::format("\"{}...\"", text.substr(0, cut));
}

std::string_view name_of(DecimalMark mark) {
    return mark == DecimalMark::comma ? "comma" : "point";
}

} // namespace

void NumberColumns::add_fault(std::size_t row, std::size_t column, std::string message) {
    faults_.add({.line = table_.line(row),
                 .column = table_.columns()[column].name,
                 .message = std::move(message)});
}

void NumberColumns::compare_decimal_mark(std::size_t row, std::size_t column,
                                         const NumberText& number) {
    const DecimalMark mark = number.mark;
    if (mark == DecimalMark::comma && !number.may_be_thousands)
        comma_is_decimal_ = true;
    else if (number.may_be_thousands && !undecided_)
        undecided_ = {row, column};
    if (mark == DecimalMark::none || mark == mark_)
        return;
    if (mark_ == DecimalMark::none) {
        mark_ = mark;
        mark_line_ = table_.line(row);
        return;
    }
    add_fault(row, column,
              fmt::format("{} has a decimal {}, but line {} has a decimal {}; allowed: one of the "
                          "two throughout, no thousands separators",
                          shown(table_.text(row, column)), name_of(mark), mark_line_,
                          name_of(mark_)));
}

void NumberColumns::throw_if_any() {
    if (undecided_ && !comma_is_decimal_) {
        const std::string_view cell = trimmed(table_.text(undecided_->row, undecided_->column));
        std::string whole(cell);
        std::erase(whole, ',');
        std::string decimal(cell);
        decimal[decimal.find(',')] = '.';
        add_fault(
            undecided_->row, undecided_->column,
            fmt::format("{} may mean {} or {}; write numbers without thousands separators, or "
                        "with a decimal comma and semicolons between the fields",
                        shown(cell), whole, decimal));
    }
    faults_.throw_if_any();
}

std::vector<double> NumberColumns::read(std::size_t column, MissingValues missing) {
    const bool lenient = missing == MissingValues::allowed;
    std::vector<double> values(table_.rows(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t row = 0; row < values.size(); ++row) {
        const std::string_view cell = table_.text(row, column);
        const NumberText number = read_number(cell);
        switch (number.outcome) {
        case NumberText::Outcome::number:
            values[row] = number.value;
            compare_decimal_mark(row, column, number);
            break;
        case NumberText::Outcome::empty:
            if (!lenient)
                add_fault(row, column, fmt::format("the field is empty; {}", allowed));
            break;
        case NumberText::Outcome::not_finite:
            if (!lenient)
                add_fault(row, column,
                          fmt::format("{} is not a finite number; {}", shown(cell), allowed));
            break;
        case NumberText::Outcome::not_a_number:
            add_fault(row, column,
                      fmt::format("{} is not a number; {}, without thousands separators",
                                  shown(cell), allowed));
            break;
        case NumberText::Outcome::out_of_range:
            add_fault(row, column,
                      fmt::format("{} is beyond the range of double precision; {}", shown(cell),
                                  allowed));
            break;
        }
    }
    return values;
}

} // namespace searle::rheometry
