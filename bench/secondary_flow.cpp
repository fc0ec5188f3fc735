// Secondary flow of water around the ISO bob: error, estimate and CPU time of the steady torque, of
// the curve of end factors and of a ramp. `bench_secondary_flow [steady] [curve] [ramp]`, all
// without arguments.
#include "solvers/axisymmetric/creeping_swirl.hpp"
#include "solvers/meridional/inertia_factor_curve.hpp"
#include "solvers/meridional/transient_secondary_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string_view>
#include <vector>

namespace {

using namespace searle;
namespace meridional = solvers::meridional;

constexpr double density = 998.2;
constexpr double viscosity = 1.0034e-6 * density;
const geometry::DinBob iso_bob{.bob_radius = 0.014, .cup_radius = 0.014 * 1.0847};
/// ISO 3219: representative shear rate over speed.
constexpr double rate_per_speed = (1.0847 * 1.0847 + 1.0) / (1.0847 * 1.0847 - 1.0);

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// M_inf: an endless bob of the same length, creeping: stress 2 eta omega delta^2 / (delta^2 - 1).
double creeping_end_factor() {
    return solvers::axisymmetric::creeping_torque(iso_bob, laws::flow::Newtonian{viscosity}, 1.0,
                                                  {.accuracy = 1e-7, .certified = false})
        .end_factor;
}

void steady(double end_factor) {
    for (const double speed : {0.7504, 7.504}) {
        meridional::SteadySecondaryFlow finest(iso_bob, laws::flow::Newtonian{viscosity}, density,
                                               2e-7);
        const double best = finest.at(speed).factor;
        fmt::print("\nomega {} rad/s, Re {:.0f}, finest M/M_inf {:.7f} = {:.7f} x {:.7f}\n", speed,
                   speed * iso_bob.bob_radius * iso_bob.bob_radius * density / viscosity,
                   best * end_factor, end_factor, best);
        for (const double accuracy : {1e-2, 1e-3, 1e-4, 1e-5}) {
            const double start = cpu_seconds();
            meridional::SteadySecondaryFlow flow(iso_bob, laws::flow::Newtonian{viscosity}, density,
                                                 accuracy);
            const auto found = flow.at(speed);
            fmt::print("asked {:.0e}: M/M_inf {:.7f}, estimate {:.1e}, true {:.1e}, {:.2f} s, {} "
                       "unknowns, {} factorisations{}\n",
                       accuracy, found.factor * end_factor, found.relative_error,
                       std::abs(found.factor / best - 1.0), cpu_seconds() - start, found.unknowns,
                       flow.factorisations(), found.reached ? "" : ", not reached");
            std::fflush(stdout);
        }
    }
}

void curve(double end_factor) {
    std::vector<double> speeds;
    for (int k = 0; k <= 30; ++k) {
        speeds.push_back(0.1 * std::pow(10.0, k / 10.0) / rate_per_speed);
    }
    const double start = cpu_seconds();
    const meridional::InertiaFactorCurve found(iso_bob, laws::flow::Newtonian{viscosity}, density,
                                               speeds, 1e-3, {});
    fmt::print("\nc_L from 0.1 to 100 1/s at 1e-3: {:.2f} s, {} solutions\n", cpu_seconds() - start,
               found.solutions());
    for (std::size_t k = 0; k < speeds.size(); k += 3) {
        const auto at = found.at(speeds[k]);
        fmt::print("{:9.4f} 1/s: c_L {:.5f} +- {:.0e}\n", speeds[k] * rate_per_speed,
                   at.factor * end_factor, at.relative_error);
    }
    std::fflush(stdout);
}

void ramp() {
    rheometry::SpeedHistory history;
    history.pieces = {{0.0, 35.0, 0.0, 100.0 / rate_per_speed}};
    for (int k = 1; k <= 100; ++k) {
        history.row_times.push_back(0.35 * k);
    }
    std::vector<meridional::TransientTorque> found;
    std::vector<double> seconds;
    const std::vector<double> accuracies{1e-2, 1e-3, 1e-4};
    for (const double accuracy : accuracies) {
        const double start = cpu_seconds();
        found.push_back(meridional::transient_secondary_flow(
            iso_bob, laws::flow::Newtonian{viscosity}, density, history, accuracy));
        seconds.push_back(cpu_seconds() - start);
        fmt::print("\nramp 0 -> 100 1/s in 35 s at {:.0e}: {:.1f} s, claimed {:.1e}, {} levels, {} "
                   "unknowns, {} steps on the last{}\n",
                   accuracy, seconds.back(), found.back().worst_relative_error, found.back().levels,
                   found.back().unknowns, found.back().time_steps,
                   found.back().reached ? "" : ", not reached");
        std::fflush(stdout);
    }
    for (std::size_t k = 0; k + 1 < found.size(); ++k) {
        double worst = 0.0;
        for (std::size_t row = 0; row < found[k].torque.size(); ++row) {
            worst =
                std::max(worst, std::abs(found[k].torque[row] / found.back().torque[row] - 1.0));
        }
        fmt::print("at {:.0e}: off the one at {:.0e} by {:.1e}\n", accuracies[k], accuracies.back(),
                   worst);
    }
}

} // namespace

int main(int count, char** word) {
    const auto wants = [&](std::string_view what) {
        return count == 1 || std::find(word + 1, word + count, what) != word + count;
    };
    const double end_factor = creeping_end_factor();
    if (wants("steady")) {
        steady(end_factor);
    }
    if (wants("curve")) {
        curve(end_factor);
    }
    if (wants("ramp")) {
        ramp();
    }
}
