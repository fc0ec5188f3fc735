#include "rheometry/report/report.hpp"

#include "markup_check.hpp"
#include "rheometry/report/describe_fluid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>

namespace searle::rheometry::report {
namespace {

// The water ramp of the 14/15 mm gap with its long-time inertia, eta_app/eta = 1 + 0.2996 s / t.
ReportInput water_ramp(int points) {
    ReportInput input;
    input.title = "Water in a 1 mm gap";
    input.provenance.case_file = "single-gap-water.toml";
    input.provenance.case_hash = "0123abcd";
    input.provenance.program_version = "0.1.0";
    input.provenance.engine = "native";
    input.provenance.model = "radial transient";
    input.provenance.model_reason = "Inertia matters";
    input.instrument = geometry::ConcentricCylinders{0.014, 0.015, 0.042};
    input.fluid = describe_fluid(laws::flow::Newtonian{1.0016e-3}, 998.2);
    input.conversion.definition = RateDefinition::bob_wall;
    input.conversion.stress_per_torque = 1.0 / (2.0 * std::numbers::pi * 0.042 * 0.014 * 0.014);
    input.conversion.rate_per_speed = 15.517241379310345;
    input.protocol = "ramp from 0 to 100 1/s in 35 s";
    input.source_lines = {{"geometry.bob_radius", 7}, {"fluid.viscosity", 13}};
    input.transient = true;
    input.accuracy = 1e-3;
    for (int k = 1; k <= points; ++k) {
        RheogramPoint point;
        point.time = 35.0 * k / points;
        point.shear_rate = 100.0 * k / points;
        point.steady_stress = 1.0016e-3 * point.shear_rate;
        point.shear_stress = point.steady_stress * (1.0 + 0.2996 / point.time);
        point.viscosity = point.shear_stress / point.shear_rate;
        point.stress_error = 3e-4 * point.shear_stress;
        point.speed = point.shear_rate / input.conversion.rate_per_speed;
        point.torque = point.shear_stress / input.conversion.stress_per_torque;
        point.regime = point.time < 30.0 ? "lag" : "laminar";
        input.rheogram.points.push_back(point);
    }
    input.validity = {{"inertia", true, "It is 86 % of the first stress"},
                      {"Taylor vortices", false, "Re/Re_c is 0.56"}};
    input.vortex_onset = VortexOnset{183.7, 102.9, 3.127, 178.6, "Newtonian viscosity"};
    input.timings = {{"solve", 0.004, 0.004}};
    return input;
}

void expect_sound(const std::string& page, std::size_t drawings) {
    const std::vector<std::string> found = test::drawings_in(page);
    EXPECT_EQ(found.size(), drawings);
    for (const std::string& drawing : found) {
        EXPECT_EQ(test::markup_fault(drawing), "");
        EXPECT_EQ(test::not_a_number_in(drawing), "");
    }
    EXPECT_EQ(test::not_a_number_in(page), "");
    for (const char* tag : {"table", "tr", "td", "th", "div", "figure", "details", "p", "i", "b",
                            "sub", "sup", "span", "dl", "dt", "dd"}) {
        const std::string open = std::string{"<"} + tag;
        const std::size_t opened =
            test::count_of(page, open + ">") + test::count_of(page, open + " ");
        EXPECT_EQ(opened, test::count_of(page, std::string{"</"} + tag + ">")) << tag;
    }
}

bool says(const std::string& page, std::string_view text) {
    return page.find(text) != std::string::npos;
}

std::string percent_decoded(std::string_view text) {
    std::string out;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] == '%') {
            out += static_cast<char>(std::stoi(std::string{text.substr(k + 1, 2)}, nullptr, 16));
            k += 2;
        } else {
            out += text[k];
        }
    }
    return out;
}

TEST(report_page, a_ramp_has_all_its_figures_and_tables) {
    const std::string page = render_report(water_ramp(100));
    // Rheogram twice, viscosity, deviation, torque, error, instrument.
    expect_sound(page, 7);
    for (const char* text :
         {"Figure 1.", "Figure 5.", "Table 6.", "bob-wall", "(line 7)", "(line 13)", "native",
          "radial transient", "183.7", "lag", "0123abcd", "single-gap-water.toml", "86 %",
          "everywhere smaller than the symbols"}) {
        EXPECT_TRUE(says(page, text)) << text;
    }
}

TEST(report_page, nothing_is_fetched_from_a_network) {
    ReportInput input = water_ramp(20);
    input.csv = "a,b\n1,2\n";
    const std::string page = render_report(input);
    for (const char* text : {"http", "src=", "@import", "url(//", "<script", "<link", "file:"}) {
        EXPECT_FALSE(says(page, text)) << text;
    }
}

TEST(report_page, every_text_from_outside_is_escaped) {
    const std::string evil = "<script>alert(\"1\")</script> & 'x'";
    ReportInput input = water_ramp(5);
    input.title = evil;
    input.protocol = evil;
    input.provenance = {evil, evil, evil, evil, evil, evil, evil};
    input.fluid.model = evil;
    input.fluid.parameters.push_back({evil, 1.0, evil});
    input.validity.push_back({evil, true, evil});
    input.vortex_onset->basis = evil;
    input.warnings = {evil};
    input.remarks = {evil};
    input.timings.push_back({evil, 1.0, 1.0});
    input.solver_facts.push_back({evil, evil});
    input.measured.push_back({evil, {1.0, 2.0}, {1e-3, 2e-3}, {}});
    input.compared_with.push_back({evil, input.rheogram});
    for (RheogramPoint& point : input.rheogram.points) {
        point.regime = evil;
    }
    input.csv = evil;
    input.csv_file_name = evil;
    const std::string page = render_report(input);
    EXPECT_FALSE(says(page, "<script"));
    EXPECT_FALSE(says(page, "alert(\""));
    EXPECT_TRUE(says(page, "&lt;script&gt;alert(&quot;1&quot;)"));
    expect_sound(page, 7);

    OverlayInput overlay;
    overlay.title = evil;
    overlay.swept_keys = {evil};
    OverlayRun run;
    run.name = evil;
    run.link = evil;
    run.swept_values = {evil};
    run.warnings = {evil};
    run.fluid = input.fluid;
    run.rheogram = input.rheogram;
    overlay.runs = {run, run};
    const std::string sweep = render_overlay(overlay);
    EXPECT_FALSE(says(sweep, "<script"));
    expect_sound(sweep, 4);
}

TEST(report_page, the_csv_link_holds_the_same_bytes) {
    ReportInput input = water_ramp(3);
    input.csv = "time_s,regime\n1.5e-3,lag+taylor-vortices\n\"a % # & b\",\xc3\xa9\n";
    const std::string page = render_report(input);
    const std::string start = "href=\"data:text/csv;charset=utf-8,";
    const std::size_t from = page.find(start) + start.size();
    const std::size_t to = page.find('"', from);
    const std::string_view link = std::string_view{page}.substr(from, to - from);
    EXPECT_EQ(percent_decoded(link), input.csv);
    EXPECT_EQ(link.find_first_of("#\"<> \n"), std::string_view::npos);
}

TEST(report_page, a_hundred_thousand_rows_stay_below_two_megabytes_and_it_says_so) {
    ReportInput input = water_ramp(100'000);
    input.csv.assign(20'000'000, '1');
    const std::string page = render_report(input);
    EXPECT_LT(page.size(), 2'000'000u);
    EXPECT_TRUE(says(page, "of which 1000 are listed"));
    EXPECT_TRUE(says(page, "are left out; the data file has all points"));
    EXPECT_TRUE(says(page, "<code>rheogram.csv</code> beside this page"));
    expect_sound(page, 7);
}

TEST(report_page, points_at_rest_negative_or_undefined_are_left_out_with_a_note) {
    ReportInput input = water_ramp(50);
    auto& points = input.rheogram.points;
    points[0].shear_rate = points[0].shear_stress = 0.0;
    points[0].viscosity = std::numeric_limits<double>::quiet_NaN();
    points[1].shear_stress = -1e-4;
    points[2].shear_stress = std::numeric_limits<double>::infinity();
    points[3].stress_error = std::numeric_limits<double>::quiet_NaN();
    points[4].shear_rate = -2.0;
    points[5].torque = -std::numeric_limits<double>::infinity();
    points[6].time = std::numeric_limits<double>::quiet_NaN();
    points[7].steady_stress = std::numeric_limits<double>::quiet_NaN();
    const std::string page = render_report(input);
    EXPECT_TRUE(says(page, "not shown"));
    expect_sound(page, 8); // the drive is no single ramp any more, so its course is drawn too
}

TEST(report_page, a_history_that_goes_up_and_down_shows_its_direction) {
    ReportInput input = water_ramp(40);
    auto& points = input.rheogram.points;
    for (std::size_t k = 20; k < points.size(); ++k) {
        points[k].shear_rate = points[39 - k].shear_rate;
        points[k].speed = points[39 - k].speed;
    }
    const std::string page = render_report(input);
    EXPECT_TRUE(says(page, "falling rate"));
    EXPECT_TRUE(says(page, "Arrows give the order in time"));
    expect_sound(page, 8);
}

TEST(report_page, steady_series_draw_the_torque_over_the_speed_and_no_times) {
    ReportInput input = water_ramp(30);
    input.transient = false;
    const std::string page = render_report(input);
    EXPECT_TRUE(says(page, "Angular velocity"));
    EXPECT_FALSE(says(page, "Time <tspan"));
    EXPECT_FALSE(says(page, "title=\"Time\""));
    expect_sound(page, 7);
}

TEST(report_page, every_instrument_spells_its_conversion_out) {
    ReportInput input = water_ramp(10);
    const auto page_with = [&](geometry::Instrument instrument, RateDefinition definition) {
        input.instrument = instrument;
        input.conversion.definition = definition;
        const std::string page = render_report(input);
        expect_sound(page, 7);
        return page;
    };
    EXPECT_TRUE(says(
        page_with(geometry::ConcentricCylinders{0.014, 0.015, 0.042}, RateDefinition::mean_radius),
        "mean radius"));
    EXPECT_TRUE(says(page_with(geometry::DoubleGap{{0.020, 0.02038, 0.02196, 0.02238}, 0.055},
                               RateDefinition::iso_3219),
                     "whatever the radii"));
    EXPECT_TRUE(
        says(page_with(geometry::Box{5e-5, 5e-5, 5e-5}, RateDefinition::iso_3219), "Wall force"));
    geometry::DinBob bob;
    bob.bob_radius = 0.014;
    bob.cup_radius = 1.0847 * 0.014;
    // ISO proportions: 8.1695 R^3 (physics notes, checked value).
    EXPECT_TRUE(says(page_with(bob, RateDefinition::iso_3219), "8.1695 <i>R</i>"));
}

TEST(report_page, nothing_at_all_still_gives_a_page) {
    ReportInput nothing;
    const std::string page = render_report(nothing);
    EXPECT_EQ(test::not_a_number_in(page), "");
    EXPECT_TRUE(says(page, "0 points"));
    EXPECT_EQ(test::not_a_number_in(render_overlay(OverlayInput{})), "");
    expect_sound(render_report(water_ramp(1)), 7);
}

TEST(report_page, a_sweep_links_its_runs_and_draws_the_law_once) {
    OverlayInput input;
    input.title = "Figure 3";
    input.swept_keys = {"geometry.cup_radius", "protocol.duration"};
    for (int k = 0; k < 6; ++k) {
        const ReportInput one = water_ramp(20);
        OverlayRun run;
        run.name = "run " + std::to_string(k);
        run.link = "run-" + std::to_string(k) + "/report.html";
        run.swept_values = {std::to_string(k / 2) + " mm", std::to_string(k % 2) + " s"};
        run.fluid = one.fluid;
        run.conversion = one.conversion;
        run.rheogram = one.rheogram;
        run.transient = true;
        input.runs.push_back(run);
    }
    const std::string page = render_overlay(input);
    expect_sound(page, 4);
    for (int k = 0; k < 6; ++k) {
        EXPECT_TRUE(says(page, "href=\"run-" + std::to_string(k) + "/report.html\""));
    }
    for (const std::string& drawing : test::drawings_in(page)) {
        EXPECT_LE(test::count_of(drawing, "flow law of the fluid</text>"), 1u);
    }
    // One legend for the two panels of each of the two figures.
    EXPECT_EQ(test::count_of(page, "run 5</text>"), 2u);
    EXPECT_EQ(test::count_of(page, "flow law of the fluid</text>"), 2u);
}

TEST(report_page, runs_of_a_sweep_never_look_alike) {
    OverlayInput input;
    input.swept_keys = {"geometry.cup_radius", "protocol.type"};
    for (const char* radius : {"14.5 mm", "15 mm", "16 mm"}) {
        for (const char* type : {"ramp", "ramp", "ramp", "segments"}) {
            OverlayRun run;
            run.name = "run";
            run.swept_values = {radius, type};
            run.rheogram = water_ramp(1).rheogram;
            input.runs.push_back(run);
        }
    }
    const std::string drawing = test::drawings_in(render_overlay(input)).front();
    std::set<std::string> looks;
    // The legend's markers stand before their texts; their places are cut off.
    for (std::size_t at = drawing.find("<line class=\"line"); at != std::string::npos;
         at = drawing.find("<line class=\"line", at + 1)) {
        const std::size_t marker = drawing.find("/>", at) + 2;
        const std::string element = drawing.substr(marker, drawing.find("/>", marker) - marker);
        const std::size_t shape = element.find('m', element.find(" d=\""));
        looks.insert(element.substr(0, element.find("\"", 20)) +
                     (shape == std::string::npos ? "circle" : element.substr(shape)));
    }
    EXPECT_EQ(looks.size(), 12u);
}

TEST(report_page, a_sweep_of_hundreds_of_runs_stays_below_two_megabytes) {
    OverlayInput input;
    for (int k = 0; k < 300; ++k) {
        OverlayRun run;
        run.name = "run number " + std::to_string(k);
        run.rheogram = water_ramp(2000).rheogram;
        run.fluid = water_ramp(1).fluid;
        input.runs.push_back(run);
    }
    const std::string page = render_overlay(input);
    EXPECT_LT(page.size(), 2'000'000u);
    EXPECT_TRUE(says(page, "named when one points at its line"));
    expect_sound(page, 4);
}

TEST(report_page, warnings_of_the_runs_are_listed_below_the_table) {
    OverlayInput input;
    OverlayRun run;
    run.name = "first";
    run.warnings = {"Taylor vortices at 25 rows, Re / Re_c = 2"};
    input.runs = {run, OverlayRun{}};
    const std::string page = render_overlay(input);
    EXPECT_TRUE(says(page, "1 with warnings"));
    EXPECT_TRUE(says(page, "Taylor vortices at 25 rows, Re / Re<sub>c</sub> = 2"));
}

} // namespace
} // namespace searle::rheometry::report
