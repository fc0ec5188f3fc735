#include "app/bench/bench_text.hpp"
#include "app/bench/work_precision.hpp"
#include "rheometry/report/figure.hpp"
#include "rheometry/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace searle::app::bench {
namespace {

using namespace rheometry::report;

std::string code_label(const Measurement& point) {
    return point.code == "searle" ? "Searle" : point.code;
}

/// Curves of the scenes of one figure: CPU time over true error.
Plot curve_plot(const SceneResult& scene) {
    Plot plot;
    plot.id = "curve-" + scene.name;
    plot.title = "CPU time against true error: " + scene.title;
    plot.x.name = RichText("largest true relative error");
    plot.x.scale = Scale::logarithmic;
    plot.y.name = RichText("CPU time, s");
    plot.y.scale = Scale::logarithmic;
    std::vector<std::string> codes;
    for (const Measurement& point : scene.points)
        if (std::isfinite(point.true_error) &&
            std::ranges::find(codes, code_label(point)) == codes.end())
            codes.push_back(code_label(point));
    constexpr Marker markers[] = {Marker::circle, Marker::square, Marker::diamond,
                                  Marker::triangle};
    for (std::size_t k = 0; k < codes.size(); ++k) {
        Series series;
        series.name = RichText(codes[k]);
        series.colour = static_cast<int>(k % 4);
        series.marker = markers[k % 4];
        series.stroke = Stroke::solid;
        std::vector<std::string> tips;
        for (const Measurement& point : scene.points)
            if (code_label(point) == codes[k] && std::isfinite(point.true_error)) {
                series.x.push_back(
                    std::max(point.true_error, std::max(scene.reference_error, 1e-16)));
                series.y.push_back(point.cpu_median);
                tips.push_back(fmt::format("{}: error {}, {}", point.setting,
                                           error_text(point.true_error),
                                           time_text(point.cpu_median)));
            }
        series.tip = [tips](std::size_t at) { return tips.at(at); };
        plot.series.push_back(std::move(series));
    }
    return plot;
}

std::string row_html(const std::vector<std::string>& cells, bool head) {
    std::string out = "<tr>";
    for (std::size_t k = 0; k < cells.size(); ++k)
        out += head || k == 0 ? "<th scope=\"" + std::string(head ? "col" : "row") + "\">" +
                                    escaped(cells[k]) + "</th>"
                              : "<td>" + escaped(cells[k]) + "</td>";
    return out + "</tr>\n";
}

std::string scene_table(const SceneResult& scene) {
    std::string out = "<div class=\"table\"><table><thead>" +
                      row_html({"setting", "true error", "estimate",
                                scene.cost_unit.empty() ? "CPU time" : scene.cost_unit, "least",
                                "unknowns", "MiB", ""},
                               true) +
                      "</thead><tbody>\n";
    for (const Measurement& point : scene.points)
        out += row_html({code_label(point) + ", " + point.setting, error_text(point.true_error),
                         error_text(point.estimate), time_text(point.cpu_median),
                         time_text(point.cpu_least),
                         std::isfinite(point.unknowns) ? fmt::format("{:.0f}", point.unknowns) : "",
                         std::isfinite(point.peak_MiB) ? fmt::format("{:.0f}", point.peak_MiB) : "",
                         point.remark},
                        false);
    return out + "</tbody></table></div>\n";
}

std::string ratio_table(const std::vector<Ratio>& ratios) {
    if (ratios.empty())
        return "";
    std::string out =
        "<h2>Where both are equally far off</h2>\n<div class=\"table\"><table><thead>" +
        row_html({"scene", "peer", "its error", "its CPU", "Searle there", "ratio"}, true) +
        "</thead><tbody>\n";
    for (const Ratio& ratio : ratios)
        out += row_html({ratio.scene, ratio.peer, error_text(ratio.error),
                         time_text(ratio.peer_cpu), time_text(ratio.own_cpu),
                         fmt::format("{}{:.0f}", ratio.at_least ? "> " : "", ratio.ratio)},
                        false);
    return out + "</tbody></table></div>\n<p>A curve is followed between its points by straight "
                 "lines in the logarithms. Where Searle's cheapest run is already more accurate "
                 "than the peer, the ratio is a lower bound (&gt;). Rows without an error are "
                 "costs of a unit of strain.</p>\n";
}

} // namespace

std::string bench_page(const BenchResult& result) {
    const std::vector<Ratio> least = least_ratios(ratios_of(result));
    std::string body = page_header(
        "Benchmark", "Run time against error",
        escaped(fmt::format("Measured {} on {}. CPU times, medians; all programs of a scene took "
                            "turns. {}",
                            result.created, result.machine,
                            result.quick ? "A quick run: fewer points, coarser references." : "")));
    std::vector<MainResult> strip;
    for (const Ratio& ratio : least)
        strip.push_back({escaped(ratio.scene),
                         fmt::format("{}{:.0f} times", ratio.at_least ? "&gt; " : "", ratio.ratio),
                         escaped("cheaper than " + ratio.peer)});
    if (!strip.empty())
        body += main_results(strip);
    std::vector<std::string> notes = result.notes;
    if (result.interrupted)
        notes.insert(notes.begin(), "Interrupted: what was measured until then.");
    body += warning_box(notes);
    body += ratio_table(ratios_of(result));
    int number = 0;
    for (const SceneResult& scene : result.scenes) {
        body += "<h2>" + escaped(scene.name) + "</h2>\n";
        if (scene.cost_unit.empty()) {
            FigureBuilder figure;
            figure.add(curve_plot(scene));
            body += figure_html(
                figure.finish(escaped(fmt::format(
                    "{}. Errors against {}; points below that reference's own error are drawn "
                    "there.{}",
                    scene.title, scene.reference,
                    std::isfinite(scene.whole_program)
                        ? fmt::format(" A whole run of the program, with start, report and files, "
                                      "takes {} of CPU at accuracy 1e-3.",
                                      time_text(scene.whole_program))
                        : ""))),
                ++number);
        } else {
            body += "<p>" +
                    escaped(fmt::format("{}. Errors against {}.", scene.title, scene.reference)) +
                    "</p>\n";
        }
        body += scene_table(scene);
    }
    Provenance provenance;
    provenance.program_version = result.version;
    provenance.created = result.created;
    return page("Searle: run time against error", body + page_footer(provenance));
}

} // namespace searle::app::bench
