#include "solvers/suspension/inertial_motion.hpp"
#include "solvers/suspension/suspension_rows.hpp"
#include "solvers/suspension/suspension_solver.hpp"
#include "suspension_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace searle::solvers::suspension {
namespace {

/// A held step as the solver makes one: 200 samples over a strain, the start-up found by the test.
rheometry::SuspensionStress held_step(std::uint64_t seed, double strain) {
    const double rate = 100.0;
    SuspensionInput input = testing::zirconia(10e-6, 0.25, rate);
    input.settings.hydrodynamics = Hydrodynamics::stresslet;
    input.accuracy = 1e-2;
    testing::pack(input, seed);
    InertialMotion motion(input);
    const WallSpeed speed = [&](double) { return rate * 10e-6; };
    std::vector<StressSample> samples;
    for (int k = 1; k <= 200; ++k) {
        SampleMean mean;
        const double until = strain / rate * k / 200.0;
        while (motion.time() < until)
            mean.add(motion.advance(speed, until));
        samples.push_back(mean.mean());
    }
    return row_of_hold(samples, true, -1.0, 1.0, {}).suspension.value();
}

TEST(ScatterOfSeeds, errors_of_short_runs_are_as_large_as_seeds_differ) {
    // Runs over less than the strain in which contacts come and go. The mean over the seeds stands
    // for the truth; its own error, and the start-up that all have in common, are within the
    // margins.
    constexpr int seeds = 12;
    std::vector<rheometry::SuspensionStress> runs;
    double mean = 0.0;
    for (int seed = 1; seed <= seeds; ++seed) {
        runs.push_back(held_step(static_cast<std::uint64_t>(seed), 0.8));
        mean += runs.back().total() / seeds;
    }
    int within_two = 0;
    double spread = 0.0;
    double claimed = 0.0;
    for (const auto& run : runs) {
        within_two += std::abs(run.total() - mean) <= 2.0 * run.statistical_error;
        spread += (run.total() - mean) * (run.total() - mean) / (seeds - 1);
        claimed += run.statistical_error * run.statistical_error / seeds;
    }
    const double ratio = std::sqrt(claimed / spread);
    RecordProperty("error_over_spread", std::to_string(ratio));
    // The spread of twelve has a standard error of 21 %.
    EXPECT_GT(ratio, 0.6);
    EXPECT_LT(ratio, 3.0);
    EXPECT_GE(within_two, 9);
    // Each says that it is too short.
    for (const auto& run : runs)
        EXPECT_LT(run.independent_values, 6.0);
}

/// The ramp of the paper's Figure 5 with plain particles, in a box of ninety spheres.
rheometry::TorqueHistory ramp(std::int64_t seed) {
    Scene scene;
    scene.instrument = geometry::Box{.gap = 15e-6, .length = 15e-6, .width = 15e-6};
    scene.fluid = {laws::flow::Newtonian{testing::water_viscosity}, testing::water_density};
    scene.protocol.program = rheometry::Ramp{.to = {180.0}, .duration = 0.01, .points = 10};
    scene.conversion.definition = rheometry::default_definition(scene.instrument);
    scene.conversion.end_factor = 1.0;
    scene.solver.accuracy = 1e-2;
    ParticleSettings settings;
    settings.diameter = 1.5e-6;
    settings.density = 5700.0;
    settings.volume_fraction = 0.0468;
    settings.hydrodynamics = Hydrodynamics::drag;
    settings.contact.emplace();
    settings.contact->stiffness = 1e-2;
    settings.seed = seed;
    scene.particles = settings;
    return solve_suspension(scene, make_plan(scene), {}).solution.history;
}

TEST(ScatterOfSeeds, errors_of_a_ramp_are_as_large_as_packings_differ) {
    constexpr int seeds = 10;
    std::vector<rheometry::TorqueHistory> runs;
    for (int seed = 1; seed <= seeds; ++seed)
        runs.push_back(ramp(seed));
    for (const std::size_t row : {3U, 5U, 7U, 9U}) {
        double mean = 0.0;
        for (const auto& run : runs)
            mean += run.rows[row].suspension->total() / seeds;
        double spread = 0.0;
        double claimed = 0.0;
        for (const auto& run : runs) {
            const auto& stress = *run.rows[row].suspension;
            spread += (stress.total() - mean) * (stress.total() - mean) / (seeds - 1);
            claimed += stress.statistical_error * stress.statistical_error / seeds;
        }
        // The spread of ten has a standard error of 24 %, the contacts of ninety spheres are rare
        // events; without the scatter of the whole ramp the ratio is 0.01 to 0.1.
        EXPECT_GT(std::sqrt(claimed / spread), 0.5) << "row " << row;
        EXPECT_LT(std::sqrt(claimed / spread), 3.0) << "row " << row;
    }
}

} // namespace
} // namespace searle::solvers::suspension
