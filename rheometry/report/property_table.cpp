#include "rheometry/report/property_rows.hpp"

#include "rheometry/report/rich_text.hpp"

namespace searle::rheometry::report {

std::string property_table(const std::vector<PropertyRow>& rows, const std::string& caption) {
    std::string out = "<div class=\"table\"><table class=\"properties\"><caption>" + caption +
                      "</caption><tbody>\n";
    for (const PropertyRow& row : rows) {
        out += "<tr><th scope=\"row\">" + row.name + "</th><td class=\"symbol\">" + row.symbol +
               "</td><td>" + row.value + "</td></tr>\n";
    }
    return out + "</tbody></table></div>\n";
}

std::string source_note(const ReportInput& input, std::string_view key) {
    const auto found = input.source_lines.find(key);
    if (found == input.source_lines.end()) {
        return "";
    }
    return " <span class=\"source\">(line " + std::to_string(found->second) + ")</span>";
}

} // namespace searle::rheometry::report
