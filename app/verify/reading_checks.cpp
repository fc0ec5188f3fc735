#include "app/case_reader.hpp"
#include "app/verify/check.hpp"
#include "rheometry/conversion/conversion.hpp"
#include "rheometry/converted_step.hpp"
#include "rheometry/correction/wall_rate.hpp"
#include "rheometry/fit/fit.hpp"
#include "rheometry/fit/prediction.hpp"
#include "solvers/radial/annular_gap.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <string_view>

namespace searle::app::verify {
namespace {

using namespace rheometry;

Found standard_factors() {
    const geometry::DinBob iso{.bob_radius = 0.014, .cup_radius = 0.014 * 1.0847};
    const Conversion mean = conversion_for(iso, {});
    const Conversion wall = conversion_for(iso, {.definition = RateDefinition::bob_wall});
    const double cubed = 0.014 * 0.014 * 0.014;
    // Half a unit of the last digit each.
    return {std::max({std::abs(mean.rate_per_speed - 12.3267) / 5e-5,
                      std::abs(wall.rate_per_speed - 13.3267) / 5e-5,
                      std::abs(mean.stress_per_torque * cubed - 0.0446098) / 5e-8})};
}

Found trios_factors() {
    const Conversion found = conversion_for(
        geometry::DinBob{.bob_radius = 0.014, .cup_radius = 0.0152}, ConversionSettings{});
    return {std::max(std::abs(found.stress_per_torque - 16243.2702) / 5e-5,
                     std::abs(found.rate_per_speed - 12.187215) / 5e-7)};
}

/// The first row of a surfactant's flow sweep as TRIOS exported it, converted here.
Found trios_row() {
    const geometry::DinBob bob{.bob_radius = 0.014, .cup_radius = 0.0152};
    MeasuredStep step;
    step.name = "Flow sweep - 3";
    step.speed = {82.051};
    step.torque = {10561.7e-6};
    step.lines = {1};
    const ConvertedStep converted = convert_step(step, bob, conversion_for(bob, {}));
    const RheogramPoint& point = converted.rheogram.points.at(0);
    return {std::max(relative(point.shear_stress, 171.557), relative(point.shear_rate, 999.973))};
}

Found double_gap_factors() {
    // A Newtonian fluid's torque must read back as its viscosity, whatever the radii.
    double worst = 0.0;
    for (const std::array<double, 4>& radii :
         {std::array{0.020, 0.02038, 0.02196, 0.02238}, std::array{0.01, 0.015, 0.016, 0.03}}) {
        const auto [r1, r2, r3, r4] = radii;
        const geometry::DoubleGap gap{.radii = radii, .height = 0.05};
        const double torque =
            4.0 * std::numbers::pi * 2e-3 * 3.0 * gap.height *
            (r1 * r1 * r2 * r2 / (r2 * r2 - r1 * r1) + r3 * r3 * r4 * r4 / (r4 * r4 - r3 * r3));
        const Conversion found = conversion_for(gap, {});
        worst = std::max(worst, relative(found.shear_stress(torque) / found.shear_rate(3.0), 2e-3));
    }
    return {worst};
}

/// True rates at the bob from torques alone, for a partly and an entirely sheared gap.
Found rates_without_a_law() {
    const auto curve_rate = [](const laws::flow::HerschelBulkley& law, double inner, double outer,
                               double middle, double span, std::size_t count) {
        std::vector<double> speeds;
        std::vector<double> stresses;
        for (std::size_t k = 0; k < count; ++k) {
            const double share = 2.0 * static_cast<double>(k) / static_cast<double>(count - 1) - 1;
            speeds.push_back(middle * std::pow(span, share));
            stresses.push_back(solvers::radial::steady_gap_flow({inner, outer}, law, speeds.back())
                                   .inner_wall_stress);
        }
        return wall_rates(speeds, stresses, outer / inner).rows.at(count / 2).rate;
    };
    return {std::max(
        relative(curve_rate({20.0, 2.0, 0.4}, 0.010, 0.020, 0.05, 32.0, 21), 2.64326276260158),
        relative(curve_rate({5.0, 0.5, 0.5}, 0.014, 0.015, 10.0, 1024.0, 41), 183.887472870097))};
}

/// Parameters of each law from a curve without scatter.
Found known_laws() {
    const std::map<std::string_view, std::vector<double>> truths{
        {"newtonian", {0.8}},
        {"bingham", {4.0, 0.2}},
        {"power-law", {2.0, 0.45}},
        {"herschel-bulkley", {5.0, 0.9, 0.55}},
        {"casson", {3.0, 0.05}},
        {"carreau-yasuda", {20.0, 0.05, 2.0, 0.3, 1.5}},
        {"cross", {20.0, 0.05, 2.0, 0.3}},
        {"sisko", {0.08, 3.0, 0.3}},
        {"ellis", {12.0, 9.0, 2.4}},
        {"windhab", {3.0, 9.0, 0.05, 12.0}}};
    double worst = 0.0;
    for (const fit::Model& law : fit::models()) {
        const std::vector<double>& truth = truths.at(law.name);
        fit::FlowData data;
        data.rates = fit::spread_rates(0.01, 1000.0, 41);
        data.lines.assign(41, 0);
        for (const double rate : data.rates)
            data.stresses.push_back(law.stress(truth, rate));
        const fit::FitResult found =
            fit::fit_flow_curve(law, data, {.profile_intervals = false, .bounds = {}});
        for (std::size_t i = 0; i < truth.size(); ++i)
            worst = std::max(worst, relative(found.estimates.at(i).value, truth[i]));
    }
    return {worst};
}

/// A case with units of all kinds, read to SI.
Found units() {
    const std::vector<Case> cases = read_cases_text(
        "[geometry]\ntype = \"single-gap\"\nbob_radius = \"1.4 cm\"\ncup_radius = \"15 mm\"\n"
        "height = \"42000 um\"\n[fluid]\nmodel = \"newtonian\"\nviscosity = \"1.0016 cP\"\n"
        "density = \"0.9982 g/cm^3\"\n[protocol]\ntype = \"ramp\"\nfrom = \"0 1/s\"\n"
        "to = \"100 1/s\"\nduration = \"0.5 min\"\npoints = 3\n[solver]\naccuracy = \"0.1 %\"\n",
        "units.toml");
    const solvers::Scene& scene = cases.front().scene;
    const auto& gap = std::get<geometry::ConcentricCylinders>(scene.instrument);
    return {
        std::max({relative(gap.bob_radius, 0.014), relative(gap.height, 0.042),
                  relative(std::get<laws::flow::Newtonian>(scene.fluid.law).viscosity, 1.0016e-3),
                  relative(scene.fluid.density, 998.2), relative(scene.solver.accuracy, 1e-3)})};
}

} // namespace

std::vector<Check> reading_checks() {
    const std::string factors = "tests/rheometry/conversion_factors_test.cpp";
    return {
        {.name = "case-units",
         .subject = "case files: units",
         .against = "SI values by hand (cm, um, cP, g/cm^3, %)",
         .tolerance = 1e-15,
         .origin = "rounding",
         .file = "tests/casefile/quantity_test.cpp",
         .test = "quantity.common_units_convert_exactly",
         .run = units},
        {.name = "conversion-iso",
         .subject = "conversion, ISO 3219 bob: both rates and the stress",
         .against = "12.3267, 13.3267 1/s per rad/s; 0.0446098 / R^3; error in half units of the "
                    "last digit",
         .tolerance = 1.0,
         .origin = "half the values' last digit",
         .file = factors,
         .test = "conversion_factors.standard_geometry_matches_the_published_factors",
         .run = standard_factors},
        {.name = "conversion-trios",
         .subject = "conversion, TRIOS' DIN cylinder",
         .against =
             "16243.2702 Pa/(N m) and 12.187215 1/rad; error in half units of the last digit",
         .tolerance = 1.0,
         .origin = "half the values' last digit",
         .file = factors,
         .test = "conversion_factors.ta_din_cylinder_matches_its_own_factors",
         .run = trios_factors},
        {.name = "conversion-trios-row",
         .subject = "conversion of a row that TRIOS exported",
         .against = "the export's own stress and rate",
         .tolerance = 1e-5,
         .origin = "six digits in torque, speed, stress and rate",
         .file = "tests/rheometry/trios_spreadsheet_test.cpp",
         .test = "trios_spreadsheet.stress_and_rate_equal_the_exports_own_columns",
         .run = trios_row},
        {.name = "conversion-double-gap",
         .subject = "conversion, double gaps of equal and unequal ratios",
         .against = "a Newtonian fluid's closed-form torque reads back as its viscosity",
         .tolerance = 1e-13,
         .origin = "rounding",
         .file = factors,
         .test = "conversion_factors.double_gap_is_exact_for_a_newtonian_fluid_whatever_the_radii",
         .run = double_gap_factors},
        {.name = "rates-without-a-law",
         .subject = "true rate at the bob from torques alone, partly and entirely sheared",
         .against = "checked rates 2.64326276260158 and 183.887472870097 1/s",
         .tolerance = 1e-6,
         .origin = "21 and 41 points a curve: the inversion's error falls with their number",
         .file = "tests/rheometry/correction_wall_rate_test.cpp",
         .test = "correction_wall_rate.published_plug_flow_is_found_from_torques_alone",
         .run = rates_without_a_law},
        {.name = "fit-known-laws",
         .subject = "fits of all ten laws to curves without scatter",
         .against = "the parameters that made the curves",
         .tolerance = 1e-7,
         .origin = "where the search stops",
         .file = "tests/rheometry/fit_flow_curve_test.cpp",
         .test = "FitFlowCurve.exact_data_give_back_their_parameters_for_every_law",
         .run = known_laws},
    };
}

} // namespace searle::app::verify
