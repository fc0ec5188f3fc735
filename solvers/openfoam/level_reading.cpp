#include "solvers/openfoam/level_reading.hpp"

#include "solvers/openfoam/case_folder.hpp"
#include "solvers/openfoam/convergence_plan.hpp"
#include "solvers/openfoam/velocity_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace searle::solvers::openfoam {
namespace {

namespace fs = std::filesystem;

/// Linear between samples; nothing outside of them.
std::optional<double> value_at(const std::vector<LoadSample>& samples, double time,
                               double tolerance) {
    const auto after = std::ranges::lower_bound(samples, time - tolerance, {}, &LoadSample::time);
    if (after == samples.end())
        return std::nullopt;
    if (after == samples.begin() || std::abs(after->time - time) <= tolerance)
        return after->value;
    const LoadSample& before = *(after - 1);
    const double part = (time - before.time) / (after->time - before.time);
    return before.value + part * (after->value - before.value);
}

/// Integral from 0 over the samples up to a time: over the first step as an implicit step sums it,
/// then by trapezoids.
double integral_of(const std::vector<LoadSample>& samples, double until, const auto& integrand) {
    double sum = 0.0;
    for (std::size_t at = 0; at < samples.size() && samples[at].time <= until; ++at) {
        const double before = at == 0 ? 0.0 : samples[at - 1].time;
        const double mean = at == 0 ? integrand(at) : 0.5 * (integrand(at - 1) + integrand(at));
        sum += mean * (samples[at].time - before);
    }
    return sum;
}

void read_in_time(const LevelTask& task, const LevelCase& level, LevelResult& result) {
    const fs::path post = task.folder / "postProcessing";
    const std::vector<LoadSample> bob = load_history(post / "torque_bob", level.component());
    const std::vector<LoadSample> cup = load_history(post / "torque_cup", level.component());
    const double factor = level.slice_factor();
    const double tolerance = 1e-3 * level.facts().time_step;
    for (const double time : task.plan.history.row_times) {
        const auto torque = value_at(bob, task.plan.hold + time, tolerance);
        if (!torque)
            break;
        result.torque.push_back(-factor * *torque);
        result.unsettled.push_back(0.0);
    }
    result.steps = static_cast<long>(bob.size());
    const bool at_end = !bob.empty() && bob.size() == cup.size() &&
                        bob.back().time > end_time(level.facts()) - 0.5 * level.facts().time_step;
    const std::vector<std::string> times = times_in(task.folder);
    if (!at_end || times.empty())
        return;
    const std::vector<geometry::Point> velocity =
        velocity_at(task.folder, times.back(), level.mesh().mesh.cells.size());
    if (velocity.empty())
        return;
    const double until = std::stod(times.back()) + tolerance;
    // Force on the rotor by the fluid is minus the drive's; that on the cup brakes the fluid.
    const double gained = integral_of(
        bob, until, [&](std::size_t at) { return -factor * (bob[at].value + cup[at].value); });
    const double worked =
        integral_of(bob, until, [&](std::size_t at) { return std::abs(factor * bob[at].value); });
    if (worked > 0.0)
        result.imbalance = std::abs(gained - level.momentum(velocity)) / worked;
}

/// What a function object wrote during a steady row, and nothing where the row is not finished.
class RowLoads {
public:
    RowLoads(const LevelTask& task, const LevelCase& level, const char* object)
        : task_(task),
          all_(load_history(task.folder / "postProcessing" / object, level.component())) {}

    [[nodiscard]] std::vector<LoadSample> of(std::size_t row) const {
        const double start = start_of_row(task_.plan, row);
        const double end = end_of_row(task_.plan, row);
        const bool is_finished = runs_row_by_row(task_.plan)
                                     ? row_is_finished(task_, row)
                                     : !all_.empty() && all_.back().time > end - 0.5;
        if (!is_finished)
            return {};
        return {std::ranges::upper_bound(all_, start + 0.5, {}, &LoadSample::time),
                std::ranges::upper_bound(all_, end + 0.5, {}, &LoadSample::time)};
    }

private:
    const LevelTask& task_;
    std::vector<LoadSample> all_;
};

/// How much the last of a steady row's samples would still change, >= 0: the rest of a geometric
/// series of the changes over its last two fifths, and no less than the last of these.
double remaining_change(const std::vector<LoadSample>& samples) {
    constexpr std::size_t too_few = 10; // to tell a decay from
    if (samples.size() < too_few) {
        const auto [least, most] = std::ranges::minmax(samples, {}, &LoadSample::value);
        return most.value - least.value;
    }
    const auto at = [&](std::size_t fifth) {
        return samples[(samples.size() - 1) * fifth / 5].value;
    };
    const double last = std::abs(at(5) - at(4));
    const double before = std::abs(at(4) - at(3));
    constexpr double slowest = 0.95; // beyond, nothing tells where it ends
    const double ratio = before > 0.0 ? std::min(slowest, last / before) : 0.0;
    return last * std::max(1.0, ratio / (1.0 - ratio));
}

void read_steady(const LevelTask& task, const LevelCase& level, LevelResult& result) {
    const double factor = level.slice_factor();
    const std::size_t rows = task.plan.speeds.speeds.size();
    const RowLoads on_bob(task, level, "torque_bob");
    const RowLoads on_cup(task, level, "torque_cup");
    double worst = 0.0;
    for (std::size_t row = 0; row < rows; ++row) {
        const std::vector<LoadSample> bob = on_bob.of(row);
        const std::vector<LoadSample> cup = on_cup.of(row);
        if (bob.empty() || cup.empty())
            break;
        const double torque = -factor * bob.back().value;
        const double rest = std::abs(torque - factor * cup.back().value);
        result.torque.push_back(torque);
        // A slow part of what moves may hide behind a quicker one: no less than what the residual
        // that ends rows was chosen for.
        const double left = runs_row_by_row(task.plan)
                                ? unsettled_part(task.scene.solver.accuracy) * std::abs(torque)
                                : 0.0;
        result.unsettled.push_back(std::max({rest, factor * remaining_change(bob), left}));
        result.steps += static_cast<long>(bob.size());
        if (torque != 0.0)
            worst = std::max(worst, rest / std::abs(torque));
    }
    if (result.torque.size() == rows)
        result.imbalance = worst;
}

} // namespace

bool row_is_finished(const LevelTask& task, std::size_t row) {
    const std::string end = name_of_iteration(end_of_row(task.plan, row));
    std::error_code missing;
    return fs::exists(task.folder / end / "U", missing) ||
           fs::exists(task.folder / "processor0" / end / "U", missing);
}

LevelResult read_results(const LevelTask& task, const LevelCase& level) {
    LevelResult result;
    result.cells = level.mesh().mesh.cells.size();
    result.chord_error = level.chord_error();
    if (task.plan.steady)
        read_steady(task, level, result);
    else
        read_in_time(task, level, result);
    // Of steady rows each has a speed, so none is without torque: nothing was solved.
    const auto not_finite = std::ranges::find_if_not(result.torque, [&task](double torque) {
        return std::isfinite(torque) && (torque != 0.0 || !task.plan.steady);
    });
    if (not_finite != result.torque.end()) {
        result.failure = fmt::format("OpenFOAM's torque is no number, or 0, from row {} on.",
                                     not_finite - result.torque.begin() + 1);
        result.unsettled.resize(static_cast<std::size_t>(not_finite - result.torque.begin()));
        result.torque.erase(not_finite, result.torque.end());
        result.imbalance.reset();
    }
    return result;
}

} // namespace searle::solvers::openfoam
