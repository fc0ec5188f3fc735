#pragma once

#include "rheometry/tables/csv_table.hpp"
#include "rheometry/tables/number_text.hpp"
#include "rheometry/tables/table_error.hpp"

#include <cstddef>
#include <vector>

namespace searle::rheometry {

/// Whether a column may hold nan, inf or empty cells; all of them read as NaN.
enum class MissingValues { forbidden, allowed };

/// Reads columns of one table as numbers and collects what is wrong with them, a file that has
/// decimal points in one place and decimal commas in another included.
class NumberColumns {
public:
    /// @param table  must outlive this object
    explicit NumberColumns(const CsvTable& table) : table_(table), faults_(table.name()) {}

    [[nodiscard]] std::vector<double> read(std::size_t column, MissingValues missing);
    [[nodiscard]] TableFaults& faults() { return faults_; }

private:
    void compare_decimal_mark(std::size_t row, std::size_t column, DecimalMark mark);
    void add_fault(std::size_t row, std::size_t column, std::string message);

    const CsvTable& table_;
    TableFaults faults_;
    DecimalMark mark_ = DecimalMark::none;
    std::size_t mark_line_ = 0;
};

} // namespace searle::rheometry
