#include "casefile/common_units.hpp"

#include <array>

namespace searle::casefile {
namespace {

using Named = std::pair<std::string_view, Unit>;

constexpr Dimension length{.length = 1};
constexpr Dimension time{.time = 1};
constexpr Dimension pressure{.length = -1, .mass = 1, .time = -2};
constexpr Dimension viscosity{.length = -1, .mass = 1, .time = -1};
constexpr Dimension density{.length = -3, .mass = 1};
constexpr Dimension voltage{.length = 2, .mass = 1, .time = -3, .current = -1};

constexpr Named unit(std::string_view name, Dimension dimension, int decimal_exponent = 0) {
    return {name, {.dimension = dimension, .decimal_exponent = decimal_exponent}};
}

constexpr std::array units{
    unit("m", length),
    unit("cm", length, -2),
    unit("mm", length, -3),
    unit("um", length, -6),
    unit("nm", length, -9),
    unit("s", time),
    unit("ms", time, -3),
    unit("1/s", {.time = -1}),
    unit("rad/s", {.time = -1, .angle = 1}),
    unit("Pa", pressure),
    unit("Pa.s", viscosity),
    unit("mPa.s", viscosity, -3),
    unit("kg/m^3", density),
    unit("g/cm^3", density, 3),
    unit("N/m", {.mass = 1, .time = -2}),
    unit("J", {.length = 2, .mass = 1, .time = -2}),
    unit("V", voltage),
    unit("mV", voltage, -3),
    unit("K", {.temperature = 1}),
    unit("kg/s", {.mass = 1, .time = -1}),
    unit("m/s^2", {.length = 1, .time = -2}),
    unit("mol/m^3", {.length = -3, .amount = 1}),
    unit("%", {}, -2),
    Named{"deg",
          {.dimension = {.angle = 1}, .decimal_exponent = 0, .factor = 0.017453292519943295}},
};

} // namespace

std::span<const Named> common_units() { return units; }

std::optional<Unit> common_unit(std::string_view text) {
    for (const auto& [name, meaning] : units)
        if (name == text)
            return meaning;
    return std::nullopt;
}

} // namespace searle::casefile
