#include "rheometry/report/number_text.hpp"
#include "rheometry/report/property_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace searle::rheometry::report {

namespace {

constexpr int digits = 9;
constexpr std::string_view rate = "<i>\u03b3\u0307</i>";
constexpr std::string_view stress = "<i>\u03c4</i>";
constexpr std::string_view bob = "<i>R</i><sub>bob</sub>";
constexpr std::string_view cup = "<i>R</i><sub>cup</sub>";

std::string fraction(const std::string& above, const std::string& below) {
    return "<span class=\"fraction\"><span>" + above + "</span><span>" + below + "</span></span>";
}

struct Formulas {
    std::string stress;
    std::string rate;
    std::string meaning;
};

Formulas single_gap_formulas(RateDefinition definition) {
    const std::string delta2 = "<i>\u03b4</i>\u00b2";
    const std::string wall_stress = fraction("<i>M</i>", "2\u03c0 <i>L</i> " + std::string{bob} +
                                                             "\u00b2 <i>c</i><sub>L</sub>");
    switch (definition) {
    case RateDefinition::bob_wall:
        return {wall_stress, fraction("2 " + delta2, delta2 + " \u2212 1") + " <i>\u03c9</i>",
                "stress and Newtonian rate at the bob\u2019s wall"};
    case RateDefinition::iso_3219:
        return {fraction("1 + " + delta2, "2 " + delta2) + " " + wall_stress,
                fraction("1 + " + delta2, delta2 + " \u2212 1") + " <i>\u03c9</i>",
                "ISO 3219 / DIN 53019 representative values: means of both walls\u2019 Newtonian "
                "values"};
    case RateDefinition::mean_radius:
        break;
    }
    const std::string mean = "<i>R</i><sub>m</sub>\u00b2";
    const std::string squares = std::string{bob} + "\u00b2 " + std::string{cup} + "\u00b2";
    return {fraction("<i>M</i>", "2\u03c0 <i>L</i> " + mean + " <i>c</i><sub>L</sub>"),
            fraction("2 " + squares, "(" + std::string{cup} + "\u00b2 \u2212 " + std::string{bob} +
                                         "\u00b2) " + mean) +
                " <i>\u03c9</i>",
            "stress and Newtonian rate at the mean radius <i>R</i><sub>m</sub> = (" +
                std::string{bob} + " + " + std::string{cup} + ")/2"};
}

Formulas double_gap_formulas() {
    const auto area = [](const char* inner, const char* outer) {
        const std::string a = "<i>R</i><sub>" + std::string{inner} + "</sub>\u00b2";
        const std::string b = "<i>R</i><sub>" + std::string{outer} + "</sub>\u00b2";
        return fraction(a + " " + b, b + " \u2212 " + a);
    };
    return {fraction(std::string{rate} + " <i>M</i>",
                     "4\u03c0 <i>\u03c9</i> <i>L</i> <i>c</i><sub>L</sub>") +
                " / [" + area("1", "2") + " + " + area("3", "4") + "]",
            fraction("1 + <i>\u03b4</i>\u00b2", "<i>\u03b4</i>\u00b2 \u2212 1") + " <i>\u03c9</i>",
            "ISO 3219 / DIN 53019 representative values, exact for a Newtonian fluid whatever the "
            "radii"};
}

Formulas formulas_of(const ReportInput& input) {
    if (is_periodic(input)) {
        return {
            fraction("<i>F</i>", "<i>\u2113</i> <i>b</i> <i>c</i><sub>L</sub>"),
            fraction("<i>U</i>", "<i>h</i>"),
            "stress of the bulk (<i>F</i> is what it would be on the area of the top), speed of "
            "the image above over gap"};
    }
    if (std::holds_alternative<geometry::Box>(input.instrument)) {
        return {fraction("<i>F</i>", "<i>\u2113</i> <i>b</i> <i>c</i><sub>L</sub>"),
                fraction("<i>U</i>", "<i>h</i>"), "force over area, speed over gap"};
    }
    if (std::holds_alternative<geometry::DoubleGap>(input.instrument)) {
        return double_gap_formulas();
    }
    return single_gap_formulas(input.conversion.definition);
}

double used_end_factor(const EndEffect& row) {
    return std::isfinite(row.with_inertia) ? row.with_inertia : row.end_factor;
}

} // namespace

bool has_computed_end_factors(const ReportInput& input) {
    return input.conversion.end_factor_provisional && !input.ends.empty();
}

std::string computed_end_factors(const ReportInput& input) {
    const auto [least, most] = std::ranges::minmax_element(input.ends, {}, used_end_factor);
    const std::string from = significant(used_end_factor(*least), 5);
    const std::string to = significant(used_end_factor(*most), 5);
    return from == to ? from : from + " \u2013 " + to;
}

std::vector<PropertyRow> conversion_rows(const ReportInput& input) {
    const Conversion& conversion = input.conversion;
    const bool rotates = geometry::rotates(input.instrument);
    const bool is_computed = has_computed_end_factors(input);
    const Formulas formulas = formulas_of(input);
    std::vector<PropertyRow> rows;
    rows.push_back(
        {"Convention", "",
         (rotates ? "<b>" + std::string{name_of(conversion.definition)} + "</b>: " : "") +
             formulas.meaning + source_note(input, "conversion.definition")});
    rows.push_back({"End-effect factor", "<i>c</i><sub>L</sub>",
                    (is_computed ? "computed for each speed, " + computed_end_factors(input)
                                 : significant(conversion.end_factor, digits)) +
                        source_note(input, "conversion.end_factor")});
    // Of computed factors each row has its own: what is common to all is left.
    const double per_torque =
        conversion.stress_per_torque * (is_computed ? conversion.end_factor : 1.0);
    rows.push_back(
        {"Shear stress", std::string{stress},
         formulas.stress + " = " + significant(per_torque, digits) +
             (rotates ? "\u00a0Pa/(N\u00a0m) \u00d7 <i>M</i>" : "\u00a0Pa/N \u00d7 <i>F</i>") +
             (is_computed ? " / <i>c</i><sub>L</sub>" : "")});
    rows.push_back({"Shear rate", std::string{rate},
                    formulas.rate + " = " + significant(conversion.rate_per_speed, digits) +
                        (rotates ? " <i>\u03c9</i>" : "\u00a01/m \u00d7 <i>U</i>")});
    const double speed = conversion.speed(1.0);
    std::string one = quantity_text(speed, rotates ? "rad/s" : "m/s", 6);
    if (rotates) {
        one += " = " + significant(speed * 30.0 / std::numbers::pi, 6) + "\u00a0rpm";
    }
    rows.push_back({"Speed at 1\u00a01/s", rotates ? "<i>\u03c9</i>" : "<i>U</i>", one});
    rows.push_back({"Viscosity", "<i>\u03b7</i>", std::string{stress} + "/" + std::string{rate}});
    return rows;
}

} // namespace searle::rheometry::report
