#include "rheometry/tables/table_error.hpp"

#include <fmt/format.h>

namespace searle::rheometry {
namespace {

constexpr std::size_t most_listed = 20;

std::string message_of(const std::string& file, const std::vector<TableFault>& faults,
                       std::size_t left_out) {
    std::string text;
    for (const TableFault& fault : faults) {
        if (!text.empty())
            text += '\n';
        text += file;
        if (fault.line > 0)
            text += fmt::format(":{}", fault.line);
        text += ": ";
        if (!fault.column.empty())
            text += fmt::format("column \"{}\": ", fault.column);
        text += fault.message;
    }
    if (left_out > 0)
        text += fmt::format("\n{}: and {} more like these", file, left_out);
    return text;
}

} // namespace

TableError::TableError(const std::string& file, std::vector<TableFault> faults,
                       std::size_t left_out)
    : std::runtime_error(message_of(file, faults, left_out)), faults_(std::move(faults)) {}

void TableFaults::add(TableFault fault) {
    if (kept_.size() < most_listed)
        kept_.push_back(std::move(fault));
    else
        ++left_out_;
}

void TableFaults::add(const TableFaults& others) {
    for (const TableFault& fault : others.kept_)
        add(fault);
    left_out_ += others.left_out_;
}

void TableFaults::throw_if_any() const {
    if (!kept_.empty())
        throw TableError(file_, kept_, left_out_);
}

} // namespace searle::rheometry
