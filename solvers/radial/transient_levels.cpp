#include "solvers/radial/transient_levels.hpp"

#include "solvers/radial/annular_gap.hpp"
#include "solvers/radial/gap_run.hpp"
#include "solvers/radial/level_differences.hpp"
#include "solvers/row_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace searle::solvers::radial {
namespace {

/// Level 0 at an asked accuracy of 1e-3; both scale with the accuracy by the scheme's order 4.
constexpr double base_elements = 3.0;
constexpr double base_tolerance = 5e-2;
constexpr double loosest_tolerance = 0.1;
/// Below it rounding in the error estimate of a step would refuse every step.
constexpr double smallest_tolerance = 1e-11;
constexpr int order = 4;
/// A jump of the speed begins with a layer that no grid resolves. A Newtonian fluid forgets it; in
/// any other it leaves an error of (first element / layer)^(1 + n), about. So there the grading is
/// steepened by this factor per level, and with the accuracy to the power that goes with it.
constexpr double steepening = 4.0;
constexpr int most_levels = 9;
constexpr int most_elements = 20000;
/// Evaluations of the law in an element (a tenth of a microsecond each, half of one where powers
/// are taken) that a further level may be expected to cost; a level takes four to eight times as
/// many assemblies as the one before.
constexpr double most_evaluations = 3e7;
constexpr double level_growth = 6.0;
/// A level that takes this many times what is expected of it, or what may be expected at most, has
/// a step that it cannot get past.
constexpr double most_overrun = 3.0;
/// Share of the level before's difference that counts: two levels can agree by accident. Where the
/// level converges at all it has fallen by more than this.
constexpr double earlier_share = 1.0 / 6.0;
/// Safety factor of a bar made from few grids (Roache 1994, J. Fluids Eng. 116, 405). For order 4 a
/// difference is fifteen errors; after jumps and near moving yield surfaces the order is lower.
constexpr double safety = 3.0;
/// Of other laws than Newton's: in 2000 random histories the threefold difference was passed once,
/// by half of it, where the stress of a power-law fluid changed its sign.
constexpr double safety_of_other_laws = 5.0;
/// Beside the instant at which that stress changes its sign two levels in 10000 histories differed
/// by a seventh of the error.
constexpr double turn_safety = 10.0;
/// At a row where the drive comes to rest the stress is singular in time for every law but
/// Newton's.
constexpr double stop_safety = 30.0;
/// The first step after a kink of the speed, over the time to the next row, on the first two
/// levels. It is halved with the others: where the step tolerance lets it stand its error would be
/// the same on all levels (6e-6 of a Bingham fluid's first row, seventeen times what the levels
/// told).
constexpr double coarsest_first_step = 1e-2;
/// Of the step tolerance, left over by the nonlinear solves (gap_run.cpp).
constexpr double solve_share = 1e-2;

struct Level {
    std::vector<double> torque;
    std::vector<double> rounding; ///< relative, of the worst gap
    bool finished = true;
    bool interrupted{};
    double momentum_defect{};
    long steps{};
    long linear_solves{};
    long assemblies{}; ///< evaluations of the law over a gap
};

Level run_level(std::span<const RotorGap> gaps, const laws::flow::AnyFlowLaw& law,
                const rheometry::SpeedHistory& history, std::span<const double> layers,
                int elements, int steps_per_row, double first_step, double tolerance,
                long most_assemblies, const std::function<void(double)>& at) {
    Level level;
    const std::size_t rows = history.row_times.size();
    level.torque.assign(rows, 0.0);
    level.rounding.assign(rows, 0.0);
    std::size_t complete = rows;
    for (std::size_t g = 0; g < gaps.size(); ++g) {
        std::vector<double> flux;
        try {
            const auto share = [&](std::size_t row_count) {
                return (static_cast<double>(g) +
                        static_cast<double>(row_count) / static_cast<double>(rows)) /
                       static_cast<double>(gaps.size());
            };
            const GapRun run = run_gap(
                gaps[g].shape, law, history,
                {.elements = elements,
                 .layer = layers[g],
                 .steps_per_row = steps_per_row,
                 .first_step = first_step,
                 .step_tolerance = tolerance,
                 .most_assemblies = most_assemblies - level.assemblies},
                [&](std::size_t row, const GapRow& found) {
                    flux.push_back(found.flux);
                    level.rounding[row] = std::max(level.rounding[row], found.rounding);
                    at(share(row + 1));
                },
                [&] { at(share(flux.size())); });
            level.finished = level.finished && run.finished;
            level.momentum_defect = std::max(level.momentum_defect, run.momentum_defect);
            level.steps += run.steps;
            level.linear_solves += run.linear_solves;
            level.assemblies += run.assemblies;
        } catch (const Interrupted&) {
            level.interrupted = true;
        }
        complete = std::min(complete, flux.size());
        for (std::size_t row = 0; row < flux.size(); ++row) {
            level.torque[row] += gaps[g].torque_per_flux * flux[row];
        }
        if (level.interrupted || !level.finished) {
            // The rows of this gap are of no use without those of the gaps not yet solved.
            complete = g + 1 < gaps.size() ? 0 : complete;
            break;
        }
    }
    level.torque.resize(complete);
    return level;
}

/// Whether a row stands still, or the speed changes its sign, gradually or by a jump.
bool stops_or_turns(const rheometry::SpeedHistory& history) {
    double last = history.initial_speed;
    for (const auto& piece : history.pieces) {
        for (const double speed : {piece.start_speed, piece.end_speed}) {
            if (speed * last < 0.0) {
                return true;
            }
            last = speed != 0.0 ? speed : last;
        }
    }
    return std::ranges::any_of(history.row_times,
                               [&](double time) { return history.speed_at(time) == 0.0; });
}

/// Whether a row's torque and a neighbour's, joined to it smoothly, have opposite signs.
std::vector<bool> rows_beside_turn(std::span<const double> torque, const RowLinks& links) {
    std::vector<bool> turns(torque.size(), false);
    for (std::size_t k = 1; k < torque.size(); ++k) {
        if (links.smooth[k] && torque[k - 1] * torque[k] < 0.0) {
            turns[k - 1] = turns[k] = true;
        }
    }
    return turns;
}

bool changes_sign(std::span<const double> torque) {
    return std::ranges::adjacent_find(
               torque, [](double one, double next) { return one * next < 0.0; }) != torque.end();
}

/// Steps from row to row with which each piece of the history gets its share of them. Where a fluid
/// yields, stops or turns, the stress changes within a part of a piece, which steps as long as the
/// piece see on no level.
int steps_for_events(const rheometry::SpeedHistory& history) {
    constexpr int steps_per_piece = 16;
    std::size_t fewest = history.row_times.size();
    for (const auto& piece : history.pieces) {
        const auto from =
            std::upper_bound(history.row_times.begin(), history.row_times.end(), piece.start_time);
        const auto to = std::upper_bound(from, history.row_times.end(), piece.end_time);
        if (to != from) {
            fewest = std::min(fewest, static_cast<std::size_t>(to - from));
        }
    }
    return std::max(1, steps_per_piece / static_cast<int>(std::max<std::size_t>(1, fewest)));
}

/// The error bar while there is no second level to compare with.
std::vector<double> whole(std::span<const double> torque) {
    std::vector<double> size(torque.size());
    std::transform(torque.begin(), torque.end(), size.begin(),
                   [](double each) { return std::abs(each); });
    return size;
}

/// Slope of the law where the layer forms: at the wall's rate of the steady flow at a speed.
double tangent_viscosity(const GapShape& shape, const laws::flow::AnyFlowLaw& law, double speed) {
    const double magnitude = std::abs(speed);
    const double rate =
        shape.planar ? magnitude / shape.width()
                     : steady_gap_flow({shape.inner, shape.outer}, law, magnitude).inner_wall_rate;
    return std::visit([rate](const auto& chosen) { return double{chosen.stress_slope(rate)}; },
                      law);
}

} // namespace

std::vector<double> torque_scale(std::span<const double> torque, std::span<const double> steady) {
    std::vector<double> scale(torque.size());
    double largest = 0.0;
    for (std::size_t k = 0; k < torque.size(); ++k) {
        largest = std::max(largest, std::abs(torque[k]));
        scale[k] = std::max({std::abs(torque[k]), std::abs(steady[k]), 1e-3 * largest});
    }
    return scale;
}

std::vector<double> steady_torque(std::span<const RotorGap> gaps, const laws::flow::AnyFlowLaw& law,
                                  const rheometry::SpeedHistory& history) {
    std::vector<double> torque(history.row_times.size(), 0.0);
    for (std::size_t k = 0; k < torque.size(); ++k) {
        const double speed = std::abs(history.speed_at(history.row_times[k]));
        for (const RotorGap& gap : gaps) {
            if (speed > 0.0) {
                torque[k] +=
                    std::abs(gap.torque_per_flux) * steady_flux_size(gap.shape, law, speed);
            }
        }
    }
    return torque;
}

double yield_torque(std::span<const RotorGap> gaps, const laws::flow::AnyFlowLaw& law) {
    double torque = 0.0;
    for (const RotorGap& gap : gaps) {
        // The inner wall yields first, whichever wall moves: F = tau0 inner^2 there.
        const double area = gap.shape.planar ? 1.0 : gap.shape.inner * gap.shape.inner;
        torque += std::abs(gap.torque_per_flux) * laws::flow::yield_stress(law) * area;
    }
    return torque;
}

double thinnest_layer(const GapShape& shape, const laws::flow::AnyFlowLaw& law,
                      const rheometry::SpeedHistory& history) {
    double thinnest = shape.width();
    auto row = history.row_times.begin();
    double before = history.initial_speed;
    for (const auto& piece : history.pieces) {
        row = std::upper_bound(row, history.row_times.end(), piece.start_time);
        if (row == history.row_times.end()) {
            break;
        }
        const double speed =
            std::max({std::abs(piece.start_speed), std::abs(history.speed_at(*row)),
                      std::abs(piece.start_speed - before), 1e-6 * std::abs(piece.end_speed)});
        before = piece.end_speed;
        if (speed > 0.0) {
            const double diffusivity = tangent_viscosity(shape, law, speed) / shape.density;
            thinnest = std::min(thinnest, std::sqrt(diffusivity * (*row - piece.start_time)));
        }
    }
    return thinnest;
}

TransientTorque solve_levels(std::span<const RotorGap> gaps, const laws::flow::AnyFlowLaw& law,
                             const rheometry::SpeedHistory& history, double accuracy,
                             const ProgressSink& progress) {
    std::vector<double> layers;
    const bool newtonian = std::holds_alternative<laws::flow::Newtonian>(law);
    const RowLinks links = row_links(history, newtonian);
    const bool jumps = std::ranges::find(links.smooth, false) != links.smooth.end();
    const double usual_safety = newtonian ? safety : safety_of_other_laws;
    const bool steepened = jumps && !newtonian;
    for (const RotorGap& gap : gaps) {
        const double layer = thinnest_layer(gap.shape, law, history);
        layers.push_back(steepened ? layer * std::sqrt(std::min(1.0, accuracy / 1e-2)) : layer);
    }
    const double finer = std::pow(1e-3 / accuracy, 1.0 / order);
    int elements = std::max(3, static_cast<int>(std::lround(base_elements * finer)));
    double tolerance = std::min(loosest_tolerance, base_tolerance * accuracy / 1e-3);

    const std::vector<double> steady = steady_torque(gaps, law, history);
    const double yield = yield_torque(gaps, law);
    // The first two levels share their steps: where a stop, or a turn into the other direction, is
    // singular in time two halvings are needed to see it. The fluid may turn before its wall does.
    int first_judged = stops_or_turns(history) && !newtonian ? 3 : 2;
    const int steps_per_row = newtonian ? 1 : steps_for_events(history);
    TransientTorque result;
    std::vector<double> coarse;
    std::vector<double> earlier;
    long most_assemblies = static_cast<long>(most_overrun * most_evaluations / elements);
    const auto judge_by_too_few = [&] {
        // Twice the doubt.
        for (std::size_t k = 0; k < result.torque.size(); ++k) {
            result.error[k] *= result.rests[k] ? 1.0 : 2.0;
        }
        result.worst_relative_error *= 2.0;
        result.reached = result.worst_relative_error <= accuracy;
    };
    for (int level = 0; level < most_levels; ++level) {
        const std::string stage = "level " + std::to_string(level + 1) + ", " +
                                  std::to_string(elements) + " elements across the gap";
        const auto at = [&](double fraction) {
            if (progress) {
                progress(level == 0 ? 0.2 * fraction : 0.2 + 0.8 * fraction, stage);
            }
        };
        const int halvings = std::max(0, level - 1);
        Level found =
            run_level(gaps, law, history, layers, elements, steps_per_row << halvings,
                      std::ldexp(coarsest_first_step, -halvings), tolerance, most_assemblies, at);
        result.linear_solves += found.linear_solves;
        result.levels = level + 1;
        if (found.interrupted || !found.finished) {
            result.interrupted = found.interrupted;
            if (level == 0) {
                result.torque = std::move(found.torque);
                result.error = whole(result.torque);
                result.worst_relative_error = 1.0;
            }
            result.reached = false;
            if (!found.interrupted && level > 1 && level <= first_judged) {
                judge_by_too_few();
            }
            break;
        }
        if (!newtonian && changes_sign(found.torque)) {
            first_judged = 3;
        }
        // Of the next level, which has twice the elements.
        const double expected = level_growth * static_cast<double>(found.assemblies);
        const double allowed = most_evaluations / elements;
        most_assemblies =
            static_cast<long>(level > 1 ? std::min(most_overrun * expected, allowed) : allowed);
        result.torque = std::move(found.torque);
        result.momentum_defect = found.momentum_defect;
        result.elements = elements;
        result.steps = found.steps;
        if (level > 0) {
            const std::vector<double> scale = torque_scale(result.torque, steady);
            result.rests = rows_at_rest(result.torque, yield, history);
            std::vector<double> difference =
                level_differences(result.torque, coarse, scale, links, result.rests);
            // Once the step tolerance has reached its floor two levels share their time error; and
            // each solve is ended at a share of the step tolerance.
            const double least_bar =
                std::max(solve_share * tolerance,
                         tolerance > smallest_tolerance ? 1e-12 : 5.0 * smallest_tolerance);
            result.worst_relative_error = 0.0;
            double worst_rounding = 0.0;
            const std::vector<bool> turns = rows_beside_turn(result.torque, links);
            for (std::size_t k = 0; k < scale.size(); ++k) {
                if (result.rests[k]) {
                    result.error[k] = error_at_rest(result.torque[k], yield);
                    continue;
                }
                const double before = k < earlier.size() ? earlier_share * earlier[k] : 0.0;
                // Of a stress that falls from row to row the rounding stays what it was.
                const double rounding =
                    found.rounding[k] *
                    (k > 0 && scale[k] > 0.0 ? std::max(1.0, scale[k - 1] / scale[k]) : 1.0);
                // The same where the wall lies in the plug for an instant, while its stress turns.
                const bool is_singular = links.stops[k] || std::abs(result.torque[k]) <= yield;
                const double chosen = is_singular              ? stop_safety
                                      : !newtonian && turns[k] ? turn_safety
                                                               : usual_safety;
                const double bar =
                    std::max({chosen * std::max(difference[k], before), least_bar, rounding});
                result.error[k] = bar * scale[k];
                worst_rounding = std::max(worst_rounding, rounding);
                result.worst_relative_error = std::max(result.worst_relative_error, bar);
            }
            earlier = std::move(difference);
            result.reached = level >= first_judged && result.worst_relative_error <= accuracy;
            // Finer grids only add rounding once it is the larger part of the bar.
            const bool rounded =
                level >= first_judged && worst_rounding > 0.3 * result.worst_relative_error;
            const bool is_last =
                result.reached || rounded || elements > most_elements / 2 || expected > allowed;
            if (is_last && level < first_judged) {
                judge_by_too_few();
            }
            if (is_last) {
                break;
            }
        } else {
            result.error = whole(result.torque);
            result.worst_relative_error = 1.0;
        }
        coarse = result.torque;
        elements *= 2;
        if (steepened) {
            for (double& layer : layers) {
                layer /= steepening;
            }
        }
        tolerance = std::max(tolerance / 16.0, smallest_tolerance);
    }
    return result;
}

} // namespace searle::solvers::radial
