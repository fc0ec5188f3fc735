#include "solvers/axisymmetric/swirl_history.hpp"

#include "solvers/axisymmetric/creeping_swirl.hpp"
#include "solvers/axisymmetric/swirl_fields.hpp"
#include "solvers/axisymmetric/swirl_stepper.hpp"
#include "solvers/row_errors.hpp"
#include "solvers/steps_of_level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace searle::solvers::axisymmetric {
namespace {

constexpr int most_levels = 7;
constexpr double element_ratio = 0.15;
/// Element next to the rotor over the gap at the first level.
constexpr double first_size = 0.1;
/// Tolerance of a step over the accuracy at the first level.
constexpr double first_tolerance = 0.03;
/// No less where a fluid yields: no number of levels brings the elements beyond an accuracy of some
/// thirty times that, and steps within 1e-11 took minutes on the first.
constexpr double least_first_tolerance = 1e-6;
/// What changes from level to level. A yield surface moves through the middle of the gap: there the
/// elements are what limits the torque, and neither those at the rotor nor the steps.
struct Refinement {
    std::array<int, most_levels> degree;
    std::array<int, most_levels> halvings; ///< of all elements across the gap
    double size;                           ///< factor of the element next to the rotor
    double tolerance;                      ///< factor of a step's
};
constexpr Refinement smooth_flow{
    .degree = {3, 4, 5, 6, 7, 8, 9}, .halvings = {}, .size = 0.4, .tolerance = 0.25};
constexpr Refinement yielding_flow{.degree = {3, 4, 6, 8, 9, 9, 9},
                                   .halvings = {0, 0, 0, 0, 1, 2, 3},
                                   .size = 0.6,
                                   .tolerance = 0.5};
/// Rounding of the law at rest, over the rate at the rotor's wall at the fastest speed.
constexpr double first_rounding = 3e-4;
constexpr double rounding_fall = 0.25;
constexpr double smooth_rounding = 1e-6; ///< of laws without a yield stress
constexpr double safety = 2.0;
constexpr double first_safety = 3.0; ///< of the first change, with none before to compare
constexpr double least_scale = 1e-3;
/// First step after a kink or a jump, over the time to the next row.
constexpr double first_step = 1e-4;
/// Newton steps times unknowns that one further level may be expected to cost: some forty seconds.
constexpr double most_work = 1e7;
constexpr double level_growth = 4.0;

struct Level {
    std::vector<double> torque; ///< scaled
    std::vector<double> steady; ///< scaled, of the steady flow at each row's speed
    bool complete{};
    double stopped_at{};
    StepsOfLevel step_ends;
    long steps{};
    long solves{};
    std::vector<std::pair<std::size_t, Eigen::VectorXd>> kept; ///< row from 1, w over fastest speed
};

/// @param coarser  steps of the level before; none at the first
Level run_level(const SectionSpace& space, const SwirlLaw& law,
                const SwirlStepper::Settings& settings, const rheometry::SpeedHistory& history,
                const StepsOfLevel& coarser, std::span<const std::size_t> field_rows,
                const ProgressSink& progress, const std::string& stage) {
    SwirlStepper stepper(space, law, settings);
    const double reference = history.fastest_speed();
    Level level;
    const auto stop = [&] {
        level.stopped_at = stepper.time();
        level.steps = stepper.steps();
        level.solves = stepper.solves();
        return std::move(level);
    };
    if (!stepper.start_steadily(history.initial_speed / reference)) {
        return stop();
    }
    std::size_t row = 0;
    for (const auto& piece : history.pieces) {
        if (row == history.row_times.size()) {
            break;
        }
        const double length = piece.end_time - piece.start_time;
        const double to_row = std::min(length, history.row_times[row] - piece.start_time);
        if (!stepper.begin(
                {.start_time = piece.start_time,
                 .speed = piece.start_speed / reference,
                 .acceleration = (piece.end_speed - piece.start_speed) / length / reference},
                first_step * to_row)) {
            return stop();
        }
        for (;;) {
            const bool has_row =
                row < history.row_times.size() && history.row_times[row] <= piece.end_time;
            const double target = has_row ? history.row_times[row] : piece.end_time;
            while (stepper.time() < target) {
                if (!stepper.step(target, coarser.longest_from(stepper.time()))) {
                    return stop();
                }
                level.step_ends.add(stepper.time());
                if (progress) {
                    progress(stepper.time() / history.duration(), stage);
                }
            }
            if (!has_row) {
                break;
            }
            const std::optional<double> steady =
                stepper.steady_torque(history.speed_at(target) / reference);
            if (!steady) {
                return stop();
            }
            level.torque.push_back(stepper.torque());
            level.steady.push_back(*steady);
            ++row;
            if (std::binary_search(field_rows.begin(), field_rows.end(), row)) {
                level.kept.emplace_back(row, stepper.rotation());
            }
        }
    }
    level.complete = true;
    return stop();
}

/// Width of the layer that momentum fills by the first row, m.
double thinnest_layer(const SectionShape& shape, const laws::flow::AnyFlowLaw& law, double density,
                      const rheometry::SpeedHistory& history) {
    double thinnest = shape.unit();
    std::size_t row = 0;
    for (const auto& piece : history.pieces) {
        while (row < history.row_times.size() && history.row_times[row] <= piece.start_time) {
            ++row;
        }
        if (row == history.row_times.size()) {
            break;
        }
        const double speed = std::max(std::abs(piece.start_speed),
                                      std::abs(history.speed_at(history.row_times[row])));
        if (speed > 0.0) {
            const double rate = shape.wall_rate(law, speed);
            const double diffusivity = laws::flow::stress(law, rate) / rate / density;
            thinnest = std::min(
                thinnest, std::sqrt(diffusivity * (history.row_times[row] - piece.start_time)));
        }
    }
    return thinnest;
}

/// Every interval across the gap and below the bob in two: a yield surface may lie anywhere.
SectionLines halved(const SectionLines& lines) {
    LineMarks marks;
    for (std::size_t family = 0; family < line_families; ++family) {
        const bool is_crossed = family == static_cast<std::size_t>(LineFamily::across_gap) ||
                                family == static_cast<std::size_t>(LineFamily::below);
        marks[family].assign(lines[family].empty() ? 0 : lines[family].size() - 1, is_crossed);
    }
    return refined(lines, marks, element_ratio);
}

/// Of the torque that a fluid at rest was left with: the last motion's where the rotor slowed down
/// to rest, the opposite where it stopped at once and the fluid ran on; 0 before any motion.
double sign_at_rest(const rheometry::SpeedHistory& history, double time) {
    double speed = history.initial_speed;
    double sign = speed == 0.0 ? 0.0 : std::copysign(1.0, speed);
    for (const auto& piece : history.pieces) {
        if (piece.start_time >= time) {
            break;
        }
        if (piece.start_speed != 0.0) {
            sign = std::copysign(1.0, piece.start_speed);
        } else if (speed != 0.0) {
            sign = -std::copysign(1.0, speed);
        }
        speed = piece.end_speed;
        if (speed != 0.0 && piece.end_time < time) {
            sign = std::copysign(1.0, speed);
        }
    }
    return sign;
}

/// The rows at rest of a run hold the yield torque, with the sign of what the flow left them with
/// where the run tells it, or the row before at the same stop.
void hold_yield_torque(const std::vector<bool>& rests, double yield_torque,
                       const rheometry::SpeedHistory& history, std::vector<double>& torque) {
    for (std::size_t k = 0; k < torque.size(); ++k) {
        if (!rests[k]) {
            continue;
        }
        const auto& piece = history.piece_at(history.row_times[k]);
        const bool stood = k > 0 && rests[k - 1] && piece.start_speed == 0.0 &&
                           piece.start_time <= history.row_times[k - 1];
        if (std::abs(torque[k]) > 0.5 * yield_torque) {
            torque[k] = std::copysign(yield_torque, torque[k]);
        } else {
            torque[k] =
                stood ? torque[k - 1] : sign_at_rest(history, history.row_times[k]) * yield_torque;
        }
    }
}

/// Bars from the torques of the level before, empty at the first; the result is what each row has
/// changed by.
/// @param known         errors that no level sees, N m
/// @param yield_torque  of a fluid at rest, N m; 0 without a yield stress
/// @param tolerance     of the level's steps
std::vector<double> set_errors(const std::vector<double>& before,
                               const std::vector<double>& change_before,
                               std::span<const double> known, double yield_torque, double tolerance,
                               const rheometry::SpeedHistory& history, SwirlHistory& result) {
    double largest = 0.0;
    for (const double each : result.torque) {
        largest = std::max(largest, std::abs(each));
    }
    result.rests = rows_at_rest(result.torque, yield_torque, history);
    hold_yield_torque(result.rests, yield_torque, history, result.torque);
    std::vector<double> change = level_changes(before, result.torque, history, tolerance);
    const bool turns = turns_within_a_piece(result.torque, history);
    result.error.assign(result.torque.size(), largest);
    result.worst_relative_error = before.empty() ? 1.0 : 0.0;
    for (std::size_t k = 0; k < change.size(); ++k) {
        const double torque = std::abs(result.torque[k]);
        if (result.rests[k]) {
            continue;
        }
        // Two levels that agree by accident: a sixth of what they differed by before.
        const bool is_third = k < change_before.size();
        const double earlier = is_third ? change_before[k] / 6.0 : 0.0;
        const double of_two = turns ? first_safety * first_safety : first_safety;
        result.error[k] = (is_third ? safety : of_two) * std::max(change[k], earlier) + known[k];
        const double against = std::max(torque, least_scale * largest);
        result.worst_relative_error =
            std::max(result.worst_relative_error, against > 0.0 ? result.error[k] / against : 0.0);
    }
    for (std::size_t k = 0; k < result.torque.size(); ++k) {
        if (result.rests[k]) {
            result.error[k] = error_at_rest(result.torque[k], yield_torque);
        }
    }
    return change;
}

/// Of the steady torques known to those of a level, at the largest: what the elements at the
/// rotor's edges miss is alike at all speeds and in time.
double ratio_of_largest(std::span<const double> known, std::span<const double> level,
                        double scale) {
    double largest = 0.0;
    double ratio = 1.0;
    for (std::size_t k = 0; k < level.size(); ++k) {
        if (std::abs(level[k]) > largest) {
            largest = std::abs(level[k]);
            ratio = known[k] / (scale * level[k]);
        }
    }
    return ratio;
}

std::vector<rheometry::fields::SectionFields>
fields_at_rows(const std::vector<std::pair<std::size_t, Eigen::VectorXd>>& kept,
               const SectionMesh& mesh, const SectionShape& shape,
               const laws::flow::AnyFlowLaw& law, const rheometry::SpeedHistory& history,
               int degree, double wall_rate) {
    std::vector<rheometry::fields::SectionFields> fields;
    for (const auto& [row, rotation] : kept) {
        auto section = swirl_fields({.mesh = mesh,
                                     .length = shape.unit(),
                                     .degree = degree,
                                     .rotation = rotation,
                                     .speed = history.fastest_speed(),
                                     .rate_scale = wall_rate},
                                    law);
        section.row = row;
        section.time = history.row_times[row - 1];
        section.speed = history.speed_at(section.time);
        fields.push_back(std::move(section));
    }
    return fields;
}

} // namespace

SwirlHistory swirl_history(const SectionShape& shape, const laws::flow::AnyFlowLaw& law,
                           double density, const rheometry::SpeedHistory& history, double accuracy,
                           const SteadyTorques& steady, std::span<const std::size_t> field_rows,
                           const ProgressSink& progress) {
    SwirlHistory result;
    const double reference = history.fastest_speed();
    const double wall_rate = shape.wall_rate(law, reference);
    const SwirlLaw scaled(law, reference, wall_rate / reference);
    const double scale = 2.0 * std::numbers::pi * std::pow(shape.unit(), 3) * scaled.stress_scale();
    const bool yields = laws::flow::yield_stress(law) > 0.0;
    const Refinement& finer = yields ? yielding_flow : smooth_flow;
    SwirlStepper::Settings settings{
        .tolerance = std::max(first_tolerance * accuracy, yields ? least_first_tolerance : 0.0),
        .inertia = density * std::pow(shape.unit(), 2) * reference / scaled.stress_scale(),
        .rounding = (yields ? first_rounding : smooth_rounding) * wall_rate / reference};
    // No wider than the layer of momentum at the first row.
    double size = std::min(first_size, thinnest_layer(shape, law, density, history) / shape.gap());
    std::vector<double> change_before;
    StepsOfLevel steps;
    double work = 0.0;
    try {
        // What a fluid at rest carries: the torque of the slowest flow.
        const bool stops = std::ranges::any_of(
            history.row_times, [&](double time) { return history.speed_at(time) == 0.0; });
        const double yield_torque = yields && stops ? stopping_torque(shape, law, progress) : 0.0;
        for (int number = 0; number < most_levels; ++number) {
            if (number > 1 && level_growth * work > most_work) {
                break;
            }
            const auto level_index = static_cast<std::size_t>(number);
            const int degree = finer.degree[level_index];
            SectionLines lines = graded_lines(shape, {.smallest = size, .ratio = element_ratio});
            for (int cut = 0; cut < finer.halvings[level_index]; ++cut) {
                lines = halved(lines);
            }
            const SectionMesh mesh = section_of(shape, lines);
            const SectionSpace space(mesh, Field::rotation, degree, degree + (yields ? 4 : 2));
            Level level = run_level(space, scaled, settings, history, steps, field_rows, progress,
                                    fmt::format("swirl in time, level {}", number + 1));
            result.newton_steps += level.solves;
            work = static_cast<double>(level.solves) * static_cast<double>(space.unknowns());
            if (!level.complete && number > 0) {
                result.stopped = fmt::format("level {} could not be followed beyond t = {:.4g} s",
                                             number + 1, level.stopped_at);
                break;
            }
            steps = std::move(level.step_ends);
            result.levels = number + 1;
            result.elements = static_cast<int>(mesh.elements.size());
            result.unknowns = space.unknowns();
            result.time_steps = level.steps;
            result.division = {lines, degree};
            const std::vector<double> before = std::exchange(result.torque, {});
            const double ratio = ratio_of_largest(steady.torque, level.steady, scale);
            result.steady_defect = std::abs(ratio - 1.0);
            std::vector<double> known;
            for (std::size_t k = 0; k < level.torque.size(); ++k) {
                const double beside = scale * (level.torque[k] - level.steady[k]);
                result.torque.push_back(steady.torque[k] + ratio * beside);
                known.push_back(steady.error[k] + std::abs((ratio - 1.0) * beside));
            }
            change_before = set_errors(before, change_before, known, yield_torque,
                                       settings.tolerance, history, result);
            result.fields =
                fields_at_rows(level.kept, mesh, shape, law, history, degree, wall_rate);
            const int first_judged = turns_within_a_piece(result.torque, history) ? 2 : 1;
            result.reached =
                number >= first_judged && level.complete && result.worst_relative_error <= accuracy;
            if (result.reached || !level.complete) {
                break;
            }
            settings.tolerance *= finer.tolerance;
            size *= finer.size;
            if (yields) {
                settings.rounding *= rounding_fall;
            }
        }
    } catch (const Interrupted&) {
        result.interrupted = true;
        result.reached = false;
    }
    return result;
}

} // namespace searle::solvers::axisymmetric
