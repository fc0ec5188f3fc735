#include "rheometry/report/data_table.hpp"

#include "rheometry/report/number_text.hpp"
#include "rheometry/report/quantity.hpp"
#include "rheometry/report/regime_shading.hpp"
#include "rheometry/report/rich_text.hpp"
#include "rheometry/report/thinning.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace searle::rheometry::report {

namespace {

constexpr std::size_t longest_embedded_csv = 400'000;

std::string percent_encoded(std::string_view bytes) {
    constexpr std::string_view hex = "0123456789ABCDEF";
    constexpr std::string_view kept = "-_.~,+:";
    std::string out;
    out.reserve(bytes.size() + bytes.size() / 8);
    for (const char c : bytes) {
        const bool letter =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (letter || kept.find(c) != std::string_view::npos) {
            out += c;
            continue;
        }
        const auto byte = static_cast<unsigned char>(c);
        out += '%';
        out += hex[byte >> 4];
        out += hex[byte & 0xf];
    }
    return out;
}

struct Column {
    Quantity quantity;
    DisplayUnit unit;
    std::optional<int> decimals; ///< for what the drive prescribes
};

std::string header_cell(const QuantityLook& look, const DisplayUnit& unit) {
    std::string out = "<th scope=\"col\" title=\"" + look.name + "\"><i>" + look.symbol + "</i>";
    if (!unit.name.empty()) {
        out += "<br><span class=\"unit\">" + unit.name + "</span>";
    }
    return out + "</th>";
}

std::string regime_text(std::string_view regime) {
    std::string out;
    for (const std::string& name : regime_names(regime)) {
        out += (out.empty() ? "" : ", ") + escaped(regime_label(name));
    }
    return out;
}

} // namespace

std::string csv_link(const ReportInput& input) {
    const std::string name = escaped(input.csv_file_name);
    if (input.csv.empty() || input.csv.size() > longest_embedded_csv) {
        return "All rows with 17 significant digits: <code>" + name + "</code> beside this page.";
    }
    return "<a class=\"button\" download=\"" + name + "\" href=\"data:text/csv;charset=utf-8," +
           percent_encoded(input.csv) + "\">Download " + name + "</a>";
}

std::string data_table(const ReportInput& input, int number, std::size_t most_rows) {
    const auto& points = input.rheogram.points;
    const bool rotates = geometry::rotates(input.instrument);
    std::vector<Column> columns;
    const std::vector<std::size_t> rows = thinned_evenly(points.size(), most_rows);
    const auto add_column = [&](Quantity quantity) {
        const QuantityLook look = look_of(quantity, rotates);
        Column column{quantity, display_unit(look.si_unit, largest_value(input.rheogram, quantity)),
                      std::nullopt};
        std::vector<double> values;
        for (const std::size_t k : rows) {
            values.push_back(value_of(points[k], quantity) * column.unit.per_si);
        }
        column.decimals = common_decimals(values);
        columns.push_back(column);
    };
    if (input.transient) {
        add_column(Quantity::time);
    }
    for (const Quantity quantity : {Quantity::drive_speed, Quantity::torque, Quantity::shear_rate,
                                    Quantity::shear_stress, Quantity::viscosity}) {
        add_column(quantity);
    }

    constexpr std::size_t most_open_rows = 40;
    std::string out = points.size() <= most_open_rows ? "<details open>" : "<details>";
    out += "<summary><b>Table " + std::to_string(number) + ".</b> All data (" +
           std::to_string(points.size()) + (points.size() == 1 ? " point)" : " points)");
    if (rows.size() < points.size()) {
        out += ", of which " + std::to_string(rows.size()) + " are listed";
    }
    out += "</summary><div class=\"table scroll\"><table class=\"data\"><thead><tr><th>#</th>";
    for (const Column& column : columns) {
        out += header_cell(look_of(column.quantity, rotates), column.unit);
        if (column.quantity == Quantity::shear_stress) {
            out +=
                "<th scope=\"col\" title=\"Estimated numerical error of the shear stress\">\u00b1"
                "<br><span class=\"unit\">" +
                column.unit.name + "</span></th>";
        }
    }
    out += "<th scope=\"col\" class=\"words\">regime</th></tr></thead><tbody>\n";
    for (const std::size_t k : rows) {
        const RheogramPoint& point = points[k];
        out += "<tr><td>" + std::to_string(k + 1) + "</td>";
        for (const Column& column : columns) {
            const double value = value_of(point, column.quantity) * column.unit.per_si;
            const double error =
                error_of(point, column.quantity, input.conversion) * column.unit.per_si;
            const bool has_error = column.quantity == Quantity::torque ||
                                   column.quantity == Quantity::shear_stress ||
                                   column.quantity == Quantity::viscosity;
            out += "<td>";
            if (has_error) {
                out += rounded_to_error(value, error);
            } else {
                out += column.decimals ? with_decimals(value, *column.decimals)
                                       : significant(value, 7);
            }
            out += "</td>";
            if (column.quantity == Quantity::shear_stress) {
                out += "<td class=\"quiet\">" + significant_padded(error, 2) + "</td>";
            }
        }
        out += "<td class=\"words\">" + regime_text(point.regime) + "</td></tr>\n";
    }
    return out + "</tbody></table></div></details>\n<p>" + csv_link(input) + "</p>\n";
}

} // namespace searle::rheometry::report
