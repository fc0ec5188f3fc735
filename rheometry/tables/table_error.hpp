#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace searle::rheometry {

/// One thing wrong with a data file.
struct TableFault {
    std::size_t line{};  ///< 1-based line of the file; row of the sheet; 0 for the file as a whole
    std::string column;  ///< heading of the column, empty when no column is concerned
    std::string message; ///< what is wrong, with the value found, and what is allowed
};

/// A data file that cannot be used. what() is the whole message, a line per fault, each as
/// `FILE:LINE: column "NAME": MESSAGE`.
class TableError : public std::runtime_error {
public:
    /// @param left_out  number of further faults that are counted but not listed
    TableError(const std::string& file, std::vector<TableFault> faults, std::size_t left_out = 0);

    [[nodiscard]] const std::vector<TableFault>& faults() const { return faults_; }

private:
    std::vector<TableFault> faults_;
};

/// Collects the faults of one file, so that all are reported at once; keeps the first 20 and counts
/// the rest.
class TableFaults {
public:
    explicit TableFaults(std::string file) : file_(std::move(file)) {}

    void add(TableFault fault);
    void add(const TableFaults& others);
    [[nodiscard]] bool empty() const { return kept_.empty(); }
    /// Throws the TableError of everything added so far, if there is anything.
    void throw_if_any() const;

private:
    std::string file_;
    std::vector<TableFault> kept_;
    std::size_t left_out_ = 0;
};

} // namespace searle::rheometry
