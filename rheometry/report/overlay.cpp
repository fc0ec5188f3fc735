#include "rheometry/report/deviation.hpp"
#include "rheometry/report/engine_difference.hpp"
#include "rheometry/report/figure.hpp"
#include "rheometry/report/flow_series.hpp"
#include "rheometry/report/number_text.hpp"
#include "rheometry/report/page.hpp"
#include "rheometry/report/particle_stress.hpp"
#include "rheometry/report/prose.hpp"
#include "rheometry/report/quantity.hpp"
#include "rheometry/report/report.hpp"
#include "rheometry/report/rich_text.hpp"
#include "rheometry/report/svg_style.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace searle::rheometry::report {

namespace {

// Beyond this many runs markers only hide each other, and beyond that many no reader compares names
// with a legend; lines and their tips stay.
constexpr std::size_t most_marked_runs = 12;
constexpr std::size_t most_named_runs = 24;
// Points of all lines of one panel together, so that the page stays small.
constexpr std::size_t line_points_of_panel = 20'000;

double largest_of_runs(const OverlayInput& input, Quantity quantity) {
    double largest = 0.0;
    for (const OverlayRun& run : input.runs) {
        largest = std::max(largest, largest_value(run.rheogram, quantity));
    }
    return largest;
}

CurveView view_of_runs(const OverlayInput& input, Quantity y) {
    CurveView view;
    view.x = Quantity::shear_rate;
    view.y = y;
    view.x_unit = display_unit("1/s", largest_of_runs(input, view.x));
    view.y_unit = display_unit(look_of(y, true).si_unit, largest_of_runs(input, y));
    return view;
}

bool same_fluid(const FluidDescription& a, const FluidDescription& b) {
    return a.model == b.model &&
           std::equal(a.parameters.begin(), a.parameters.end(), b.parameters.begin(),
                      b.parameters.end(), [](const Parameter& p, const Parameter& q) {
                          return p.key == q.key && p.value == q.value;
                      });
}

// The fluids of the runs, each once.
std::vector<const FluidDescription*> fluids_of(const OverlayInput& input) {
    std::vector<const FluidDescription*> fluids;
    for (const OverlayRun& run : input.runs) {
        const bool known = std::any_of(fluids.begin(), fluids.end(), [&](const auto* fluid) {
            return same_fluid(*fluid, run.fluid);
        });
        if (!known && run.fluid.true_stress) {
            fluids.push_back(&run.fluid);
        }
    }
    return fluids;
}

struct Look {
    int colour{};
    Marker marker{};
};

// The runs by the values of one swept key: which group each belongs to, and its place therein.
struct Grouping {
    std::vector<std::size_t> group;
    std::vector<std::size_t> place;
    std::vector<std::size_t> sizes;
};
Grouping group_by(const OverlayInput& input, std::size_t key) {
    Grouping out;
    std::vector<std::string> values;
    for (const OverlayRun& run : input.runs) {
        const std::string value = key < run.swept_values.size() ? run.swept_values[key] : "";
        const auto found = std::find(values.begin(), values.end(), value);
        const auto group = static_cast<std::size_t>(found - values.begin());
        if (found == values.end()) {
            values.push_back(value);
            out.sizes.push_back(0);
        }
        out.group.push_back(group);
        out.place.push_back(out.sizes[group]++);
    }
    return out;
}

// Runs that share the value of a swept key share a colour and differ by their markers, if there is
// a key that groups them so that colours and markers suffice; otherwise the runs take the colours
// in turn, and each pass through them the next marker.
std::vector<Look> looks_of(const OverlayInput& input) {
    constexpr std::array markers{Marker::circle, Marker::square, Marker::triangle, Marker::diamond};
    constexpr std::size_t colours = series_colour_count - 1; // black is the law's
    std::vector<Look> looks;
    for (std::size_t key = 0; key < input.swept_keys.size() && looks.empty(); ++key) {
        const Grouping groups = group_by(input, key);
        const bool groups_at_all =
            groups.sizes.size() > 1 && groups.sizes.size() < input.runs.size();
        const bool suffices = groups.sizes.size() <= colours &&
                              std::all_of(groups.sizes.begin(), groups.sizes.end(),
                                          [&](std::size_t size) { return size <= markers.size(); });
        if (!groups_at_all || !suffices) {
            continue;
        }
        for (std::size_t run = 0; run < input.runs.size(); ++run) {
            looks.push_back({static_cast<int>(groups.group[run]), markers[groups.place[run]]});
        }
    }
    for (std::size_t run = looks.size(); run < input.runs.size(); ++run) {
        looks.push_back(
            {static_cast<int>(run % colours), markers[(run / colours) % markers.size()]});
    }
    return looks;
}

void add_runs(Plot& plot, const OverlayInput& input, const CurveView& view) {
    RateRange range{std::nan(""), std::nan(""), std::nan("")};
    for (const OverlayRun& run : input.runs) {
        const RateRange own = rate_range(run.rheogram);
        range.lowest = std::fmin(range.lowest, own.lowest);
        range.highest = std::fmax(range.highest, own.highest);
        range.lowest_positive = std::fmin(range.lowest_positive, own.lowest_positive);
    }
    const double lowest = plot.x.scale == Scale::logarithmic ? range.lowest_positive : range.lowest;
    const std::vector<const FluidDescription*> fluids = fluids_of(input);
    for (const FluidDescription* fluid : fluids) {
        Series law = law_series(fluid->true_stress, lowest, range.highest, view, plot.x.scale);
        if (fluid != fluids.front()) {
            law.name = RichText{};
        }
        law.stroke = Stroke::dashed;
        plot.series.push_back(std::move(law));
    }
    int index = 0;
    for (const MeasuredSeries& measured : input.measured) {
        plot.series.push_back(measured_series(measured, view, index++));
    }
    const std::vector<Look> looks = looks_of(input);
    for (std::size_t k = 0; k < input.runs.size(); ++k) {
        const OverlayRun& run = input.runs[k];
        Series curve;
        if (input.runs.size() <= most_named_runs) {
            curve.name = RichText{run.name};
        }
        curve.line_tip = run.name;
        curve.most_line_points =
            std::clamp<std::size_t>(line_points_of_panel / input.runs.size(), 50, 1500);
        curve.colour = looks[k].colour;
        curve.stroke = Stroke::solid;
        curve.thin = true;
        if (input.runs.size() <= most_marked_runs) {
            curve.marker = looks[k].marker;
            curve.marker_spacing = 11.0;
        }
        for (const RheogramPoint& point : run.rheogram.points) {
            curve.x.push_back(value_of(point, view.x) * view.x_unit.per_si);
            curve.y.push_back(value_of(point, view.y) * view.y_unit.per_si);
            curve.error.push_back(error_of(point, view.y, run.conversion) * view.y_unit.per_si);
        }
        curve.tip = [&run](std::size_t point) {
            return run.name + "\n" + point_tip(run.rheogram.points[point], true, run.transient);
        };
        plot.series.push_back(std::move(curve));
    }
}

bool has_particles(const OverlayInput& input) {
    return std::ranges::any_of(input.runs,
                               [](const OverlayRun& run) { return run.particles.has_value(); });
}

Figure overlay_figure(const OverlayInput& input, Quantity y, const std::string& name) {
    const CurveView view = view_of_runs(input, y);
    std::vector<double> rates;
    bool positive = !input.runs.empty();
    for (const OverlayRun& run : input.runs) {
        for (const double rate : column(run.rheogram, Quantity::shear_rate)) {
            rates.push_back(rate);
        }
        positive = positive && has_positive_pair(run.rheogram, view.x, y);
    }
    FigureBuilder builder;
    const auto add = [&](Scale x_scale, Scale y_scale, const std::string& id) {
        Plot plot;
        plot.id = name + id;
        plot.title = look_of(y, true).name + " over shear rate, all runs";
        plot.x = x_axis(view, x_scale);
        plot.y = y_axis(view, y_scale);
        plot.plot_height = 330.0;
        add_runs(plot, input, view);
        // One legend serves both panels.
        for (Series& series : plot.series) {
            series.name = builder.empty() ? series.name : RichText{};
        }
        builder.add(std::move(plot));
    };
    add(Scale::linear, Scale::linear, "-linear");
    if (positive) {
        add(Scale::logarithmic, Scale::logarithmic, "-log");
    }
    const std::string symbol = "<i>" + look_of(y, true).symbol + "</i>";
    std::string caption =
        look_of(y, true).name + " " + symbol + " over shear rate <i>\u03b3\u0307</i> of all runs";
    caption += positive ? ", on linear (a) and logarithmic (b) axes." : ".";
    if (input.runs.size() > most_named_runs) {
        caption += " A run is named when one points at its line.";
    }
    caption += " Dashed: the flow law. Bars: the solver\u2019s estimate of its numerical error";
    caption += has_particles(input) ? ", and statistical scatter." : ".";
    return builder.finish(std::move(caption));
}

std::string run_table(const OverlayInput& input) {
    const bool any_warnings = std::any_of(input.runs.begin(), input.runs.end(),
                                          [](const auto& run) { return !run.warnings.empty(); });
    std::string out =
        "<div class=\"table scroll\"><table class=\"data runs\"><caption><b>Table 1.</b> The "
        "runs.</caption><thead><tr><th class=\"words\">run</th>";
    for (const std::string& key : input.swept_keys) {
        const std::string name = key.substr(key.rfind('.') + 1); // without a dot: all of it
        out += "<th title=\"" + escaped(key) + "\">" + escaped(name) + "</th>";
    }
    out +=
        "<th>points</th><th>convention</th><th>rates<br><span class=\"unit\">1/s</span></th>"
        "<th>largest deviation<br><span class=\"unit\">from the flow law</span></th>"
        "<th>numerical error<br><span class=\"unit\">largest, estimated</span></th><th>time</th>";
    out += any_warnings ? "<th>warnings</th></tr></thead><tbody>\n" : "</tr></thead><tbody>\n";
    for (const OverlayRun& run : input.runs) {
        const auto cell = [&](const std::string& html) { out += "<td>" + html + "</td>"; };
        const std::string name = escaped(run.name);
        out += "<tr><td class=\"words\">";
        out += run.link.empty() ? name : "<a href=\"" + escaped(run.link) + "\">" + name + "</a>";
        out += "</td>";
        for (std::size_t k = 0; k < input.swept_keys.size(); ++k) {
            cell(k < run.swept_values.size() ? escaped(run.swept_values[k]) : "");
        }
        const RateRange range = rate_range(run.rheogram);
        const Deviation deviation = largest_deviation(run.rheogram, run.fluid.true_stress);
        cell(std::to_string(run.rheogram.points.size()));
        cell(std::string{name_of(run.conversion.definition)});
        cell(significant(range.lowest, 4) + " \u2013 " + significant(range.highest, 4));
        cell(std::isfinite(deviation.largest) ? relative_text(deviation.largest, 3) + " at " +
                                                    quantity_text(deviation.at_rate, "1/s", 3)
                                              : "\u2013");
        cell(relative_text(largest_relative_error(run.rheogram), 2));
        cell(run.wall_seconds > 0.0 ? quantity_text(run.wall_seconds, "s", 3) : "");
        if (any_warnings) {
            cell(std::to_string(run.warnings.size()));
        }
        out += "</tr>\n";
    }
    return out + "</tbody></table></div>\n";
}

std::string warnings_of_runs(const OverlayInput& input) {
    std::string list;
    std::size_t count = 0;
    for (const OverlayRun& run : input.runs) {
        if (run.warnings.empty()) {
            continue;
        }
        list += "<dt>" + escaped(run.name) + "</dt>";
        for (const std::string& warning : run.warnings) {
            list += "<dd>" + prose_html(warning) + "</dd>";
            ++count;
        }
    }
    if (count == 0) {
        return "";
    }
    return "<details class=\"notes\"><summary>Warnings of the runs (" + std::to_string(count) +
           ")</summary><dl>" + list + "</dl></details>\n";
}

std::string lead_of(const OverlayInput& input) {
    std::string lead =
        std::to_string(input.runs.size()) + (input.runs.size() == 1 ? " run" : " runs");
    for (std::size_t k = 0; k < input.swept_keys.size(); ++k) {
        lead += (k == 0 ? " over <code>" : ", <code>") + escaped(input.swept_keys[k]) + "</code>";
    }
    const auto warned = std::count_if(input.runs.begin(), input.runs.end(),
                                      [](const auto& run) { return !run.warnings.empty(); });
    if (warned > 0) {
        lead += "; " + std::to_string(warned) + " with warnings, listed below the table";
    }
    return lead + ".";
}

} // namespace

std::string render_overlay(const OverlayInput& input) {
    const std::string title = input.title.empty() ? "Sweep" : input.title;
    std::string body = page_header("Virtual rheometer, sweep", title, lead_of(input));
    body += warning_box(input.warnings);
    body += paragraphs(input.remarks);
    body += "<div class=\"figures\">\n";
    body += figure_html(overlay_figure(input, Quantity::viscosity, "viscosity"), 1);
    body += figure_html(overlay_figure(input, Quantity::shear_stress, "stress"), 2);
    if (const auto difference = engine_difference_figure(input)) {
        body += figure_html(*difference, 3);
    }
    body += "</div>\n<h2>Runs</h2>\n" + run_table(input);
    if (has_particles(input)) {
        body += "<h2>Stress of the particles</h2>\n" + particle_table(input, 2);
    }
    body += warnings_of_runs(input);
    body += page_footer(input.provenance);
    return page(title, body);
}

} // namespace searle::rheometry::report
