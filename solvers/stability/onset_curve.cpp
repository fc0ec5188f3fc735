#include "solvers/stability/onset_curve.hpp"

#include "solvers/chebyshev_speeds.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace searle::solvers::stability {
namespace {

/// Stands for "no density": far beyond any fluid, and its logarithm is still a number.
constexpr double out_of_reach = 1e30;
constexpr int most_intervals = 16;
/// Of the logarithm of a critical speed.
constexpr double search_tolerance = 1e-6;

double interpolated(const auto& points, double speed) {
    return interpolated_in_log(
        points, speed, [](const auto& point) { return point.speed; },
        [](const auto& point) { return point.reynolds; });
}

} // namespace

OnsetCurve::OnsetCurve(const radial::AnnularGap& gap, laws::flow::AnyFlowLaw law, double slowest,
                       double fastest, double tolerance)
    : gap_(gap), law_(std::move(law)), tolerance_(tolerance) {
    if (!(fastest > slowest * (1.0 + 1e-9))) {
        points_.push_back({fastest, solve(fastest)});
        return;
    }
    const double low = std::log(slowest);
    const double high = std::log(fastest);
    int intervals = 2;
    for (int k = 0; k <= intervals; ++k) {
        const double speed = chebyshev_speed(low, high, k, intervals);
        points_.push_back({speed, solve(speed)});
    }
    for (double missed = 2.0 * tolerance_; missed > tolerance_ && intervals < most_intervals;) {
        intervals *= 2;
        missed = 0.0;
        std::vector<Point> finer;
        for (int k = 0; k <= intervals; ++k) {
            if (k % 2 == 0) {
                finer.push_back(points_[static_cast<std::size_t>(k / 2)]);
                continue;
            }
            const double speed = chebyshev_speed(low, high, k, intervals);
            finer.push_back({speed, solve(speed)});
            missed = std::max(missed,
                              std::abs(interpolated(points_, speed) / finer.back().reynolds - 1.0));
        }
        points_ = std::move(finer);
        if (missed <= tolerance_ || intervals == most_intervals) {
            relative_error_ = std::max(relative_error_, missed);
        }
    }
}

double OnsetCurve::solve(double speed) {
    const LayerOnset onset = layer_onset(gap_, law_, speed, tolerance_);
    ++solved_;
    if (!(onset.reynolds < out_of_reach)) {
        return out_of_reach;
    }
    relative_error_ = std::max(relative_error_, onset.relative_error);
    return onset.reynolds;
}

double OnsetCurve::critical_reynolds(double speed) const {
    const double inside = std::clamp(speed, points_.front().speed, points_.back().speed);
    return interpolated(points_, inside);
}

std::optional<CriticalSpeed> critical_speed(const radial::AnnularGap& gap,
                                            const laws::flow::AnyFlowLaw& law, double density,
                                            double guess, double tolerance) {
    // ln(density / critical density) at exp(x) times the guess.
    const auto excess = [&](double x) {
        const double critical =
            layer_onset(gap, law, guess * std::exp(x), tolerance).critical_density;
        return std::log(density / std::min(critical, density * out_of_reach));
    };
    constexpr double furthest = 6.9;
    double here = 0.0;
    double at_here = excess(here);
    // Away from the guess, on the side where the onset lies for a fluid whose inertia gains on its
    // viscosity, until the sign changes; strides by the slope of a Newtonian fluid.
    const double direction = at_here > 0.0 ? -1.0 : 1.0;
    double there = here;
    double at_there = at_here;
    while (at_here != 0.0 && at_there * at_here > 0.0) {
        if (std::abs(there) >= furthest) {
            return std::nullopt;
        }
        here = there;
        at_here = at_there;
        const double stride = std::clamp(1.2 * std::abs(at_there), 1e-3, 2.0);
        there = std::clamp(here + direction * stride, -furthest, furthest);
        at_there = excess(there);
    }
    double root = here;
    if (at_here != 0.0) {
        std::uintmax_t evaluations = 20;
        const bool rises = there > here;
        const auto [low, high] = boost::math::tools::toms748_solve(
            excess, rises ? here : there, rises ? there : here, rises ? at_here : at_there,
            rises ? at_there : at_here,
            [](double a, double b) { return std::abs(b - a) < search_tolerance; }, evaluations);
        root = 0.5 * (low + high);
    }
    const double speed = guess * std::exp(root);
    const LayerOnset onset = layer_onset(gap, law, speed, tolerance);
    // An error of the critical density moves the speed by its share of how density over critical
    // density gains on the speed: as speed^(2 - n) for a power law.
    constexpr double aside = 0.05;
    const double gain = std::abs(excess(root + aside) - excess(root)) / aside;
    return CriticalSpeed{.speed = speed,
                         .relative_error = onset.relative_error / gain + search_tolerance,
                         .onset = onset};
}

} // namespace searle::solvers::stability
