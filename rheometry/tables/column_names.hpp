#pragma once

#include "rheometry/tables/data_units.hpp"
#include "rheometry/tables/table_error.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace searle::rheometry {

/// A column's heading and, apart from it, the unit from a line of units (empty without one).
struct Heading {
    std::string name;
    std::string unit;
};

struct ColumnMatch {
    std::size_t index{};
    double si_factor{}; ///< SI units per unit of the column
};

/// The name of a column that is in SI units and needs no unit written: "torque_N_m".
[[nodiscard]] std::string_view si_column_name(ColumnQuantity quantity);

/// The column that holds a quantity: the one with the SI name, or else the one whose heading,
/// without its unit and whatever its case, is one of the accepted names ("Torque [mN.m]", "speed
/// (rpm)"). No value when there is none; a fault too when there are several, or when the unit is
/// missing or none of this quantity.
/// @param line  where the headings stand, for the faults
[[nodiscard]] std::optional<ColumnMatch> find_column(std::span<const Heading> headings,
                                                     ColumnQuantity quantity, std::size_t line,
                                                     TableFaults& faults);

/// Adds the fault of a column that has to be there, with the names that are accepted.
void add_missing_column(std::span<const Heading> headings, ColumnQuantity quantity,
                        std::size_t line, TableFaults& faults);

} // namespace searle::rheometry
