// A Herschel-Bulkley fluid in a DIN bob with its ends and a plug, measured with scatter many times
// over: is the fit through the instrument unbiased, and what does the conventional route give?
//   bench_fit_through_bob [DATA_SETS] [SEED]
// The torques are those of solutions five times as accurate as the fit's own, at speeds that are no
// points of its curve of c_L; 1 % of normal scatter, weights "fitted".

#include "rheometry/conversion/conversion.hpp"
#include "rheometry/fit/prediction.hpp"
#include "solvers/axisymmetric/creeping_swirl.hpp"
#include "solvers/fit_instrument/fit_instrument.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <random>
#include <vector>

namespace {

namespace fit = searle::rheometry::fit;
namespace through = searle::solvers::fit_instrument;

constexpr double noise = 0.01;
const searle::geometry::DinBob bob{.bob_radius = 0.014, .cup_radius = 0.0152};

struct Tally {
    double bias = 0.0; ///< mean of (value - truth) / standard error
    double mean = 0.0;
    int held = 0;
    double conventional = 0.0;
    int conventional_held = 0;
};

double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

void examine(const std::vector<double>& truth, int sets, unsigned long seed) {
    const fit::Model& law = *fit::model_named("herschel-bulkley");
    const searle::laws::flow::AnyFlowLaw fluid =
        searle::laws::flow::HerschelBulkley{truth[0], truth[1], truth[2]};
    const auto conversion = searle::rheometry::conversion_for(bob, {});
    const std::vector<double> speeds = fit::spread_rates(0.013, 37.0, 25);
    std::vector<double> exact;
    double worst = 0.0;
    for (const double speed : speeds) {
        const auto found =
            searle::solvers::axisymmetric::creeping_torque(bob, fluid, speed, {.accuracy = 2e-4});
        exact.push_back(found.torque);
        worst = std::max(worst, found.error / found.torque);
    }
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal;
    fit::FitOptions options;
    options.weighting = fit::Weighting::fitted;
    std::vector<Tally> tallies(truth.size());
    std::vector<double> cpu;
    std::vector<double> wall;
    for (int set = 0; set < sets; ++set) {
        through::Measurement measured{
            .instrument = bob, .end_factors = {1.1}, .speeds = speeds, .torques = {}};
        std::vector<fit::MeasuredPoint> points;
        for (std::size_t k = 0; k < speeds.size(); ++k) {
            measured.torques.push_back(exact[k] * (1.0 + noise * normal(engine)));
            points.push_back({.rate = conversion.shear_rate(speeds[k]),
                              .stress = conversion.shear_stress(measured.torques[k]),
                              .deviation = std::numeric_limits<double>::quiet_NaN(),
                              .line = 0,
                              .regime = {}});
        }
        const std::clock_t start = std::clock();
        const double wall_start = wall_seconds();
        const auto done = through::fit_through(law, {measured}, fit::select_points(points, {}),
                                               options, false, {.ends = true, .density = 1000.0});
        cpu.push_back(double(std::clock() - start) / CLOCKS_PER_SEC);
        wall.push_back(wall_seconds() - wall_start);
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const fit::Estimate& own = done.result.estimates[i];
            const fit::Estimate& other = done.conventional->estimates[i];
            tallies[i].bias += (own.value - truth[i]) / own.standard_error / sets;
            tallies[i].mean += own.value / truth[i] / sets;
            tallies[i].held += truth[i] >= own.low && truth[i] <= own.high;
            tallies[i].conventional += other.value / truth[i] / sets;
            tallies[i].conventional_held += truth[i] >= other.low && truth[i] <= other.high;
        }
    }
    std::ranges::sort(cpu);
    std::ranges::sort(wall);
    fmt::print(
        "yield stress {} Pa, consistency {} Pa s^n, index {}: {} data sets, torques exact to "
        "{:.0e}\n",
        truth[0], truth[1], truth[2], sets, worst);
    fmt::print("{:13} {:>10} {:>24} {:>9} {:>14} {:>9}\n", "", "mean/truth",
               "bias, standard errors", "intervals", "conventional", "intervals");
    for (std::size_t i = 0; i < truth.size(); ++i)
        fmt::print("{:13} {:>10.4f} {:>15.2f} +- {:.2f} {:>11.1f} % {:>12.4f} {:>9.1f} %\n",
                   law.parameters[i].key, tallies[i].mean, tallies[i].bias, 1.0 / std::sqrt(sets),
                   100.0 * tallies[i].held / sets, tallies[i].conventional,
                   100.0 * tallies[i].conventional_held / sets);
    fmt::print("per fit: processor {:.2f} s median, {:.2f} s longest; wall {:.2f} s median, {:.2f} "
               "s longest\n\n",
               cpu[cpu.size() / 2], cpu.back(), wall[wall.size() / 2], wall.back());
}

} // namespace

int main(int count, char** words) {
    const int sets = count > 1 ? std::atoi(words[1]) : 100;
    const unsigned long seed = count > 2 ? std::strtoul(words[2], nullptr, 10) : 20240601UL;
    examine({5.0, 0.5, 0.5}, sets, seed);
    examine({2.0, 1.0, 0.7}, sets, seed + 1);
}
