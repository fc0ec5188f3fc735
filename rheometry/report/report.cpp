#include "rheometry/report/report.hpp"

#include "rheometry/report/data_table.hpp"
#include "rheometry/report/deviation.hpp"
#include "rheometry/report/end_effect_figure.hpp"
#include "rheometry/report/field_figures.hpp"
#include "rheometry/report/flow_curve_figures.hpp"
#include "rheometry/report/flow_series.hpp"
#include "rheometry/report/geometry_drawing.hpp"
#include "rheometry/report/history_figures.hpp"
#include "rheometry/report/mesh_section.hpp"
#include "rheometry/report/number_text.hpp"
#include "rheometry/report/page.hpp"
#include "rheometry/report/particle_stress.hpp"
#include "rheometry/report/property_rows.hpp"
#include "rheometry/report/rich_text.hpp"
#include "rheometry/report/validity_section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::rheometry::report {

namespace {

// "0.1 – 100 mPa" in one unit; the least and the greatest of a column.
std::string range_text(const Rheogram& rheogram, Quantity quantity, bool rotates) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const RheogramPoint& point : rheogram.points) {
        const double value = value_of(point, quantity);
        if (!std::isfinite(value)) {
            continue;
        }
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (low > high) {
        return "\u2013";
    }
    const DisplayUnit unit =
        display_unit(look_of(quantity, rotates).si_unit, std::max(std::abs(low), std::abs(high)));
    const std::string from = significant(low * unit.per_si, 4);
    const std::string to = significant(high * unit.per_si, 4);
    return (from == to ? to : from + (low < 0.0 ? " to " : " \u2013 ") + to) + "\u00a0" + unit.name;
}

std::string end_factor_phrase(const ReportInput& input) {
    const std::string symbol = "<i>c</i><sub>L</sub>";
    if (!has_computed_end_factors(input)) {
        return "end-effect factor " + symbol + " = " + significant(input.conversion.end_factor, 6);
    }
    return "the end-effect factor " + symbol + " computed for each speed (" +
           computed_end_factors(input) + ")";
}

std::string lead_paragraph(const ReportInput& input) {
    std::string fluid =
        input.fluid.model.empty() ? "a fluid" : "a " + fluid_phrase(input.fluid.model);
    std::string out = "Flow curve of " + escaped(fluid) + " in " +
                      std::string{instrument_phrase(input)} + ", as the instrument would show it";
    if (!input.protocol.empty()) {
        out += ": " + escaped(input.protocol);
    }
    out += ". ";
    if (geometry::rotates(input.instrument)) {
        out += "Shear rates and stresses are those of the convention <b class=\"name\">" +
               std::string{name_of(input.conversion.definition)} + "</b> with " +
               end_factor_phrase(input) + ".";
    } else if (is_periodic(input)) {
        out +=
            "There are no walls: the shear stress is that of the bulk, and the box is sheared by "
            "images of it that move (Lees and Edwards).";
    } else {
        out += "The shear stress is force over wall area, the shear rate wall speed over gap.";
    }
    return out;
}

std::vector<MainResult> results_of(const ReportInput& input) {
    const bool rotates = geometry::rotates(input.instrument);
    std::vector<MainResult> results;
    const std::size_t count = input.rheogram.points.size();
    results.push_back({"Shear rate <i>\u03b3\u0307</i>",
                       range_text(input.rheogram, Quantity::shear_rate, rotates),
                       std::to_string(count) + (count == 1 ? " point" : " points")});
    results.push_back({"Shear stress <i>\u03c4</i>",
                       range_text(input.rheogram, Quantity::shear_stress, rotates), ""});
    const Deviation deviation = largest_deviation(input.rheogram, input.fluid.true_stress);
    results.push_back({"Apparent viscosity <i>\u03b7</i>",
                       range_text(input.rheogram, Quantity::viscosity, rotates),
                       std::isfinite(deviation.largest)
                           ? "up to " + relative_text(deviation.largest, 3) + " off the flow law"
                           : ""});
    const double error = largest_relative_error(input.rheogram);
    if (std::isfinite(error)) {
        results.push_back(
            {"Numerical error, estimated", "\u2264\u00a0" + relative_text(error, 2),
             input.accuracy > 0.0 ? "asked for: " + relative_text(input.accuracy, 2) : ""});
    }
    if (!input.provenance.model.empty()) {
        double seconds = 0.0;
        for (const StageTime& stage : input.timings) {
            seconds += stage.wall_seconds;
        }
        results.push_back({"Model", escaped(input.provenance.model),
                           seconds > 0.0 ? "in " + quantity_text(seconds, "s", 3) : ""});
    }
    return results;
}

} // namespace

std::string render_report(const ReportInput& input) {
    int figure = 0;
    int table = 0;
    const auto numbered = [&](const std::string& caption) {
        return "<b>Table " + std::to_string(++table) + ".</b> " + caption;
    };
    const std::string title = input.title.empty() ? "Rheogram" : input.title;

    std::string body = page_header("Virtual rheometer", title, lead_paragraph(input));
    body += main_results(results_of(input));
    body += warning_box(input.warnings);
    body += paragraphs(input.remarks);

    body += "<h2>Flow curve</h2>\n<div class=\"figures\">\n";
    body += figure_html(rheogram_figure(input), ++figure);
    body += figure_html(viscosity_figure(input), ++figure);
    body += figure_html(torque_figure(input), ++figure);
    body += figure_html(error_figure(input), ++figure);
    if (!input.ends.empty()) {
        body += figure_html(end_effect_figure(input), ++figure);
    }
    body += "</div>\n";

    if (input.particles) {
        body += "<h2>Stress of the particles</h2>\n" + particle_table(input, ++table);
    }

    if (const std::vector<Figure> pictures = field_figures(input); !pictures.empty()) {
        body += "<h2>Flow in the section</h2>\n<div class=\"figures\">\n";
        for (const Figure& each : pictures) {
            body += figure_html(each, ++figure);
        }
        body += "</div>\n";
    }

    if (has_validity(input)) {
        body += "<h2>Validity</h2>\n" + validity_section(input, ++table);
    }

    Figure drawing;
    drawing.panels.push_back(geometry_drawing_for_page(input.instrument, is_periodic(input)));
    drawing.caption =
        geometry::rotates(input.instrument)
            ? "The instrument. Orange: turns; grey: stands still; blue: fluid."
        : is_periodic(input)
            ? "The box, which stands for the bulk. Above and below: its images, which move."
            : "The instrument. Orange: moving wall; grey: fixed wall; blue: fluid.";
    body += "<h2>Instrument and fluid</h2>\n<div class=\"columns\"><div>\n";
    body += figure_html(drawing, ++figure);
    body += "</div><div>\n";
    const std::string case_file =
        input.provenance.case_file.empty()
            ? ""
            : " Lines are those of <code>" + escaped(input.provenance.case_file) + "</code>.";
    body += property_table(instrument_rows(input),
                           numbered("Instrument." + (input.source_lines.empty() ? "" : case_file)));
    body += property_table(fluid_rows(input), numbered("Fluid."));
    body += "</div></div>\n";

    body += "<h2>From torque and speed to stress and rate</h2>\n";
    body += property_table(conversion_rows(input), numbered("Conversion."));

    body += "<h2>Solution</h2>\n";
    body += property_table(solution_rows(input), numbered("How the torque was computed."));
    if (input.mesh) {
        body += mesh_section(*input.mesh, ++figure, ++table);
    }

    body += "<h2>Data</h2>\n";
    body += data_table(input, ++table);
    body += page_footer(input.provenance);
    return page(title, body);
}

} // namespace searle::rheometry::report
