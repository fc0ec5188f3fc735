#include "rheometry/report/particle_stress.hpp"

#include "markup_check.hpp"
#include "rheometry/report/describe_fluid.hpp"
#include "rheometry/report/report.hpp"

#include <gtest/gtest.h>

namespace searle::rheometry::report {
namespace {

/// A run of two points, 90 and 180 1/s, of water with particles whose stress is `share` of water's.
OverlayRun run_with(const std::string& name, double share, double scatter, bool particles) {
    OverlayRun run;
    run.name = name;
    run.fluid = describe_fluid(laws::flow::Newtonian{1e-3}, 1000.0);
    if (particles)
        run.particles = ParticlesNote{.volume_fraction = 0.04, .carries_stress = share > 0.05};
    for (const double rate : {90.0, 180.0}) {
        RheogramPoint point;
        point.shear_rate = rate;
        point.steady_stress = 1e-3 * rate;
        point.shear_stress = 1e-3 * rate * (1.0 + share);
        point.viscosity = point.shear_stress / rate;
        if (particles) {
            SuspensionStress stress;
            stress.fluid = 1e-3 * rate * (1.0 + 0.25 * share);
            stress.hydrodynamic = 1e-3 * rate * 0.75 * share;
            stress.bulk_fluid = 1e-3 * rate;
            stress.bulk_hydrodynamic = 1e-3 * rate * 0.5 * share;
            stress.bulk_contact = 1e-3 * rate * 0.3 * share;
            stress.statistical_error = scatter * point.shear_stress;
            point.suspension = stress;
        }
        run.rheogram.points.push_back(point);
    }
    return run;
}

std::string joined(const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts)
        all += text + "\n";
    return all;
}

TEST(ReportParticles, shares_of_the_bulk_and_inertia_make_up_the_whole) {
    const OverlayRun run = run_with("a", 0.2, 0.01, true);
    const ParticleShares shares =
        particle_shares(run.rheogram.points.back(), run.fluid.true_stress);
    EXPECT_NEAR(shares.whole, 1.2, 1e-12);
    EXPECT_NEAR(shares.hydrodynamic, 0.1, 1e-12);
    EXPECT_NEAR(shares.contact, 0.06, 1e-12);
    EXPECT_NEAR(1.0 + shares.hydrodynamic + shares.contact + shares.dlvo + shares.brownian +
                    shares.inertia,
                shares.whole, 1e-12);
    EXPECT_NEAR(shares.whole_error, 0.01, 1e-12);
}

TEST(ReportParticles, a_sweep_says_where_its_runs_differ_and_what_their_errors_can_tell) {
    OverlayInput input;
    input.runs = {run_with("water", 0.0, 0.0, false), run_with("plain", 0.001, 0.004, true),
                  run_with("spheres", 0.12, 0.004, true)};
    const std::string text = joined(particle_remarks(input));
    EXPECT_NE(text.find("plain against water +0.10"), std::string::npos) << text;
    EXPECT_NE(text.find("(no difference that these runs can tell)"), std::string::npos) << text;
    EXPECT_NE(text.find("spheres against water +12.00"), std::string::npos) << text;
    EXPECT_NE(text.find("spheres against plain +11.89"), std::string::npos) << text;
    // 2.5 times 0.04.
    EXPECT_NE(text.find("+10.00"), std::string::npos) << text;
    input.runs.resize(1);
    EXPECT_TRUE(particle_remarks(input).empty());
}

TEST(ReportParticles, the_page_over_a_sweep_has_the_parts_of_each_run) {
    OverlayInput input;
    input.runs = {run_with("water", 0.0, 0.0, false), run_with("<plain>", 0.2, 0.004, true)};
    const std::string page = render_overlay(input);
    EXPECT_NE(page.find("Stress of the particles"), std::string::npos);
    EXPECT_EQ(page.find("<plain>"), std::string::npos) << "names are escaped";
    for (const std::string& drawing : test::drawings_in(page))
        EXPECT_EQ(test::markup_fault(drawing), "");
}

} // namespace
} // namespace searle::rheometry::report
