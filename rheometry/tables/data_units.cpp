#include "rheometry/tables/data_units.hpp"

#include "rheometry/tables/number_text.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <span>

namespace searle::rheometry {
namespace {

struct DataUnit {
    std::string_view spelling; ///< as `normalised` leaves it
    double factor;
};

constexpr double revolution = 2.0 * std::numbers::pi;
constexpr double degree = std::numbers::pi / 180.0;

constexpr std::array time_units{DataUnit{"s", 1.0}, DataUnit{"sec", 1.0}, DataUnit{"ms", 1e-3},
                                DataUnit{"min", 60.0}, DataUnit{"h", 3600.0}};
constexpr std::array angular_velocity_units{DataUnit{"rad/s", 1.0},
                                            DataUnit{"mrad/s", 1e-3},
                                            DataUnit{"rpm", revolution / 60.0},
                                            DataUnit{"rev/min", revolution / 60.0},
                                            DataUnit{"rev/s", revolution},
                                            DataUnit{"1/min", revolution / 60.0},
                                            DataUnit{"deg/s", degree},
                                            DataUnit{"rps", revolution},
                                            DataUnit{"r/min", revolution / 60.0},
                                            DataUnit{"U/min", revolution / 60.0}};
constexpr std::array torque_units{
    DataUnit{"N.m", 1.0},   DataUnit{"mN.m", 1e-3},   DataUnit{"uN.m", 1e-6},
    DataUnit{"nN.m", 1e-9}, DataUnit{"dyn.cm", 1e-7}, DataUnit{"Nm", 1.0},
    DataUnit{"mNm", 1e-3},  DataUnit{"uNm", 1e-6},    DataUnit{"nNm", 1e-9}};
constexpr std::array wall_speed_units{DataUnit{"m/s", 1.0}, DataUnit{"mm/s", 1e-3},
                                      DataUnit{"um/s", 1e-6}};
constexpr std::array wall_force_units{DataUnit{"N", 1.0}, DataUnit{"mN", 1e-3},
                                      DataUnit{"uN", 1e-6}, DataUnit{"nN", 1e-9}};
constexpr std::array shear_rate_units{DataUnit{"1/s", 1.0}};
constexpr std::array shear_stress_units{DataUnit{"Pa", 1.0}, DataUnit{"mPa", 1e-3},
                                        DataUnit{"kPa", 1e3}, DataUnit{"dyn/cm2", 0.1}};
constexpr std::array angle_units{DataUnit{"rad", 1.0}, DataUnit{"mrad", 1e-3},
                                 DataUnit{"deg", degree}};

std::span<const DataUnit> units_of(Quantity quantity) {
    switch (quantity) {
    case Quantity::time:
        return time_units;
    case Quantity::angular_velocity:
        return angular_velocity_units;
    case Quantity::torque:
        return torque_units;
    case Quantity::wall_speed:
        return wall_speed_units;
    case Quantity::wall_force:
        return wall_force_units;
    case Quantity::shear_rate:
        return shear_rate_units;
    case Quantity::shear_stress:
        return shear_stress_units;
    case Quantity::angle:
        return angle_units;
    }
    return {};
}

/// Other ways to write a piece of a unit, replaced in this order.
struct Rewriting {
    std::string_view from;
    std::string_view to;
};
constexpr Rewriting rewritings[]{{"\xC2\xB5", "u"},               // micro sign
                                 {"\xCE\xBC", "u"},               // Greek mu
                                 {"\xC2\xB7", "."},               // middle dot
                                 {"\xE2\x8B\x85", "."},           // dot operator
                                 {"\xC2\xA0", "."},               // no-break space
                                 {"\xC2\xB0", "deg"},             // degree sign
                                 {"\xE2\x81\xBB\xC2\xB9", "^-1"}, // superscript -1
                                 {"\xC2\xB2", "2"},               // superscript 2
                                 {"*", "."},
                                 {" ", "."},
                                 {"dyne", "dyn"},
                                 {"cm^2", "cm2"},
                                 {".s^-1", "/s"},
                                 {".s-1", "/s"},
                                 {".min^-1", "/min"},
                                 {".min-1", "/min"},
                                 {"s^-1", "1/s"},
                                 {"min^-1", "1/min"}};

std::string normalised(std::string_view unit) {
    std::string text(without_brackets(unit));
    for (const auto& [from, to] : rewritings)
        for (std::size_t at = text.find(from); at != std::string::npos;
             at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
    if (text == "s-1" || text == "min-1")
        text = "1/" + text.substr(0, text.size() - 2);
    if (text == "RPM" || text == "Rpm")
        text = "rpm";
    return text;
}

constexpr std::array all_quantities{
    Quantity::time,       Quantity::angular_velocity, Quantity::torque,       Quantity::wall_speed,
    Quantity::wall_force, Quantity::shear_rate,       Quantity::shear_stress, Quantity::angle};

} // namespace

std::string_view without_brackets(std::string_view text) {
    text = trimmed(text);
    if (text.size() >= 2 && ((text.front() == '[' && text.back() == ']') ||
                             (text.front() == '(' && text.back() == ')')))
        text = trimmed(text.substr(1, text.size() - 2));
    return text;
}

std::optional<double> si_factor(Quantity quantity, std::string_view unit) {
    const std::span<const DataUnit> units = units_of(quantity);
    const auto found = std::ranges::find(units, normalised(unit), &DataUnit::spelling);
    return found == units.end() ? std::nullopt : std::optional(found->factor);
}

std::string accepted_units(Quantity quantity) {
    std::string list;
    for (const DataUnit& unit : units_of(quantity)) {
        if (!list.empty())
            list += ", ";
        list += unit.spelling;
    }
    return list;
}

bool is_data_unit(std::string_view text) {
    return std::ranges::any_of(all_quantities, [text](Quantity quantity) {
        return si_factor(quantity, text).has_value();
    });
}

} // namespace searle::rheometry
