#include "casefile/quantity.hpp"

#include "casefile/nearest_name.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <vector>

namespace searle::casefile {
namespace {

bool is_digit(char sign) { return std::isdigit(static_cast<unsigned char>(sign)) != 0; }

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
        text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
        text.remove_suffix(1);
    return text;
}

/// A decimal number at the start of a text: sign and digits apart from the power of ten.
struct Decimal {
    std::string digits; ///< "-20.38"
    long exponent{};
    std::string_view rest;
};

std::optional<Decimal> leading_decimal(std::string_view text) {
    Decimal decimal;
    std::size_t at = 0;
    bool any = false;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) {
        if (text[at] == '-')
            decimal.digits += '-';
        ++at;
    }
    while (at < text.size() && is_digit(text[at])) {
        decimal.digits += text[at++];
        any = true;
    }
    if (at < text.size() && text[at] == '.') {
        std::size_t after = at + 1;
        std::string fraction;
        while (after < text.size() && is_digit(text[after]))
            fraction += text[after++];
        if (any || !fraction.empty()) {
            decimal.digits += (any ? "." : "0.") + fraction + (fraction.empty() ? "0" : "");
            any = true;
            at = after;
        }
    }
    if (!any)
        return std::nullopt;
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        std::size_t after = at + 1;
        const bool negative = after < text.size() && text[after] == '-';
        if (after < text.size() && (text[after] == '+' || text[after] == '-'))
            ++after;
        if (after < text.size() && is_digit(text[after])) {
            long exponent = 0;
            for (; after < text.size() && is_digit(text[after]); ++after)
                exponent = std::min(100000L, 10 * exponent + (text[after] - '0'));
            decimal.exponent = negative ? -exponent : exponent;
            at = after;
        }
    }
    decimal.rest = text.substr(at);
    return decimal;
}

bool is_zero(const std::string& digits) {
    return digits.find_first_of("123456789") == std::string::npos;
}

/// The nearest double; no value where it leaves the range of doubles.
std::optional<double> value_of(const Decimal& decimal, int shift) {
    if (is_zero(decimal.digits))
        return 0.0;
    const std::string text = fmt::format("{}e{}", decimal.digits, decimal.exponent + shift);
    double value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

constexpr std::array named_kinds{
    length,        angle,      duration, density,          viscosity,
    stress,        shear_rate, speed,    angular_velocity, acceleration,
    temperature,   energy,     voltage,  spring_stiffness, dashpot,
    concentration, fraction};
constexpr QuantityKind kinematic_viscosity{
    "a kinematic viscosity", "m^2/s", {.length = 2, .time = -1}, "mm^2/s, cSt"};

std::string what_it_is(const Dimension& dimension) {
    if (dimension == kinematic_viscosity.dimension)
        return fmt::format("is {}", kinematic_viscosity.name);
    for (const QuantityKind& kind : named_kinds)
        if (kind.dimension == dimension)
            return fmt::format("is {}", kind.name);
    return "has the wrong unit";
}

std::vector<std::string> usual_units(std::span<const QuantityKind> kinds) {
    std::vector<std::string> units;
    for (const QuantityKind& kind : kinds) {
        std::string_view list = kind.usual_units;
        while (!list.empty()) {
            const std::size_t comma = list.find(',');
            units.emplace_back(trimmed(list.substr(0, comma)));
            list.remove_prefix(comma == std::string_view::npos ? list.size() : comma + 1);
        }
    }
    return units;
}

QuantityFault unknown_unit(std::string_view unit, const std::string& reason,
                           std::span<const QuantityKind> kinds) {
    const std::vector<std::string> units = usual_units(kinds);
    return {fmt::format("has the unit \"{}\", which {}", unit, reason),
            nearest_name(unit, units).value_or("")};
}

/// "Pa.s^n" -> "Pa", in any spelling of the product and of the power; no value without an s^n.
std::optional<std::string> stress_unit_of_consistency(std::string_view unit) {
    static constexpr std::array powers{std::string_view{"s^n"}, std::string_view{"s**n"},
                                       std::string_view{"s\u207f"}};
    static constexpr std::array products{std::string_view{"\u00b7"}, std::string_view{"\u22c5"},
                                         std::string_view{"."}, std::string_view{"*"},
                                         std::string_view{" "}};
    for (const std::string_view power : powers) {
        const std::size_t at = unit.find(power);
        if (at == std::string_view::npos)
            continue;
        std::string_view before = unit.substr(0, at);
        bool joined = false;
        for (bool again = true; again;) {
            again = false;
            for (const std::string_view product : products)
                if (before.ends_with(product)) {
                    before.remove_suffix(product.size());
                    joined = again = true;
                }
        }
        // "Pas^n" is how many write it.
        if (!joined && !before.ends_with("Pa"))
            return std::nullopt;
        return std::string{before} + std::string{unit.substr(at + power.size())};
    }
    return std::nullopt;
}

/// "Pa.s^0.35" -> "Pa.s^n": the unit that was meant by one whose power is a number.
std::optional<std::string> with_power_as_letter(std::string_view unit) {
    for (const std::string_view power : {std::string_view{"s^"}, std::string_view{"s**"}}) {
        const std::size_t at = unit.find(power);
        if (at == std::string_view::npos)
            continue;
        const std::size_t number = at + power.size();
        const std::size_t end =
            std::min(unit.find_first_not_of("0123456789.,", number), unit.size());
        if (end == number)
            return std::nullopt;
        const std::string meant =
            std::string{unit.substr(0, number)} + "n" + std::string{unit.substr(end)};
        const auto rest = stress_unit_of_consistency(meant);
        const auto found = unit_named(rest.value_or(""));
        const Unit* stress_unit = std::get_if<Unit>(&found);
        if (rest && stress_unit && stress_unit->dimension == stress.dimension)
            return meant;
    }
    return std::nullopt;
}

bool asks_for_consistency(std::span<const QuantityKind> kinds) {
    return kinds.size() == 1 && kinds.front().si_unit == consistency.si_unit;
}

std::variant<Quantity, QuantityFault> finish(const Decimal& decimal, const Unit& unit,
                                             std::size_t kind) {
    const std::optional<double> number = value_of(decimal, unit.decimal_exponent);
    const double value = number ? *number * unit.factor + unit.offset : 0.0;
    if (!number || !std::isfinite(value))
        return QuantityFault{"is beyond the numbers that can be computed with", {}};
    return Quantity{value, kind};
}

std::variant<Quantity, QuantityFault> parse_consistency(const Decimal& decimal,
                                                        std::string_view unit_text) {
    const std::optional<std::string> stress_unit = stress_unit_of_consistency(unit_text);
    if (!stress_unit) {
        const auto plain = unit_named(unit_text);
        const Unit* unit = std::get_if<Unit>(&plain);
        if (unit && unit->dimension == viscosity.dimension)
            return QuantityFault{
                fmt::format("has the unit \"{}\" of a viscosity; a consistency's unit depends on "
                            "the flow index n",
                            unit_text),
                fmt::format("{}^n", unit_text)};
        if (const auto meant = with_power_as_letter(unit_text))
            return QuantityFault{
                fmt::format(
                    "has the unit \"{}\"; the power is the flow index n, which has a key of "
                    "its own (flow_index)",
                    unit_text),
                *meant};
        return QuantityFault{
            fmt::format("has the unit \"{}\", which is not a stress times s^n", unit_text), {}};
    }
    const auto found = unit_named(*stress_unit);
    const Unit* unit = std::get_if<Unit>(&found);
    if (!unit || unit->dimension != stress.dimension)
        return QuantityFault{
            fmt::format("has the unit \"{}\", which is not a stress times s^n", unit_text), {}};
    return finish(decimal, *unit, 0);
}

} // namespace

std::variant<Quantity, QuantityFault> parse_quantity(std::string_view text,
                                                     std::span<const QuantityKind> kinds) {
    const std::string_view whole = trimmed(text);
    if (whole.empty())
        return QuantityFault{"is empty", {}};
    const std::optional<Decimal> decimal = leading_decimal(whole);
    if (!decimal)
        return QuantityFault{"does not start with a finite number", {}};
    const std::string_view unit_text = trimmed(decimal->rest);
    if (unit_text.empty())
        return QuantityFault{"has no unit", {}};
    if (unit_text.front() == ',')
        return QuantityFault{"has a comma in its number; the decimal sign is a point", {}};
    if (unit_text.ends_with("Hz") || unit_text.ends_with("hertz"))
        return QuantityFault{"is in Hz, which does not say whether turns or radians are counted",
                             {}};
    if (asks_for_consistency(kinds))
        return parse_consistency(*decimal, unit_text);
    const auto found = unit_named(unit_text);
    if (const auto* unknown = std::get_if<UnknownUnit>(&found))
        return unknown_unit(unit_text, unknown->reason, kinds);
    const Unit& unit = std::get<Unit>(found);
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
        if (kinds[kind].dimension == unit.dimension)
            return finish(*decimal, unit, kind);
    return QuantityFault{what_it_is(unit.dimension), {}};
}

std::string shortest(double value) { return fmt::format("{}", value); }

std::string si_text(double value, const QuantityKind& kind) {
    if (kind.dimension == fraction.dimension)
        return shortest(value);
    return fmt::format("{} {}", shortest(value), kind.si_unit);
}

} // namespace searle::casefile
