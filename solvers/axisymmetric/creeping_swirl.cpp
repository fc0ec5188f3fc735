#include "solvers/axisymmetric/creeping_swirl.hpp"

#include "solvers/axisymmetric/swirl_level.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

namespace searle::solvers::axisymmetric {
namespace {

constexpr double ratio = 0.15;       ///< of neighbouring elements towards an edge
constexpr double marked_share = 0.7; ///< of the energy gap, divided at each level
constexpr int check_points = 3;      ///< more of them for the check of the quadrature
constexpr int highest_degree = 10;
/// An estimate is believed only where the energy gap is at most this many times the accuracy.
constexpr double most_gap = 5.0;
constexpr double newton_tolerance = 1e-3; ///< of a level's decrement, over the accuracy

/// How a family of laws is refined.
struct Strategy {
    int degree;
    int degree_step;
    int extra_points; ///< of the Gauss rule beyond the degree
    double smallest;  ///< element next to the rotor, over the gap
    double rounding;  ///< aimed at on the first level
    double rounding_step;
    double least_rounding;
};

/// Solutions of smooth laws are analytic away from the edges, so the degree rises; across a yield
/// surface only a few derivatives are continuous, so elements are divided at a fixed degree.
Strategy strategy_for(const SwirlLaw& law, double accuracy) {
    if (law.homogeneity() == 2.0) {
        const double digits = -std::log10(accuracy);
        return {.degree = std::clamp(static_cast<int>(std::lround(digits)), 3, 8),
                .degree_step = 1,
                .extra_points = 2,
                .smallest = std::clamp(std::pow(20.0 * accuracy, 0.75), 1e-6, 1e-1),
                .rounding = 1e-9,
                .rounding_step = 1.0,
                .least_rounding = 1e-9};
    }
    if (law.yield_stress() == 0.0) {
        return {.degree = 4,
                .degree_step = 1,
                .extra_points = 2,
                .smallest = std::clamp(std::pow(20.0 * accuracy, 0.75), 1e-4, 1e-1),
                .rounding = 1e-5,
                .rounding_step = 0.1,
                .least_rounding = 1e-8};
    }
    return {.degree = 5,
            .degree_step = 0,
            .extra_points = 6,
            .smallest = 1e-1,
            .rounding = 1e-3,
            .rounding_step = 0.3,
            .least_rounding = 1e-6};
}

} // namespace

CreepingTorque creeping_torque(const SectionShape& shape, const laws::flow::AnyFlowLaw& law,
                               double speed, const CreepingSettings& settings,
                               const ProgressSink& progress) {
    return creeping_swirl(shape, law, speed, settings, progress).torque;
}

CreepingSwirl creeping_swirl(const SectionShape& shape, const laws::flow::AnyFlowLaw& flow_law,
                             double speed, const CreepingSettings& settings,
                             const ProgressSink& progress) {
    const double wall_rate = shape.wall_rate(flow_law, speed);
    const SwirlLaw law(flow_law, speed, wall_rate / speed);
    const double scale = 2.0 * std::numbers::pi * std::pow(shape.unit(), 3) * law.stress_scale();
    const Strategy strategy = strategy_for(law, settings.accuracy);

    CreepingTorque result;
    double rounding = law.homogeneity() == 2.0 ? strategy.rounding : 1.0;
    double target = strategy.rounding;
    double before = 0.0;
    auto level = std::make_unique<SwirlLevel>(
        shape, graded_lines(shape, {.smallest = strategy.smallest, .ratio = ratio}),
        strategy.degree, strategy.degree + strategy.extra_points);
    for (int depth = 0; depth < settings.most_levels; ++depth) {
        if (progress) {
            progress(static_cast<double>(depth) / settings.most_levels,
                     "creeping swirl, level " + std::to_string(depth + 1));
        }
        const double tolerance = std::clamp(newton_tolerance * settings.accuracy, 1e-13, 1e-7);
        while (rounding > 1.001 * target) {
            static_cast<void>(level->minimise(law, rounding, 1e3 * tolerance));
            rounding = std::max(0.1 * rounding, target);
        }
        static_cast<void>(level->minimise(law, rounding, tolerance));
        const SwirlEnergies own = level->energies(law, level->points());

        result.levels = depth + 1;
        result.elements = static_cast<int>(level->mesh().elements.size());
        result.newton_steps += level->steps();
        result.unknowns = level->unknowns();
        result.division = {level->lines(), level->rotation_space().degree()};
        const double middle = law.homogeneity() > 0.0 ? 0.5 * (own.lower + own.upper)
                                                      : 0.5 * (own.dissipation + own.flux);
        const double half_bracket = 0.5 * (own.upper - own.lower);
        const double disagreement = std::max(std::abs(own.dissipation - own.flux),
                                             depth > 0 ? std::abs(middle - before) : middle);
        const double error = std::min(disagreement, half_bracket);
        // The next level has about twice the unknowns, and rarely needs fewer steps.
        const double last_work =
            static_cast<double>(level->steps()) * static_cast<double>(level->unknowns());
        result.work += last_work;
        const bool may_go_on = depth + 1 < settings.most_levels &&
                               level->unknowns() <= settings.most_unknowns &&
                               result.work + 2.0 * last_work <= settings.most_work;
        const double goal = settings.accuracy * middle;
        if ((settings.certified ? 2.0 * half_bracket : error) <= 0.95 * goal || !may_go_on) {
            const SwirlEnergies fine = level->energies(law, level->points() + check_points);
            const double change = std::abs(fine.dissipation - own.dissipation);
            const double total = std::max(error + change, 1e-13 * middle);
            result.energy_gap = (fine.potential - fine.conjugate) / fine.potential;
            result.quadrature_error =
                std::max(std::abs(fine.lower - own.lower), std::abs(fine.upper - own.upper)) /
                middle;
            result.torque = scale * middle;
            result.error = scale * total;
            result.lower = scale * fine.lower;
            result.upper = scale * fine.upper;
            result.end_factor = result.torque / shape.endless_torque(flow_law, speed);
            result.reached = (settings.certified ? fine.upper - fine.lower : total) <= goal &&
                             result.energy_gap <= most_gap * settings.accuracy;
            if (result.reached || !may_go_on) {
                break;
            }
        }
        before = middle;
        SectionLines finer = refined(level->lines(), level->marks(law, marked_share), ratio);
        const int degree = std::min(level->rotation_space().degree() + strategy.degree_step,
                                    std::max(highest_degree, strategy.degree));
        auto next = std::make_unique<SwirlLevel>(shape, std::move(finer), degree,
                                                 degree + strategy.extra_points);
        next->start_from(*level);
        level = std::move(next);
        target = std::max(strategy.rounding_step * target, strategy.least_rounding);
    }
    return {.torque = result, .level = std::move(level), .stress_scale = law.stress_scale()};
}

double stopping_torque(const SectionShape& shape, const laws::flow::AnyFlowLaw& law,
                       const ProgressSink& progress) {
    constexpr double above = 1.01;
    constexpr double accuracy = 1e-2;
    const double rate = laws::flow::rate(law, above * laws::flow::yield_stress(law));
    return creeping_torque(shape, law, rate * shape.gap() / shape.unit(), {.accuracy = accuracy},
                           progress)
        .torque;
}

} // namespace searle::solvers::axisymmetric
