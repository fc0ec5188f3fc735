#include "rheometry/tables/column_names.hpp"

#include "rheometry/tables/number_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

namespace searle::rheometry {
namespace {

struct Names {
    ColumnQuantity quantity;
    std::string_view si_name;
    /// Lower case, single blanks; the first is the one that messages show.
    std::array<std::string_view, 7> accepted;
};

constexpr std::array names{
    Names{
        ColumnQuantity::time, "time_s", {"time", "step time", "test time", "elapsed time", "zeit"}},
    Names{ColumnQuantity::angular_velocity,
          "angular_velocity_rad_s",
          {"angular velocity", "velocity", "speed", "rotational speed", "rotation speed",
           "drehzahl", "winkelgeschwindigkeit"}},
    Names{ColumnQuantity::torque, "torque_N_m", {"torque", "moment", "drehmoment"}},
    Names{ColumnQuantity::wall_speed, "wall_speed_m_s", {"wall speed", "speed", "velocity"}},
    Names{ColumnQuantity::wall_force, "wall_force_N", {"wall force", "force"}},
    Names{ColumnQuantity::shear_rate, "shear_rate_1_s", {"shear rate"}},
    Names{ColumnQuantity::shear_stress, "shear_stress_Pa", {"shear stress", "stress"}},
    Names{ColumnQuantity::angle, "angle_rad", {"displacement", "angle", "deflection angle"}}};

const Names& names_of(ColumnQuantity quantity) {
    return *std::ranges::find(names, quantity, &Names::quantity);
}

struct SplitHeading {
    std::string base; ///< lower case, single blanks, without the unit
    std::string_view unit;
};

SplitHeading split(std::string_view heading) {
    heading = trimmed(heading);
    SplitHeading result;
    if (!heading.empty() && (heading.back() == ']' || heading.back() == ')')) {
        const std::size_t open = heading.rfind(heading.back() == ']' ? '[' : '(');
        if (open != std::string_view::npos) {
            result.unit = without_brackets(heading.substr(open));
            heading = trimmed(heading.substr(0, open));
        }
    }
    for (const char character : heading) {
        const bool blank = character == ' ' || character == '_' || character == '-';
        if (!blank)
            result.base += static_cast<char>(std::tolower(static_cast<unsigned char>(character)));
        else if (!result.base.empty() && result.base.back() != ' ')
            result.base += ' ';
    }
    return result;
}

std::optional<double> factor_of(const Heading& heading, ColumnQuantity quantity, std::size_t line,
                                TableFaults& faults) {
    const std::string_view in_heading = split(heading.name).unit;
    const bool si_name = trimmed(heading.name) == si_column_name(quantity);
    if (si_name && heading.unit.empty())
        return 1.0;
    const std::string_view unit = in_heading.empty() ? std::string_view(heading.unit) : in_heading;
    const std::optional<double> factor = si_factor(quantity, unit);
    if (!factor) {
        faults.add(
            {line, heading.name,
             unit.empty()
                 ? fmt::format("the column has no unit; write it as in \"{} [{}]\", or in a "
                               "line of units below the header; allowed: {}",
                               heading.name,
                               usual_units(quantity).substr(0, usual_units(quantity).find(',')),
                               usual_units(quantity))
                 : fmt::format("\"{}\" is no unit of this quantity; allowed: {}", unit,
                               usual_units(quantity))});
        return std::nullopt;
    }
    const bool contradicts_line =
        !in_heading.empty() && !heading.unit.empty() && si_factor(quantity, heading.unit) != factor;
    if (contradicts_line || (si_name && *factor != 1.0)) {
        faults.add({line, heading.name,
                    fmt::format("the header and the line of units (\"{}\") name different units",
                                heading.unit)});
        return std::nullopt;
    }
    return factor;
}

} // namespace

std::string_view si_column_name(ColumnQuantity quantity) { return names_of(quantity).si_name; }

std::optional<ColumnMatch> find_column(std::span<const Heading> headings, ColumnQuantity quantity,
                                       std::size_t line, TableFaults& faults) {
    const Names& known = names_of(quantity);
    std::vector<std::size_t> matches;
    for (std::size_t i = 0; i < headings.size(); ++i) {
        if (trimmed(headings[i].name) == known.si_name) {
            matches = {i};
            break;
        }
        const std::string base = split(headings[i].name).base;
        if (!base.empty() && std::ranges::find(known.accepted, base) != known.accepted.end())
            matches.push_back(i);
    }
    if (matches.empty())
        return std::nullopt;
    if (matches.size() > 1) {
        faults.add({line, headings[matches[1]].name,
                    fmt::format("both this column and \"{}\" could be meant; name the one to take "
                                "{}, in its SI unit",
                                headings[matches[0]].name, known.si_name)});
        return std::nullopt;
    }
    const std::optional<double> factor = factor_of(headings[matches[0]], quantity, line, faults);
    if (!factor)
        return std::nullopt;
    return ColumnMatch{matches[0], *factor};
}

void add_missing_column(std::span<const Heading> headings, ColumnQuantity quantity,
                        std::size_t line, TableFaults& faults) {
    const Names& known = names_of(quantity);
    std::vector<std::string_view> accepted;
    for (const std::string_view name : known.accepted)
        if (!name.empty())
            accepted.push_back(name);
    std::vector<std::string> found;
    for (const Heading& heading : headings)
        found.push_back(fmt::format("\"{}\"", heading.name));
    faults.add(
        {line, std::string(known.si_name),
         fmt::format("the column is missing; allowed instead: {} with a unit in brackets "
                     "({}); the file has {}",
                     fmt::join(accepted, ", "), usual_units(quantity), fmt::join(found, ", "))});
}

} // namespace searle::rheometry
