#include "rheometry/fields/section_fields.hpp"

#include <algorithm>

namespace searle::rheometry::fields {

const NodalField* SectionFields::find(std::string_view field_name) const {
    const auto found = std::ranges::find(fields, field_name, &NodalField::name);
    return found == fields.end() ? nullptr : &*found;
}

std::uint32_t
add_patch(SectionFields& section, std::size_t columns, std::size_t rows,
          const std::function<SectionPoint(std::size_t column, std::size_t row)>& place) {
    const auto first = static_cast<std::uint32_t>(section.points.size());
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            section.points.push_back(place(column, row));
        }
    }
    const auto at = [&](std::size_t column, std::size_t row) {
        return static_cast<std::uint32_t>(first + row * columns + column);
    };
    for (std::size_t row = 0; row + 1 < rows; ++row) {
        for (std::size_t column = 0; column + 1 < columns; ++column) {
            section.cells.push_back({at(column, row), at(column + 1, row), at(column + 1, row + 1),
                                     at(column, row + 1)});
        }
    }
    return first;
}

std::vector<std::size_t> spread_rows(std::size_t count, std::size_t most) {
    std::vector<std::size_t> rows;
    const std::size_t number = std::min(count, most);
    for (std::size_t k = 1; k <= number; ++k) {
        // Rounded up, so that the k-th of n parts ends in its last row.
        rows.push_back((k * count + number - 1) / number);
    }
    return rows;
}

} // namespace searle::rheometry::fields
