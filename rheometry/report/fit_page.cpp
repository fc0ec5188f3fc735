#include "rheometry/report/fit_page.hpp"

#include "rheometry/fit/prediction.hpp"
#include "rheometry/report/figure.hpp"
#include "rheometry/report/number_text.hpp"
#include "rheometry/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace searle::rheometry::report {
namespace {

constexpr std::size_t most_full_curves = 12;
constexpr std::size_t band_points = 121;

Axis axis(RichText name, Scale scale) {
    Axis result;
    result.name = std::move(name);
    result.scale = scale;
    return result;
}

RichText rate_name() { return RichText("shear rate, 1/s"); }

Series line(std::string_view name, Stroke stroke, int colour) {
    Series series;
    series.name = RichText(name);
    series.stroke = stroke;
    series.colour = colour;
    series.sets_range = stroke == Stroke::solid;
    series.thin = stroke != Stroke::solid;
    return series;
}

bool is_through_instrument(const FittedCurve& curve) { return !curve.observed.empty(); }

Series measured(const FittedCurve& curve) {
    Series data;
    data.name = RichText(is_through_instrument(curve) ? "converted" : "measured");
    data.x = curve.data.rates;
    data.y = curve.data.stresses;
    data.marker = is_through_instrument(curve) ? Marker::cross : Marker::circle;
    data.open_marker = true;
    data.colour = is_through_instrument(curve) ? 3 : 0;
    return data;
}

/// The inversion without a law: points, and lines along both ends of their bands.
void add_rotor_points(Plot& plot, const FittedCurve& curve) {
    std::vector<RotorPoint> known;
    for (const RotorPoint& point : curve.rotor_points)
        if (std::isfinite(point.rate) && point.rate > 0.0)
            known.push_back(point);
    if (known.empty())
        return;
    std::ranges::sort(known, {}, &RotorPoint::rate);
    Series points;
    points.name = RichText("true rate at the rotor, no law");
    points.marker = Marker::circle;
    points.open_marker = true;
    Series low = line("95 % of that rate", Stroke::dashed, 0);
    Series high = line("", Stroke::dashed, 0);
    for (const RotorPoint& point : known) {
        points.x.push_back(point.rate);
        points.y.push_back(point.stress);
        low.x.push_back(point.low);
        low.y.push_back(point.stress);
        high.x.push_back(point.high);
        high.y.push_back(point.stress);
    }
    for (Series* series : {&points, &low, &high})
        plot.series.push_back(std::move(*series));
}

std::vector<fit::PredictedPoint> curve_of(const FittedLaw& law, const FittedCurve& curve) {
    if (!law.curve.empty())
        return law.curve;
    const double low = curve.data.rates.front();
    const double high = std::max(curve.data.rates.back(), low * 1.001);
    return fit::predict(*law.law, law.result, curve.data,
                        fit::spread_rates(low * 0.5, high * 2.0, band_points));
}

Plot curve_plot(const FittedCurve& curve, const std::string& id) {
    Plot plot;
    plot.id = id + "-curve";
    plot.title = "Flow curve: data and fitted law";
    plot.x = axis(rate_name(), Scale::logarithmic);
    plot.y = axis(RichText("shear stress, Pa"), Scale::logarithmic);
    plot.series.push_back(measured(curve));
    add_rotor_points(plot, curve);
    const FittedLaw& best = curve.laws.front();
    Series fitted = line(best.result.model, Stroke::solid, 1);
    Series confidence_low = line("95 % of the curve", Stroke::dashed, 1);
    Series prediction_low = line("95 % of a point", Stroke::dotted, 2);
    Series confidence_high = line("", Stroke::dashed, 1);
    Series prediction_high = line("", Stroke::dotted, 2);
    bool bands = false;
    for (const fit::PredictedPoint& point : curve_of(best, curve)) {
        for (Series* series :
             {&fitted, &confidence_low, &confidence_high, &prediction_low, &prediction_high})
            series->x.push_back(point.rate);
        fitted.y.push_back(point.stress);
        confidence_low.y.push_back(point.confidence_low);
        confidence_high.y.push_back(point.confidence_high);
        prediction_low.y.push_back(point.prediction_low);
        prediction_high.y.push_back(point.prediction_high);
        bands = bands || std::isfinite(point.confidence_low);
    }
    plot.series.push_back(std::move(fitted));
    if (bands)
        for (Series* series :
             {&confidence_low, &confidence_high, &prediction_low, &prediction_high})
            plot.series.push_back(std::move(*series));
    return plot;
}

Plot residual_plot(const FittedCurve& curve, const std::string& id) {
    const fit::FitResult& result = curve.laws.front().result;
    const bool through = is_through_instrument(curve);
    const std::vector<double>& rates = through ? curve.observed_rates : curve.data.rates;
    const std::vector<double>& values = through ? curve.observed : curve.data.stresses;
    Plot plot;
    plot.id = id + "-residuals";
    plot.title = "Residuals over the shear rate";
    plot.x = axis(rate_name(), Scale::logarithmic);
    plot.y = axis(RichText(through ? "torque: (fitted - measured) / measured, %"
                                   : "(fitted - measured) / measured, %"),
                  Scale::linear);
    plot.zero_line = true;
    Series series;
    series.name = RichText("residuals");
    series.marker = Marker::circle;
    for (std::size_t k = 0; k < result.fitted.size() && k < values.size(); ++k) {
        series.x.push_back(rates[k]);
        series.y.push_back(100.0 * (result.fitted[k] / values[k] - 1.0));
    }
    plot.series.push_back(std::move(series));
    return plot;
}

std::string limit(double value) {
    return std::isfinite(value) ? significant(value, 5) : "no limit";
}

std::string parameter_table(const FittedLaw& law) {
    const bool compares = !law.conventional.empty();
    std::string out = fmt::format("<h3>Parameters</h3><table><thead><tr><th>parameter</"
                                  "th><th>value</th><th>unit</th><th>standard error</th>"
                                  "<th>95 % from</th><th>to</th>{}</tr></thead><tbody>",
                                  compares ? "<th>conventional route</th>" : "");
    for (std::size_t i = 0; i < law.result.estimates.size(); ++i) {
        const fit::Estimate& estimate = law.result.estimates[i];
        out += fmt::format(
            "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>",
            escaped(estimate.parameter.key), significant(estimate.value, 6),
            estimate.parameter.unit == "1" ? "" : escaped(estimate.parameter.unit),
            std::isfinite(estimate.standard_error) ? significant(estimate.standard_error, 3) : "",
            estimate.parameter.held ? "held" : limit(estimate.low),
            estimate.parameter.held ? "" : limit(estimate.high));
        if (compares)
            out += fmt::format("<td>{}</td>", i < law.conventional.size()
                                                  ? significant(law.conventional[i].value, 6)
                                                  : "");
        out += "</tr>";
    }
    return out + "</tbody></table>\n";
}

std::string correlation_table(const fit::FitResult& result) {
    const std::size_t count = result.estimates.size();
    if (count < 2)
        return "";
    std::string out = "<h3>Correlation of the estimates</h3><table><thead><tr><th></th>";
    for (const fit::Estimate& estimate : result.estimates)
        out += "<th>" + escaped(estimate.parameter.key) + "</th>";
    out += "</tr></thead><tbody>";
    for (std::size_t i = 0; i < count; ++i) {
        out += "<tr><td>" + escaped(result.estimates[i].parameter.key) + "</td>";
        for (std::size_t k = 0; k < count; ++k)
            out += fmt::format("<td>{:.4f}</td>", result.correlation[i * count + k]);
        out += "</tr>";
    }
    return out + "</tbody></table>\n";
}

std::string ranking_table(const FittedCurve& curve) {
    std::string out =
        "<h3>Laws by "
        "AICc</h3><table><thead><tr><th>law</th><th>parameters</th><th>AICc</th><th>BIC</th>"
        "<th>rms, %</th></tr></thead><tbody>";
    for (const FittedLaw& law : curve.laws)
        out += fmt::format("<tr><td>{}</td><td>{}</td><td>{:.2f}</td><td>{:.2f}</td>"
                           "<td>{:.3f}</td></tr>",
                           escaped(law.result.model), law.result.estimates.size(),
                           law.result.criteria.aicc, law.result.criteria.bic,
                           100.0 * law.result.rms_relative);
    return out + "</tbody></table>\n";
}

std::string curve_section(const FittedCurve& curve, std::size_t number, bool named) {
    std::string out =
        "<section><h2>" + (named ? escaped(curve.name) : std::string("Flow curve")) + "</h2>\n";
    if (curve.laws.empty())
        return out + "<p>" + escaped(curve.failure) + "</p></section>\n";
    const FittedLaw& best = curve.laws.front();
    const std::string id = fmt::format("fit{}", number);
    out += warning_box(best.result.warnings);
    FigureBuilder figure;
    figure.add(curve_plot(curve, id));
    figure.add(residual_plot(curve, id));
    out += figure_html(figure.finish(fmt::format(
                           "{} points and the law {}: {}. {} points left out.", curve.data.size(),
                           escaped(best.result.model), escaped(std::string(best.law->formula)),
                           curve.data.excluded.size())),
                       static_cast<int>(number));
    out += parameter_table(best);
    out += paragraphs(curve.notes);
    out += correlation_table(best.result);
    if (curve.laws.size() > 1)
        out += ranking_table(curve);
    out += fmt::format(
        "<p>{} points, {} weights{}; root mean square deviation {} %, R² {:.6f}{}.</p>",
        best.result.points, fit::name_of(best.result.weighting),
        best.result.loss == fit::Loss::squares
            ? ""
            : fmt::format(", {} loss", fit::name_of(best.result.loss)),
        significant(100.0 * best.result.rms_relative, 3), best.result.determination,
        best.result.runs ? fmt::format("; {} runs of sign where {:.0f} are expected (p = {:.2g})",
                                       best.result.runs->runs, best.result.runs->expected_runs,
                                       best.result.runs->probability)
                         : "");
    return out + "</section>\n";
}

std::string batch_table(const FitPageInput& input) {
    std::string out = "<table><thead><tr><th>curve</th><th>law</th><th>points</th><th>rms, %</th>"
                      "<th>parameters</th></tr></thead><tbody>";
    for (const FittedCurve& curve : input.curves) {
        out += "<tr><td>" + escaped(curve.name) + "</td>";
        if (curve.laws.empty()) {
            out += "<td colspan=\"4\">" + escaped(curve.failure) + "</td></tr>";
            continue;
        }
        const fit::FitResult& result = curve.laws.front().result;
        out += fmt::format("<td>{}</td><td>{}</td><td>{:.2f}</td><td>", escaped(result.model),
                           result.points, 100.0 * result.rms_relative);
        for (const fit::Estimate& estimate : result.estimates)
            out += fmt::format("{} {} ± {}; ", escaped(estimate.parameter.key),
                               significant(estimate.value, 4),
                               significant(estimate.standard_error, 2));
        out += "</td></tr>";
    }
    return out + "</tbody></table>\n";
}

} // namespace

std::string render_fit_page(const FitPageInput& input) {
    const bool single = input.curves.size() == 1;
    const std::string title =
        single ? input.curves.front().name : fmt::format("{} curves", input.curves.size());
    std::string body =
        page_header("Fit", title,
                    "Flow laws by least squares; intervals are 95 % profile-likelihood intervals.");
    if (!single)
        body += batch_table(input);
    for (std::size_t i = 0; i < input.curves.size() && i < most_full_curves; ++i)
        body += curve_section(input.curves[i], i + 1, !single);
    Provenance provenance;
    provenance.program_version = input.program_version;
    body += page_footer(provenance);
    return page(title, body);
}

} // namespace searle::rheometry::report
