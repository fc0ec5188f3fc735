#pragma once

#include "rheometry/tables/csv_table.hpp"
#include "rheometry/tables/number_text.hpp"
#include "rheometry/tables/table_error.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace searle::rheometry {

/// Whether a column may hold nan, inf or empty cells; all of them read as NaN.
enum class MissingValues { forbidden, allowed };

/// Reads columns of one table as numbers and collects what is wrong with them, a file that has
/// decimal points in one place and decimal commas in another included.
class NumberColumns {
public:
    /// @param table  must outlive this object
    explicit NumberColumns(const CsvTable& table)
        : table_(table), faults_(table.name()), comma_is_decimal_(table.delimiter() == ';') {}

    [[nodiscard]] std::vector<double> read(std::size_t column, MissingValues missing);
    [[nodiscard]] TableFaults& faults() { return faults_; }
    /// To be called once all columns are read: throws the TableError of all faults, if there are
    /// any. Numbers such as "1,000" are among them when the comma may separate thousands and no
    /// other number shows that it is a decimal comma.
    void throw_if_any();

private:
    void compare_decimal_mark(std::size_t row, std::size_t column, const NumberText& number);
    void add_fault(std::size_t row, std::size_t column, std::string message);

    const CsvTable& table_;
    TableFaults faults_;
    DecimalMark mark_ = DecimalMark::none;
    std::size_t mark_line_ = 0;
    bool comma_is_decimal_;
    struct Cell {
        std::size_t row{};
        std::size_t column{};
    };
    std::optional<Cell> undecided_; ///< the first "1,000"
};

} // namespace searle::rheometry
