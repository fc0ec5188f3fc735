#include "rheometry/tables/sheet_text.hpp"

#include "rheometry/tables/number_text.hpp"

#include <algorithm>

namespace searle::rheometry {

std::string tab_delimited(const Sheet& sheet) {
    std::string text;
    for (std::size_t row = 0; row < sheet.rows; ++row) {
        for (std::size_t column = 0; column < sheet.columns; ++column) {
            const SheetCell& cell = sheet.cell(row, column);
            text += column == 0 ? "" : "\t";
            if (const auto* number = std::get_if<double>(&cell))
                text += number_text(*number);
            else if (const auto* words = std::get_if<std::string>(&cell))
                for (const char character : *words)
                    text += character == '\t' || character == '\n' || character == '\r' ||
                                    character == '"'
                                ? ' '
                                : character;
        }
        text += '\n';
    }
    return text;
}

} // namespace searle::rheometry
