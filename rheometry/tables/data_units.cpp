#include "rheometry/tables/data_units.hpp"

#include "casefile/unit.hpp"
#include "rheometry/tables/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>

namespace searle::rheometry {
namespace {

struct Kind {
    ColumnQuantity quantity;
    casefile::Dimension dimension;
    std::string_view usual_units;
};

constexpr std::array kinds{
    Kind{ColumnQuantity::time, {.time = 1}, "s, ms, min, h"},
    Kind{ColumnQuantity::angular_velocity,
         {.time = -1, .angle = 1},
         "rad/s, mrad/s, rpm, 1/min, rev/s, deg/s"},
    Kind{ColumnQuantity::torque,
         {.length = 2, .mass = 1, .time = -2},
         "N.m, mN.m, uN.m, nN.m, dyn.cm"},
    Kind{ColumnQuantity::wall_speed, {.length = 1, .time = -1}, "m/s, mm/s, um/s"},
    Kind{ColumnQuantity::wall_force, {.length = 1, .mass = 1, .time = -2}, "N, mN, uN"},
    Kind{ColumnQuantity::shear_rate, {.time = -1}, "1/s"},
    Kind{ColumnQuantity::shear_stress, {.length = -1, .mass = 1, .time = -2}, "Pa, mPa, kPa"},
    Kind{ColumnQuantity::angle, {.angle = 1}, "rad, mrad, deg"},
    Kind{ColumnQuantity::length, {.length = 1}, "mm, um, m"},
    Kind{ColumnQuantity::stress_constant, {.length = -3}, "Pa/(N.m)"},
    Kind{ColumnQuantity::strain_constant, {.angle = -1}, "1/rad"}};

const Kind& kind_of(ColumnQuantity quantity) {
    return *std::ranges::find(kinds, quantity, &Kind::quantity);
}

/// Pa/N.m is how TRIOS writes Pa/(N.m).
std::string unambiguous(std::string_view unit) {
    return unit == "Pa/N.m" ? "Pa/(N.m)" : std::string(unit);
}

} // namespace

std::optional<double> si_factor(ColumnQuantity quantity, std::string_view unit) {
    const std::string text = unambiguous(without_brackets(unit));
    // UDUNITS prints a control character that it meets to standard output.
    const auto is_control = [](char byte) { return static_cast<unsigned char>(byte) < 0x20; };
    if (text.empty() || std::ranges::any_of(text, is_control))
        return std::nullopt;
    const auto found = casefile::unit_named(text);
    const casefile::Unit* const known = std::get_if<casefile::Unit>(&found);
    if (known == nullptr || known->offset != 0.0 || known->dimension != kind_of(quantity).dimension)
        return std::nullopt;
    return known->factor * std::pow(10.0, known->decimal_exponent);
}

std::string_view usual_units(ColumnQuantity quantity) { return kind_of(quantity).usual_units; }

bool is_data_unit(std::string_view text) {
    return std::ranges::any_of(
        kinds, [text](const Kind& kind) { return si_factor(kind.quantity, text).has_value(); });
}

std::string_view without_brackets(std::string_view text) {
    text = trimmed(text);
    if (text.size() >= 2 && ((text.front() == '[' && text.back() == ']') ||
                             (text.front() == '(' && text.back() == ')')))
        text = trimmed(text.substr(1, text.size() - 2));
    return text;
}

} // namespace searle::rheometry
