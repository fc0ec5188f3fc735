// Steady gap flow: random scenes of every law against a 50-digit evaluation, and the time per
// point. Usage: bench_radial_steady [scenes per law = 1500] [seed = 1]

#include "solvers/radial/annular_gap.hpp"
#include "verification/precise_gap_speed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

using namespace searle;
using laws::flow::AnyFlowLaw;
using solvers::radial::AnnularGap;

namespace {

class Draw {
public:
    explicit Draw(unsigned long seed) : engine_(seed) {}
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    double log_uniform(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    bool one_in(int n) { return uniform(0.0, 1.0) * n < 1.0; }

private:
    std::mt19937_64 engine_;
};

struct SteadyScene {
    AnyFlowLaw law;
    AnnularGap gap;
    double omega;
};

constexpr int law_count = 7;

SteadyScene draw_scene(int law, Draw& draw) {
    const double bob = draw.log_uniform(1e-3, 0.1);
    const double delta = 1.0 + draw.log_uniform(1e-3, 19.0);
    const double omega = draw.log_uniform(1e-9, 1e4);
    const double n = draw.uniform(0.1, 2.0);
    const double consistency = draw.log_uniform(1e-4, 1e3);
    const double bingham = draw.one_in(10) ? 0.0 : draw.log_uniform(1e-6, 1e6);
    const double yield_n = bingham * consistency * std::pow(omega, n);
    const double yield_1 = bingham * consistency * omega;
    const double infinite = draw.one_in(3) ? 0.0 : consistency * draw.log_uniform(1e-6, 1.0);
    const double time = draw.log_uniform(1e-3, 1e3) / omega;
    const double thinning = draw.uniform(0.1, 0.999);
    const AnyFlowLaw laws[law_count] = {
        laws::flow::Newtonian{consistency},
        laws::flow::Bingham{yield_1, consistency},
        laws::flow::PowerLaw{consistency, n},
        laws::flow::HerschelBulkley{yield_n, consistency, n},
        laws::flow::Casson{yield_1, consistency},
        laws::flow::CarreauYasuda{consistency, infinite, time, thinning, draw.uniform(0.3, 6.0)},
        laws::flow::Cross{consistency, infinite, time, thinning}};
    return {laws[law], {bob, bob * delta}, omega};
}

} // namespace

int main(int argc, char** argv) {
    const int scenes = argc > 1 ? std::atoi(argv[1]) : 1500;
    const unsigned long seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
    fmt::print("Steady torque against a 50-digit evaluation: n 0.1 to 2, Bingham number 0 to 1e6,\n"
               "radius ratio 1.001 to 20, speed 1e-9 to 1e4 rad/s, {} scenes per law, seed {}.\n"
               "Target: relative error <= 1e-10, <= 20 us a point.\n\n"
               "{:18s} {:>8s} {:>10s} {:>10s} {:>9s} {:>12s} {:>12s}\n",
               scenes, seed, "law", "scenes", "largest", "median", "failures", "us median",
               "us p99");
    bool good = true;
    for (int law = 0; law < law_count; ++law) {
        Draw draw(seed + static_cast<unsigned long>(law));
        std::vector<double> errors;
        std::vector<double> micros;
        int failures = 0;
        std::string name;
        for (int k = 0; k < scenes; ++k) {
            const SteadyScene scene = draw_scene(law, draw);
            name = laws::flow::name_of(scene.law);
            const auto begin = std::chrono::steady_clock::now();
            const auto flow = solvers::radial::steady_gap_flow(scene.gap, scene.law, scene.omega);
            const std::chrono::duration<double, std::micro> took =
                std::chrono::steady_clock::now() - begin;
            micros.push_back(took.count());
            const double error = std::abs(
                verification::steady_stress_error(scene.law, scene.gap.ratio_squared_minus_one(),
                                                  scene.omega, flow.inner_wall_stress));
            errors.push_back(error);
            failures += !(error <= 1e-10);
        }
        std::sort(errors.begin(), errors.end());
        std::sort(micros.begin(), micros.end());
        fmt::print("{:18s} {:8d} {:10.1e} {:10.1e} {:9d} {:12.2f} {:12.2f}\n", name, scenes,
                   errors.back(), errors[errors.size() / 2], failures, micros[micros.size() / 2],
                   micros[micros.size() * 99 / 100]);
        good = good && failures == 0;
    }
    return good ? 0 : 1;
}
