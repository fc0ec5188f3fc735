#include "rheometry/conversion/conversion.hpp"
#include "rheometry/fit/prediction.hpp"
#include "solvers/fit_instrument/fit_instrument.hpp"
#include "solvers/radial/radial_solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

namespace fit = searle::rheometry::fit;
namespace through = searle::solvers::fit_instrument;
namespace geometry = searle::geometry;
namespace rheometry = searle::rheometry;

const fit::Model& herschel_bulkley() { return *fit::model_named("herschel-bulkley"); }

/// 10/20 mm: plug at low speeds, and a rate at the bob far from the conversion's.
const geometry::Instrument wide_gap = geometry::ConcentricCylinders{0.010, 0.020, 0.060};
const geometry::Instrument narrow_gap = geometry::ConcentricCylinders{0.014, 0.015, 0.042};

struct Experiment {
    std::vector<through::Measurement> measurements;
    fit::FlowData converted;
};

void add(Experiment& experiment, std::vector<fit::MeasuredPoint>& points,
         const geometry::Instrument& instrument, const std::vector<double>& speeds,
         const std::vector<double>& torques, double end_factor) {
    const rheometry::Conversion conversion = rheometry::conversion_for(
        instrument, {.definition = std::nullopt, .end_factor = end_factor});
    for (std::size_t k = 0; k < speeds.size(); ++k)
        points.push_back({conversion.shear_rate(speeds[k]), conversion.shear_stress(torques[k]),
                          std::numeric_limits<double>::quiet_NaN(), 0, ""});
    experiment.measurements.push_back({instrument, {end_factor}, speeds, torques});
}

/// Torques of the steady solver (not of the fit's own forward model), with relative scatter.
std::vector<double> torques_of(const geometry::Instrument& instrument,
                               const std::vector<double>& values, const std::vector<double>& speeds,
                               double end_factor, double noise, unsigned seed) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal;
    const searle::laws::flow::AnyFlowLaw law =
        searle::laws::flow::HerschelBulkley{values[0], values[1], values[2]};
    std::vector<double> torques;
    for (const double speed : speeds)
        torques.push_back(
            searle::solvers::radial::steady_instrument_flow(instrument, law, speed).torque *
            end_factor * (1.0 + noise * normal(engine)));
    return torques;
}

Experiment single(const geometry::Instrument& instrument, const std::vector<double>& values,
                  double noise, unsigned seed, double end_factor = 1.0) {
    const std::vector<double> speeds = fit::spread_rates(0.01, 50.0, 25);
    Experiment experiment;
    std::vector<fit::MeasuredPoint> points;
    add(experiment, points, instrument, speeds,
        torques_of(instrument, values, speeds, end_factor, noise, seed), end_factor);
    experiment.converted = fit::select_points(points, {});
    return experiment;
}

const std::vector<double> truth{20.0, 2.0, 0.4};

// The forward model against the radial solver, an independent text: both claim 1e-10 or better.
TEST(FitInstrument, forward_model_matches_the_radial_solver) {
    const std::vector<double> speeds = fit::spread_rates(1e-3, 100.0, 11);
    const std::vector<geometry::Instrument> instruments{
        wide_gap, narrow_gap, geometry::DoubleGap{{0.020, 0.02038, 0.02196, 0.02238}, 0.05},
        geometry::Box{0.001, 0.02, 0.03}};
    for (const auto& instrument : instruments)
        for (const double yield : {0.0, 20.0}) {
            const std::vector<double> values{yield, 2.0, 0.4};
            const through::InstrumentForward forward(herschel_bulkley(),
                                                     {{instrument, {1.0}, speeds, {}}}, false);
            std::vector<double> found(speeds.size());
            ASSERT_TRUE(forward.predict(herschel_bulkley().search(values), found, {}));
            const std::vector<double> expected =
                torques_of(instrument, values, speeds, 1.0, 0.0, 1);
            for (std::size_t k = 0; k < speeds.size(); ++k)
                EXPECT_NEAR(found[k] / expected[k], 1.0, 1e-9)
                    << geometry::name_of(instrument) << " " << speeds[k] << " yield " << yield;
        }
}

// The sensitivities against central differences of the torque, plug and slip included. The slip's
// step is 1e-4 of its value, and so is the difference's error where the plug reaches the cup (the
// second derivative jumps there); the laws' steps are 1e-5.
TEST(FitInstrument, derivatives_match_differences) {
    const std::vector<double> speeds = fit::spread_rates(1e-2, 50.0, 7);
    const through::InstrumentForward forward(herschel_bulkley(), {{wide_gap, {1.0}, speeds, {}}},
                                             true);
    std::vector<double> search = herschel_bulkley().search(truth);
    search.push_back(1e-6);
    std::vector<double> values(speeds.size());
    std::vector<double> jacobian(speeds.size() * search.size());
    ASSERT_TRUE(forward.predict(search, values, jacobian));
    for (std::size_t i = 0; i < search.size(); ++i) {
        const double step = i == 3 ? 1e-10 : 1e-5;
        std::vector<double> up = search;
        std::vector<double> down = search;
        up[i] += step;
        down[i] -= step;
        std::vector<double> above(speeds.size());
        std::vector<double> below(speeds.size());
        ASSERT_TRUE(forward.predict(up, above, {}));
        ASSERT_TRUE(forward.predict(down, below, {}));
        for (std::size_t k = 0; k < speeds.size(); ++k) {
            const double difference = (above[k] - below[k]) / (2.0 * step);
            EXPECT_NEAR(jacobian[k * search.size() + i], difference,
                        (i == 3 ? 1e-4 : 1e-5) * std::abs(difference) + 1e-7 * values[k])
                << i << " " << speeds[k];
        }
    }
}

TEST(FitInstrument, exact_torques_give_back_the_parameters) {
    const Experiment experiment = single(wide_gap, truth, 0.0, 1);
    const auto done = through::fit_through(herschel_bulkley(), experiment.measurements,
                                           experiment.converted, {}, false);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(done.result.estimates[i].value / truth[i], 1.0, 1e-6);
}

// 200 data sets in the wide gap, 1 % scatter: each parameter's mean error is within 3 standard
// errors of the mean (0.21 of a single one), intervals hold the truth in 95 +- 4.6 % (3 binomial
// standard deviations). The conventional route's flow index is off by more than 10 of its own
// standard errors.
TEST(FitInstrument, parameters_are_unbiased_where_the_conventional_route_is_not) {
    std::vector<double> sum(3);
    std::vector<int> held(3);
    int conventional_held = 0;
    constexpr int sets = 200;
    for (unsigned seed = 1; seed <= sets; ++seed) {
        const Experiment experiment = single(wide_gap, truth, 0.01, seed);
        fit::FitOptions options;
        options.weighting = fit::Weighting::fitted;
        const auto done = through::fit_through(herschel_bulkley(), experiment.measurements,
                                               experiment.converted, options, false);
        for (std::size_t i = 0; i < 3; ++i) {
            const fit::Estimate& estimate = done.result.estimates[i];
            sum[i] += (estimate.value - truth[i]) / estimate.standard_error / sets;
            held[i] += truth[i] >= estimate.low && truth[i] <= estimate.high;
        }
        const fit::Estimate& index = done.conventional->estimates[1];
        conventional_held += truth[1] >= index.low && truth[1] <= index.high;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LT(std::abs(sum[i]), 0.24) << i;
        EXPECT_GE(held[i], 181) << i;
    }
    EXPECT_LE(conventional_held, 20);
}

// Two gaps, one fluid with a slip of 5e-5 m/(Pa s): found together, each without a guess.
TEST(FitInstrument, slip_is_told_from_the_law_by_two_gaps) {
    constexpr double slip = 5e-5;
    const std::vector<double> values{0.0, 1.5, 0.6};
    const std::vector<double> speeds = fit::spread_rates(0.05, 20.0, 15);
    Experiment experiment;
    std::vector<fit::MeasuredPoint> points;
    unsigned seed = 5;
    for (const auto& instrument : {narrow_gap, wide_gap}) {
        const through::InstrumentForward maker(herschel_bulkley(),
                                               {{instrument, {1.0}, speeds, {}}}, true);
        std::vector<double> search = herschel_bulkley().search(values);
        search.push_back(slip);
        std::vector<double> torques(speeds.size());
        ASSERT_TRUE(maker.predict(search, torques, {}));
        std::mt19937_64 engine(seed++);
        std::normal_distribution<double> normal;
        for (double& torque : torques)
            torque *= 1.0 + 0.005 * normal(engine);
        add(experiment, points, instrument, speeds, torques, 1.0);
    }
    experiment.converted = fit::select_points(points, {});
    const auto done = through::fit_through(herschel_bulkley(), experiment.measurements,
                                           experiment.converted, {}, true);
    ASSERT_EQ(done.result.estimates.size(), 4U);
    const fit::Estimate& found = done.result.estimates[3];
    EXPECT_EQ(found.parameter.key, "slip_coefficient");
    EXPECT_NEAR(found.value, slip, 4.0 * found.standard_error);
    EXPECT_LT(found.standard_error, 0.1 * slip);
}

} // namespace
