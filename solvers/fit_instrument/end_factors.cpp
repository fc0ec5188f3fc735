#include "solvers/fit_instrument/end_factors.hpp"

#include "solvers/axisymmetric/creeping_swirl.hpp"
#include "solvers/fit_instrument/chebyshev_curve.hpp"
#include "solvers/fit_instrument/side_by_side.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace searle::solvers::fit_instrument {
namespace {

using rheometry::fit::Model;
using rheometry::fit::Parameter;
using rheometry::fit::Transform;

constexpr int first_degree = 3;
constexpr int last_degree = 24;
/// Twice the points lower the error by this at least: seen were 5 (Bingham, 4 decades) to 60.
constexpr double gain_of_doubling = 4.0;
/// Moves for differences: of logarithms and pure numbers; of a stress, over the lowest stress.
constexpr double move = 0.08;
constexpr double stress_move = 0.1;
/// A range of speeds narrower than this is widened to it: the slope over the speed is wanted.
constexpr double narrowest_range = 0.5;

struct Task {
    laws::flow::AnyFlowLaw law;
    double speed{};
};

/// Creeping flows around one bob.
class Flows {
public:
    Flows(const geometry::DinBob& bob, double accuracy, const ProgressSink& progress)
        : bob_(bob), accuracy_(accuracy), progress_(progress) {}

    /// ln c_L of each task.
    std::vector<double> solve(const std::vector<Task>& tasks) {
        std::vector<axisymmetric::CreepingTorque> found(tasks.size());
        side_by_side(
            tasks.size(),
            [&](std::size_t k) {
                found[k] = axisymmetric::creeping_torque(bob_, tasks[k].law, tasks[k].speed,
                                                         {.accuracy = accuracy_});
            },
            [&] {
                // Most laws take about 11 solutions.
                if (progress_)
                    progress_(std::min(0.95, ++told_ / 12.0), "ends of the bob");
            });
        std::vector<double> logarithms;
        for (const axisymmetric::CreepingTorque& torque : found) {
            logarithms.push_back(std::log(torque.end_factor));
            relative_error_ = std::max(relative_error_, torque.error / torque.torque);
            reached_ = reached_ && torque.reached;
            ++solutions_;
        }
        return logarithms;
    }

    [[nodiscard]] double relative_error() const { return relative_error_; }
    [[nodiscard]] bool reached() const { return reached_; }
    [[nodiscard]] int solutions() const { return solutions_; }

private:
    const geometry::DinBob& bob_;
    double accuracy_;
    const ProgressSink& progress_;
    int told_ = 0;
    double relative_error_ = 0.0;
    bool reached_ = true;
    int solutions_ = 0;
};

laws::flow::AnyFlowLaw law_at(const Model& law, std::span<const double> search) {
    const auto made = law.for_solvers(law.values(search));
    if (!made)
        throw std::invalid_argument("end_factors_of: the solvers do not know this law");
    return *made;
}

std::vector<Task> tasks_at(const laws::flow::AnyFlowLaw& law, const std::vector<double>& points) {
    std::vector<Task> tasks;
    for (const double log_speed : points)
        tasks.push_back({law, std::exp(log_speed)});
    return tasks;
}

/// How a parameter's coordinate moves when all stresses, or all times, grow by one e-fold.
struct Scaling {
    double by_stress{};
    double by_time{};
};

Scaling scaling_of(const Model& law, std::size_t index, std::span<const double> search) {
    const Parameter& parameter = law.parameters[index];
    Scaling exponents;
    if (parameter.unit.starts_with("Pa"))
        exponents.by_stress = 1.0;
    if (parameter.unit == "Pa.s" || parameter.unit == "s")
        exponents.by_time = 1.0;
    else if (parameter.unit == "1/s")
        exponents.by_time = -1.0;
    else if (parameter.unit == "Pa.s^n")
        exponents.by_time = law.values(search)[*law.find("flow_index")];
    const double slope = parameter.transform == Transform::logarithm     ? 1.0
                         : parameter.transform == Transform::square_root ? 0.5 * search[index]
                                                                         : search[index];
    return {slope * exponents.by_stress, slope * exponents.by_time};
}

/// Which parameters' slopes the two scalings give; the others' are solved for.
struct Split {
    std::vector<std::size_t> by_scaling; ///< none, one or two
    std::vector<std::size_t> moved;
};

Split split_of(const Model& law, const std::vector<Scaling>& scalings,
               std::span<const double> search, double lowest_stress) {
    // A stress far below all others has no logarithm to speak of.
    const auto usable = [&](std::size_t i) {
        const bool is_stress = law.parameters[i].unit == "Pa";
        return std::hypot(scalings[i].by_stress, scalings[i].by_time) > 0.0 &&
               !(is_stress && law.values(search)[i] < 0.1 * lowest_stress);
    };
    Split split;
    double best = 0.1;
    for (std::size_t i = 0; i < law.size(); ++i)
        for (std::size_t k = i + 1; k < law.size(); ++k) {
            if (!usable(i) || !usable(k))
                continue;
            const Scaling& a = scalings[i];
            const Scaling& b = scalings[k];
            const double area =
                std::abs(a.by_stress * b.by_time - a.by_time * b.by_stress) /
                (std::hypot(a.by_stress, a.by_time) * std::hypot(b.by_stress, b.by_time));
            if (area > best) {
                best = area;
                split.by_scaling = {i, k};
            }
        }
    for (std::size_t i = 0; i < law.size() && split.by_scaling.empty(); ++i)
        if (usable(i))
            split.by_scaling = {i};
    for (std::size_t i = 0; i < law.size(); ++i)
        if (std::ranges::find(split.by_scaling, i) == split.by_scaling.end())
            split.moved.push_back(i);
    return split;
}

/// The slopes that make both scalings' sums right, the moved parameters' being known.
void solve_scalings(const std::vector<Scaling>& scalings, const Split& split, double by_log_speed,
                    std::span<double> slopes) {
    double stress_sum = 0.0;
    double time_sum = by_log_speed;
    for (const std::size_t i : split.moved) {
        stress_sum -= scalings[i].by_stress * slopes[i];
        time_sum -= scalings[i].by_time * slopes[i];
    }
    if (split.by_scaling.size() == 1) {
        const Scaling& only = scalings[split.by_scaling.front()];
        slopes[split.by_scaling.front()] =
            (only.by_stress * stress_sum + only.by_time * time_sum) /
            (only.by_stress * only.by_stress + only.by_time * only.by_time);
    } else if (split.by_scaling.size() == 2) {
        const Scaling& a = scalings[split.by_scaling[0]];
        const Scaling& b = scalings[split.by_scaling[1]];
        const double determinant = a.by_stress * b.by_time - a.by_time * b.by_stress;
        slopes[split.by_scaling[0]] =
            (stress_sum * b.by_time - time_sum * b.by_stress) / determinant;
        slopes[split.by_scaling[1]] =
            (a.by_stress * time_sum - a.by_time * stress_sum) / determinant;
    }
}

bool is_homogeneous(const laws::flow::AnyFlowLaw& law) {
    return std::holds_alternative<laws::flow::Newtonian>(law) ||
           std::holds_alternative<laws::flow::PowerLaw>(law);
}

/// The curve ln c_L over ln(speed), finer until it stands.
ChebyshevCurve curve_of(Flows& flows, const laws::flow::AnyFlowLaw& law, double low, double high,
                        double accuracy, double& interpolation_error) {
    if (is_homogeneous(law))
        return {low, high, flows.solve({{law, std::exp(high)}})};
    ChebyshevCurve curve(low, high,
                         flows.solve(tasks_at(law, chebyshev_points(low, high, first_degree))));
    for (int degree = 2 * first_degree; degree <= last_degree; degree *= 2) {
        const std::vector<double> points = chebyshev_points(low, high, degree);
        std::vector<double> between;
        for (std::size_t k = 1; k < points.size(); k += 2)
            between.push_back(points[k]);
        const std::vector<double> solved = flows.solve(tasks_at(law, between));
        double largest_miss = 0.0;
        std::vector<double> values;
        for (std::size_t k = 0; k < points.size(); ++k) {
            if (k % 2 == 0) {
                values.push_back(curve.values()[k / 2]);
                continue;
            }
            values.push_back(solved[k / 2]);
            largest_miss = std::max(largest_miss, std::abs(curve.at(points[k]) - solved[k / 2]));
        }
        curve = {low, high, std::move(values)};
        interpolation_error = largest_miss / gain_of_doubling;
        if (interpolation_error <= accuracy)
            break;
    }
    return curve;
}

} // namespace

EndFactors end_factors_of(const geometry::DinBob& bob, const Model& law,
                          std::span<const double> search, std::span<const double> speeds,
                          double accuracy, const ProgressSink& progress) {
    const auto [slowest, fastest] = std::ranges::minmax(speeds);
    const double widened = std::max(0.0, 0.5 * (narrowest_range - std::log(fastest / slowest)));
    const double low = std::log(slowest) - widened;
    const double high = std::log(fastest) + widened;
    const laws::flow::AnyFlowLaw here = law_at(law, search);

    Flows flows(bob, accuracy, progress);
    double interpolation_error = 0.0;
    const ChebyshevCurve curve = curve_of(flows, here, low, high, accuracy, interpolation_error);

    EndFactors result;
    result.search.assign(search.begin(), search.end());
    const double lowest_stress = laws::flow::stress(here, 2.0 * slowest);
    std::vector<Scaling> scalings;
    for (std::size_t i = 0; i < law.size(); ++i)
        scalings.push_back(scaling_of(law, i, search));
    const Split split = split_of(law, scalings, search, lowest_stress);

    // d ln c_L / d parameter of the moved ones, as curves over the speed.
    std::vector<ChebyshevCurve> moved_curves;
    const std::vector<double> points =
        is_homogeneous(here) ? std::vector{high} : chebyshev_points(low, high, first_degree);
    for (const std::size_t i : split.moved) {
        std::vector<double> there(search.begin(), search.end());
        const bool is_stress =
            law.parameters[i].unit == "Pa" && law.parameters[i].transform == Transform::identity;
        const double step = is_stress ? stress_move * lowest_stress : move;
        // Towards smaller indices, which stay within every law's definition.
        const bool down = law.parameters[i].unit == "1" && there[i] > 2.0 * step;
        there[i] += down ? -step : step;
        std::vector<double> changes = flows.solve(tasks_at(law_at(law, there), points));
        for (std::size_t k = 0; k < points.size(); ++k)
            changes[k] = (changes[k] - curve.at(points[k])) / (down ? -step : step);
        moved_curves.emplace_back(low, high, std::move(changes));
    }
    for (const double speed : speeds) {
        const double log_speed = std::log(speed);
        result.values.push_back(std::exp(curve.at(log_speed)));
        std::vector<double> slopes(law.size());
        for (std::size_t k = 0; k < split.moved.size(); ++k)
            slopes[split.moved[k]] = moved_curves[k].at(log_speed);
        solve_scalings(scalings, split, curve.slope_at(log_speed), slopes);
        result.slopes.insert(result.slopes.end(), slopes.begin(), slopes.end());
    }
    result.relative_error = flows.relative_error() + interpolation_error;
    result.solutions = flows.solutions();
    result.reached = flows.reached();
    return result;
}

} // namespace searle::solvers::fit_instrument
