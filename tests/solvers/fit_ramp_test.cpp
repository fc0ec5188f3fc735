#include "rheometry/conversion/conversion.hpp"
#include "rheometry/fit/ramp_loop.hpp"
#include "solvers/fit_instrument/fit_instrument.hpp"
#include "solvers/fit_instrument/ramp_inertia.hpp"
#include "solvers/radial/radial_solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

namespace fit = searle::rheometry::fit;
namespace rheometry = searle::rheometry;
namespace geometry = searle::geometry;
namespace flow = searle::laws::flow;
namespace through = searle::solvers::fit_instrument;

// Water ramped from rest to 100 1/s (bob wall) in 35 s, 14/15 mm: eta_app/eta at 1, 5, 10 and 35 s
// from the exact series (1.299566, 1.059915, 1.029957, 1.008559).
TEST(RampInertia, of_a_water_ramp_is_that_of_the_exact_series) {
    const geometry::Instrument gap = geometry::ConcentricCylinders{0.014, 0.015, 0.042};
    const auto conversion = rheometry::conversion_for(gap, {});
    through::TimedRows rows;
    for (int k = 1; k <= 70; ++k) {
        rows.times.push_back(0.5 * k);
        rows.speeds.push_back(conversion.speed(100.0) * 0.5 * k / 35.0);
    }
    ASSERT_TRUE(through::has_history(rows));
    const flow::AnyFlowLaw water = flow::Newtonian{1.0016e-3};
    const auto found = through::ramp_inertia(gap, water, 998.2, rows, 1e-5);
    EXPECT_TRUE(found.reached);
    const auto ratio = [&](std::size_t row) {
        return 1.0 + found.torques[row] / searle::solvers::radial::steady_instrument_flow(
                                              gap, water, rows.speeds[row])
                                              .torque;
    };
    EXPECT_NEAR(ratio(1), 1.299566, 2e-5);
    EXPECT_NEAR(ratio(9), 1.059915, 2e-5);
    EXPECT_NEAR(ratio(19), 1.029957, 2e-5);
    EXPECT_NEAR(ratio(69), 1.008559, 2e-5);
}

// A run that is first seen at speed was steady before: no inertia in its first row.
TEST(RampInertia, a_run_that_does_not_start_from_rest_starts_steady) {
    const geometry::Instrument gap = geometry::ConcentricCylinders{0.014, 0.015, 0.042};
    through::TimedRows rows{{1.0, 2.0, 3.0, 4.0}, {5.0, 5.5, 6.0, 6.5}};
    const auto found = through::ramp_inertia(gap, flow::Newtonian{1e-3}, 1000.0, rows, 1e-4);
    ASSERT_TRUE(found.reached);
    EXPECT_NEAR(found.torques[0], 0.0, 1e-4 * 4e-6); // the accuracy asked for
    EXPECT_GT(found.torques[3], 0.0);
}

TEST(RampInertia, needs_times_that_grow) {
    EXPECT_FALSE(through::has_history({{}, {1.0, 2.0, 3.0}}));
    EXPECT_FALSE(through::has_history({{1.0, 1.0, 2.0}, {1.0, 2.0, 3.0}}));
    EXPECT_FALSE(through::has_history({{1.0, 2.0}, {1.0, 2.0}}));
}

/// A ramp up and down in a 14/16 mm gap of a thin Herschel-Bulkley fluid, whose structure may break
/// down: all torques times 1 + share exp(-t/5 s).
struct UpAndDown {
    geometry::Instrument gap = geometry::ConcentricCylinders{0.014, 0.016, 0.042};
    flow::HerschelBulkley law{0.05, 0.02, 0.8};
    through::RunHistory run;
    std::vector<through::Measurement> measurements;
    fit::FlowData converted;
    std::vector<double> rates;
    std::vector<double> stresses;

    UpAndDown(double share, double noise) {
        const auto conversion = rheometry::conversion_for(gap, {});
        for (int k = 1; k <= 80; ++k) {
            run.rows.times.push_back(0.25 * k);
            run.rows.speeds.push_back(conversion.speed(k <= 40 ? 1.5 * k : 120.0 - 1.475 * k));
        }
        const auto inertia = through::ramp_inertia(gap, law, 1000.0, run.rows, 1e-5);
        std::mt19937_64 engine(2);
        std::normal_distribution<double> normal;
        through::Measurement measured{
            .instrument = gap, .end_factors = {1.0}, .speeds = {}, .torques = {}};
        std::vector<fit::MeasuredPoint> points;
        for (std::size_t k = 0; k < 80; ++k) {
            const double steady =
                searle::solvers::radial::steady_instrument_flow(gap, law, run.rows.speeds[k])
                    .torque;
            const double torque = (steady + inertia.torques[k]) *
                                  (1.0 + share * std::exp(-run.rows.times[k] / 5.0)) *
                                  (1.0 + noise * normal(engine));
            run.torques.push_back(torque);
            run.used.push_back(k);
            measured.speeds.push_back(run.rows.speeds[k]);
            measured.torques.push_back(torque);
            rates.push_back(conversion.shear_rate(run.rows.speeds[k]));
            stresses.push_back(conversion.shear_stress(torque));
            points.push_back({.rate = rates[k],
                              .stress = stresses[k],
                              .deviation = std::numeric_limits<double>::quiet_NaN(),
                              .line = 0,
                              .regime = {}});
        }
        measurements.push_back(std::move(measured));
        converted = fit::select_points(points, {});
    }

    through::InstrumentFit fitted() const {
        return through::fit_through(*fit::model_named("herschel-bulkley"), measurements, converted,
                                    {}, false, {.ends = true, .density = 1000.0, .history = {run}});
    }
    fit::RampLoop loop(const through::InstrumentFit& done) const {
        const auto conversion = rheometry::conversion_for(gap, {});
        std::vector<double> inertial;
        for (const double torque : done.inertia.front())
            inertial.push_back(conversion.shear_stress(torque));
        return fit::ramp_loop(rates, stresses, inertial).value();
    }
};

// The loop of a fluid without thixotropy is inertia, and once that is taken out the parameters are
// right; the conventional route reads inertia as yield stress.
TEST(FitRamp, inertia_is_told_from_the_law) {
    const UpAndDown ramp(0.0, 0.003);
    const auto done = ramp.fitted();
    const std::vector<double> truth{0.05, 0.02, 0.8};
    for (std::size_t i = 0; i < 3; ++i) {
        const fit::Estimate& estimate = done.result.estimates[i];
        EXPECT_NEAR(estimate.value, truth[i], 3.5 * estimate.standard_error) << i;
        EXPECT_LT(estimate.standard_error, 0.02 * truth[i]) << i;
    }
    const fit::Estimate& conventional = done.conventional->estimates[0];
    EXPECT_GT(conventional.value, truth[0] + 5.0 * done.result.estimates[0].standard_error);
    const fit::RampLoop loop = ramp.loop(done);
    EXPECT_GT(loop.inertial, 10.0 * loop.standard_error);
    EXPECT_LT(std::abs(loop.rest()), 3.5 * loop.standard_error);
}

// With a structure that breaks down, what inertia leaves of the loop is the structure's own: the
// area that the factor 1 + share exp(-t/5 s) opens, from the torques without it.
TEST(FitRamp, the_rest_of_the_loop_is_the_thixotropic_one) {
    const UpAndDown without(0.0, 0.0);
    const UpAndDown with(0.15, 0.0);
    const std::vector<double> none(80);
    const double expected = fit::ramp_loop(with.rates, with.stresses, none)->measured -
                            fit::ramp_loop(without.rates, without.stresses, none)->measured;
    const auto done = with.fitted();
    const fit::RampLoop loop = with.loop(done);
    EXPECT_GT(expected, 0.5);
    // The law is fitted to the mean of both ways, whose inertia differs a little from the truth's.
    EXPECT_NEAR(loop.rest(), expected, 0.02 * expected);
}

} // namespace
