// True errors of the secondary flow's torque against the errors that it claims, over scenes of all
// kinds. `bench_secondary_flow_errors steady [first] [last]` or `... transient [first] [last]`.
#include "solvers/meridional/steady_secondary_flow.hpp"
#include "solvers/meridional/transient_secondary_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace searle;
namespace flow = laws::flow;

struct Chance {
    std::mt19937 generator{20240607};
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(generator);
    }
    double over_decades(double low, double high) {
        return std::exp(between(std::log(low), std::log(high)));
    }
};

geometry::DinBob any_bob(Chance& chance) {
    const double radius = chance.between(5e-3, 2e-2);
    const double ratio = 1.0 + chance.over_decades(0.02, 1.0);
    return {.bob_radius = radius,
            .cup_radius = radius * ratio,
            .length_ratio = chance.between(1.5, 4.0),
            .bottom_ratio = chance.between(0.7, 2.0),
            .top_ratio = chance.between(0.3, 2.0),
            .shaft_ratio = chance.between(0.1, 0.6)};
}

/// A law whose viscosity at 50 1/s is about `viscosity`.
flow::AnyFlowLaw any_law(Chance& chance, int kind, double viscosity) {
    const double n = chance.between(0.4, 1.2);
    switch (kind % 4) {
    case 0:
        return flow::Newtonian{viscosity};
    case 1:
        return flow::PowerLaw{viscosity * std::pow(50.0, 1.0 - n), n};
    case 2:
        return flow::CarreauYasuda{2.0 * viscosity, 0.3 * viscosity, 0.05, 0.5, 2.0};
    default:
        return flow::HerschelBulkley{viscosity * chance.over_decades(1.0, 50.0), viscosity, 0.8};
    }
}

struct Scene {
    geometry::DinBob bob;
    flow::AnyFlowLaw law;
    double density;
    double speed;
};

/// Speeds up to 90 % of where a gap without ends gets Taylor vortices (narrow gap: Re^2 d/R =
/// 1695), where the steady flow is no longer the only one.
Scene any_scene(Chance& chance, int kind, double fastest_share) {
    Scene scene{any_bob(chance), flow::Newtonian{1.0}, chance.between(800.0, 1200.0), 0.0};
    const double viscosity = chance.over_decades(8e-4, 1e-2);
    scene.law = any_law(chance, kind, viscosity);
    const double gap = scene.bob.gap();
    const double onset = std::sqrt(1695.0 * scene.bob.bob_radius / gap) * viscosity /
                         (scene.density * scene.bob.bob_radius * gap);
    scene.speed = onset * chance.over_decades(0.03 * fastest_share, fastest_share);
    return scene;
}

std::string text_of(const Scene& scene) {
    return fmt::format("{:16} delta {:.3f} L {:.2f} bottom {:.2f} top {:.2f} shaft {:.2f} speed "
                       "{:8.4f} rad/s",
                       flow::name_of(scene.law), scene.bob.radius_ratio(), scene.bob.length_ratio,
                       scene.bob.bottom_ratio, scene.bob.top_ratio, scene.bob.shaft_ratio,
                       scene.speed);
}

struct Tally {
    int rows = 0;
    int outside = 0;
    double worst = 0.0;
    void add(double error, double claimed) {
        ++rows;
        outside += error > claimed ? 1 : 0;
        worst = std::max(worst, error / std::max(claimed, 1e-300));
    }
};

void steady(int first, int last) {
    Chance chance;
    Tally tally;
    for (int k = 0; k <= last; ++k) {
        const Scene scene = any_scene(chance, k, 0.9);
        if (k < first) {
            continue;
        }
        solvers::meridional::SteadySecondaryFlow fine(scene.bob, scene.law, scene.density, 1e-4);
        const auto best = fine.at(scene.speed);
        fmt::print("{:3} {} factor {:.6f} +- {:.0e} ({} levels)", k, text_of(scene), best.factor,
                   best.relative_error, best.levels);
        for (const double accuracy : {1e-2, 1e-3}) {
            solvers::meridional::SteadySecondaryFlow coarse(scene.bob, scene.law, scene.density,
                                                            accuracy);
            const auto found = coarse.at(scene.speed);
            const double error = std::abs(found.factor / best.factor - 1.0);
            tally.add(error, found.relative_error + best.relative_error);
            fmt::print(" | {:.0e}: {:.1e} of {:.1e}{}{}", accuracy, error, found.relative_error,
                       found.reached ? "" : " not reached",
                       error > found.relative_error + best.relative_error ? " OUTSIDE" : "");
        }
        fmt::print("\n");
        std::fflush(stdout);
    }
    fmt::print("{} of {} outside, worst error {:.2f} of the claimed one\n", tally.outside,
               tally.rows, tally.worst);
}

/// Ramps, up and down, jumps, a start from a speed that is not zero.
rheometry::SpeedHistory any_history(Chance& chance, int kind, double speed, double own_time) {
    const double end = own_time * chance.over_decades(0.5, 5.0);
    rheometry::SpeedHistory history;
    switch (kind % 5) {
    case 0:
        history.pieces = {{0.0, end, 0.0, speed}};
        break;
    case 1:
        history.pieces = {{0.0, 0.5 * end, 0.0, speed}, {0.5 * end, end, speed, 0.0}};
        break;
    case 2:
        history.pieces = {{0.0, 0.5 * end, speed, speed},
                          {0.5 * end, end, 0.3 * speed, 0.3 * speed}};
        break;
    case 3:
        history.initial_speed = speed;
        history.pieces = {{0.0, end, speed, 0.2 * speed}};
        break;
    default:
        history.initial_speed = 0.5 * speed;
        history.pieces = {{0.0, 0.4 * end, speed, 0.6 * speed},
                          {0.4 * end, end, 0.2 * speed, speed}};
        break;
    }
    for (int k = 1; k <= 20; ++k) {
        history.row_times.push_back(end * k / 20.0);
    }
    history.row_times.back() = history.duration();
    return history;
}

void transient(int first, int last) {
    Chance chance;
    Tally tally;
    for (int k = 0; k <= last; ++k) {
        // No yield stress in time.
        const Scene scene = any_scene(chance, k % 3, 0.7);
        const double viscosity = flow::stress(scene.law, 50.0) / 50.0;
        const double own_time = scene.bob.gap() * scene.bob.gap() * scene.density / viscosity;
        const auto history = any_history(chance, k, scene.speed, own_time);
        if (k < first) {
            continue;
        }
        const auto best = solvers::meridional::transient_secondary_flow(
            scene.bob, scene.law, scene.density, history, 5e-4);
        fmt::print("{:3} history {} {} ({} levels, {} s)", k, k % 5, text_of(scene), best.levels,
                   history.duration());
        for (const double accuracy : {1e-2, 3e-3}) {
            const auto found = solvers::meridional::transient_secondary_flow(
                scene.bob, scene.law, scene.density, history, accuracy);
            int outside = 0;
            double worst = 0.0;
            double largest = 0.0;
            for (const double each : best.torque) {
                largest = std::max(largest, std::abs(each));
            }
            for (std::size_t row = 0; row < std::min(found.torque.size(), best.torque.size());
                 ++row) {
                const double error = std::abs(found.torque[row] - best.torque[row]);
                const double claimed = found.error[row] + best.error[row];
                tally.add(error, claimed);
                outside += error > claimed ? 1 : 0;
                worst =
                    std::max(worst, error / std::max(std::abs(best.torque[row]), 1e-3 * largest));
            }
            fmt::print(" | {:.0e}: {:.1e} of {:.1e}, {} levels{}{}", accuracy, worst,
                       found.worst_relative_error, found.levels,
                       found.reached ? "" : " not reached",
                       outside > 0 ? fmt::format(" {} OUTSIDE", outside) : "");
        }
        fmt::print("\n");
        std::fflush(stdout);
    }
    fmt::print("{} of {} rows outside, worst error {:.2f} of the claimed one\n", tally.outside,
               tally.rows, tally.worst);
}

} // namespace

int main(int count, char** word) {
    const std::string_view what = count > 1 ? word[1] : "steady";
    const int first = count > 2 ? std::stoi(word[2]) : 0;
    if (what == "transient") {
        transient(first, count > 3 ? std::stoi(word[3]) : 9);
    } else {
        steady(first, count > 3 ? std::stoi(word[3]) : 39);
    }
}
