#include "solvers/meridional/inertia_factor_curve.hpp"

#include "solvers/chebyshev_speeds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

namespace searle::solvers::meridional {
namespace {

constexpr int first_degree = 4;
constexpr int last_degree = 32;
/// Of the accuracy: what each solution and what interpolation may miss where there is any.
constexpr double solution_share = 0.5;
constexpr double interpolation_share = 0.3;
/// Work after which further speeds get a tenth of what one may take.
constexpr double most_work_at_ease = 2.0 * SteadySecondaryFlow::most_work;
constexpr double share_after = 0.1;

/// The asked accuracy, or what the levels there are come to at best: asking them for more costs
/// time and brings nothing.
double attainable(double accuracy, const laws::flow::AnyFlowLaw& law) {
    if (laws::flow::yield_stress(law) > 0.0) {
        return std::max(accuracy, 1e-5); // the rounding of the yield surface
    }
    return std::max(accuracy, std::holds_alternative<laws::flow::Newtonian>(law) ? 1e-8 : 1e-6);
}

std::set<double> magnitudes(std::span<const double> speeds) {
    std::set<double> distinct;
    for (const double speed : speeds) {
        if (speed != 0.0) {
            distinct.insert(std::abs(speed));
        }
    }
    return distinct;
}

} // namespace

InertiaFactorCurve::InertiaFactorCurve(const geometry::DinBob& bob,
                                       const laws::flow::AnyFlowLaw& law, double density,
                                       std::span<const double> speeds, double accuracy,
                                       const ProgressSink& progress, std::size_t most_direct)
    : distinct_(magnitudes(speeds)), interpolates_(distinct_.size() > most_direct),
      accuracy_(attainable(accuracy, law)),
      flow_(bob, law, density, (interpolates_ ? solution_share : 1.0) * accuracy_) {
    try {
        solve_all(progress);
    } catch (const Interrupted&) {
        interrupted_ = true;
    }
}

void InertiaFactorCurve::solve_all(const ProgressSink& progress) {
    if (!interpolates_) {
        for (const double speed : distinct_) {
            solve(speed, progress);
        }
        return;
    }
    const double low = std::log(*distinct_.begin());
    const double high = std::log(*distinct_.rbegin());
    const auto point = [&](int k, int degree) { return chebyshev_speed(low, high, k, degree); };
    for (int k = 0; k <= first_degree; ++k) {
        solve(point(k, first_degree), progress);
    }
    for (int degree = 2 * first_degree; degree <= last_degree; degree *= 2) {
        std::vector<std::pair<double, double>> foreseen;
        for (int k = 1; k < degree; k += 2) {
            foreseen.emplace_back(point(k, degree), interpolated(point(k, degree)));
        }
        interpolation_error_ = 0.0;
        for (const auto& [speed, factor] : foreseen) {
            solve(speed, progress);
            interpolation_error_ =
                std::max(interpolation_error_, std::abs(factor / solved_.at(speed).factor - 1.0));
        }
        if (flow_.work() > most_work_at_ease) {
            break;
        }
        // Where a flow was not found no number of points makes the curve smooth.
        double worst = accuracy_;
        for (const auto& [speed, found] : solved_) {
            worst = std::max(worst, found.relative_error);
        }
        if (interpolation_error_ <= interpolation_share * worst) {
            break;
        }
    }
}

InertiaFactor InertiaFactorCurve::solve_within_bounds(double speed, const ProgressSink& progress) {
    const double share = flow_.work() > most_work_at_ease ? share_after : 1.0;
    return flow_.at(speed, progress, share * SteadySecondaryFlow::most_work);
}

FlowLevel* InertiaFactorCurve::flow_at(double speed, const ProgressSink& progress) {
    return solve_within_bounds(speed, progress).levels > 0 ? flow_.finest() : nullptr;
}

void InertiaFactorCurve::solve(double speed, const ProgressSink& progress) {
    const InertiaFactor found = solve_within_bounds(speed, progress);
    levels_ = std::max(levels_, found.levels);
    unknowns_ = std::max(unknowns_, found.unknowns);
    solved_[speed] = found;
}

std::optional<std::complex<double>>
InertiaFactorCurve::disturbance_rate(double speed, const ProgressSink& progress) {
    if (flow_at(speed, progress) == nullptr) {
        return {};
    }
    const LeadingDisturbance leading = flow_.leading_disturbance_at(speed, progress);
    if (!std::isfinite(leading.rate.real())) {
        return {};
    }
    return leading.rate * speed;
}

axisymmetric::SectionDivision InertiaFactorCurve::division() {
    const FlowLevel* const finest = flow_.finest();
    return finest == nullptr
               ? axisymmetric::SectionDivision{}
               : axisymmetric::SectionDivision{finest->lines(), finest->space().degree()};
}

double InertiaFactorCurve::interpolated(double speed) const {
    return interpolated_in_log(
        solved_, speed, [](const auto& each) { return each.first; },
        [](const auto& each) { return each.second.factor; });
}

InertiaFactor InertiaFactorCurve::at(double speed) const {
    const double magnitude = std::abs(speed);
    if (!interpolates_) {
        return solved_.at(magnitude);
    }
    // The two solutions around the speed tell how accurate it is there.
    const auto after = solved_.lower_bound(magnitude);
    InertiaFactor result = after == solved_.end() ? std::prev(after)->second : after->second;
    if (after != solved_.begin() && after != solved_.end()) {
        const InertiaFactor& before = std::prev(after)->second;
        result.relative_error = std::max(result.relative_error, before.relative_error);
    }
    result.factor = interpolated(magnitude);
    result.relative_error += interpolation_error_;
    result.reached = result.relative_error <= accuracy_;
    return result;
}

} // namespace searle::solvers::meridional
