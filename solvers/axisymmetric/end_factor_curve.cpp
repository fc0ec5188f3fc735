#include "solvers/axisymmetric/end_factor_curve.hpp"

#include "solvers/chebyshev_speeds.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace searle::solvers::axisymmetric {
namespace {

constexpr std::size_t most_direct = 9;
constexpr int first_degree = 4;
constexpr int last_degree = 64;
constexpr double share_after = 0.1; ///< of the work of one solution, once all took too much

bool is_homogeneous(const laws::flow::AnyFlowLaw& law) {
    return std::holds_alternative<laws::flow::Newtonian>(law) ||
           std::holds_alternative<laws::flow::PowerLaw>(law);
}

} // namespace

EndFactorCurve::EndFactorCurve(const SectionShape& shape, const laws::flow::AnyFlowLaw& law,
                               std::span<const double> speeds, double accuracy,
                               const ProgressSink& progress, double most_work_at_ease)
    : shape_(shape), law_(law), accuracy_(accuracy), most_work_at_ease_(most_work_at_ease),
      progress_(progress) {
    try {
        solve_all(speeds);
    } catch (const Interrupted&) {
        interrupted_ = true;
        reached_ = false;
        if (interpolates_) {
            // Points of a degree that was not finished are no use: the weights are for whole sets.
            keep_whole_degree();
        }
    }
}

void EndFactorCurve::solve_all(std::span<const double> speeds) {
    std::set<double> distinct;
    for (const double speed : speeds) {
        if (speed != 0.0) {
            distinct.insert(std::abs(speed));
        }
    }
    if (distinct.empty()) {
        return;
    }
    if (is_homogeneous(law_)) {
        solve(*distinct.rbegin());
        return;
    }
    if (distinct.size() <= most_direct) {
        for (const double speed : distinct) {
            solve(speed);
        }
        return;
    }
    interpolates_ = true;
    const double low = std::log(*distinct.begin());
    const double high = std::log(*distinct.rbegin());
    const auto point = [&](int k, int degree) { return chebyshev_speed(low, high, k, degree); };
    degree_ = first_degree;
    for (int k = 0; k <= first_degree; ++k) {
        solve(point(k, first_degree));
    }
    whole_degree_ = first_degree;
    for (int degree = 2 * first_degree; degree <= last_degree; degree *= 2) {
        degree_ = degree;
        std::vector<double> foreseen;
        for (int k = 1; k < degree; k += 2) {
            foreseen.push_back(interpolated(point(k, degree)));
        }
        double difference = 0.0;
        for (int k = 1; k < degree; k += 2) {
            const double speed = point(k, degree);
            solve(speed);
            const auto same = std::find_if(solved_.begin(), solved_.end(),
                                           [&](const Solved& each) { return each.speed == speed; });
            difference = std::max(
                difference,
                std::abs(foreseen[static_cast<std::size_t>(k / 2)] / same->value.end_factor - 1.0));
        }
        interpolation_error_ = difference;
        whole_degree_ = degree;
        if (interpolation_error_ <= 0.3 * accuracy_) {
            return;
        }
        if (work_ > most_work_at_ease_) {
            break;
        }
    }
    reached_ = false;
}

void EndFactorCurve::keep_whole_degree() {
    std::erase_if(solved_, [&](const Solved& each) { return each.degree > whole_degree_; });
    if (whole_degree_ <= first_degree) {
        // No second degree has told how far the first may be off.
        solved_.clear();
    }
}

void EndFactorCurve::solve(double speed) {
    CreepingSettings settings{.accuracy = (interpolates_ ? 0.5 : 1.0) * accuracy_};
    if (work_ > most_work_at_ease_) {
        settings.most_work *= share_after;
    }
    const CreepingTorque found = creeping_torque(shape_, law_, speed, settings, progress_);
    work_ += found.work;
    const Solved solved{speed,
                        degree_,
                        {.end_factor = found.end_factor,
                         .relative_error = found.error / found.torque,
                         .lower = found.lower / found.torque * found.end_factor,
                         .upper = found.upper / found.torque * found.end_factor}};
    solved_.insert(
        std::upper_bound(solved_.begin(), solved_.end(), speed,
                         [](double value, const Solved& each) { return value < each.speed; }),
        solved);
    elements_ = std::max(elements_, found.elements);
    levels_ = std::max(levels_, found.levels);
    newton_steps_ += found.newton_steps;
    if (found.unknowns > unknowns_) {
        unknowns_ = found.unknowns;
        division_ = found.division;
    }
    reached_ = reached_ && found.reached;
}

double EndFactorCurve::interpolated(double speed) const {
    return interpolated_in_log(
        solved_, speed, [](const auto& each) { return each.speed; },
        [](const auto& each) { return each.value.end_factor; });
}

bool EndFactorCurve::has(double speed) const {
    if (solved_.empty()) {
        return false;
    }
    return is_homogeneous(law_) || interpolates_ ||
           std::any_of(solved_.begin(), solved_.end(),
                       [&](const Solved& each) { return each.speed == std::abs(speed); });
}

EndFactorCurve::Value EndFactorCurve::at(double speed) const {
    const double magnitude = std::abs(speed);
    if (is_homogeneous(law_)) {
        return solved_.front().value;
    }
    const auto near = std::min_element(solved_.begin(), solved_.end(),
                                       [&](const Solved& one, const Solved& other) {
                                           return std::abs(std::log(one.speed / magnitude)) <
                                                  std::abs(std::log(other.speed / magnitude));
                                       });
    if (!interpolates_) {
        return near->value;
    }
    double worst = 0.0;
    for (const Solved& each : solved_) {
        worst = std::max(worst, each.value.relative_error);
    }
    const bool solved_here = std::abs(near->speed / magnitude - 1.0) < 1e-9;
    return {.end_factor = interpolated(magnitude),
            .relative_error = worst + interpolation_error_,
            .lower = solved_here ? near->value.lower : 0.0,
            .upper = solved_here ? near->value.upper : 0.0};
}

} // namespace searle::solvers::axisymmetric
