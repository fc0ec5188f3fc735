#include "app/engine_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace searle::app {
namespace {

double cpu_seconds_of(const SolvedCase& solved) {
    double seconds = 0.0;
    for (const StageSeconds& stage : solved.clock.stages())
        seconds += stage.cpu;
    return seconds;
}

/// Difference over what both claim as error; 0 where both agree exactly.
double joint_ratio(const rheometry::RheogramPoint& one, const rheometry::RheogramPoint& other) {
    const double difference = std::abs(one.shear_stress - other.shear_stress);
    return difference == 0.0 ? 0.0 : difference / (one.stress_error + other.stress_error);
}

} // namespace

std::vector<EngineAgreement> agreements(const std::vector<SolvedCase>& solved) {
    std::vector<EngineAgreement> all;
    const auto& reference = solved.front().rheogram.points;
    for (const SolvedCase& each : solved) {
        EngineAgreement one{.engine = each.source.name,
                            .largest_error = each.solution.worst_relative_error,
                            .cpu_seconds = cpu_seconds_of(each),
                            .wall_seconds = each.clock.wall_seconds()};
        const auto& points = each.rheogram.points;
        one.rows = static_cast<long>(std::min(points.size(), reference.size()));
        for (std::size_t row = 0; row < static_cast<std::size_t>(one.rows); ++row) {
            const double joint = joint_ratio(points[row], reference[row]);
            one.within += joint <= 1.0 ? 1 : 0;
            one.worst_joint = std::max(one.worst_joint, joint);
            if (reference[row].shear_stress != 0.0)
                one.worst_difference =
                    std::max(one.worst_difference,
                             std::abs(points[row].shear_stress / reference[row].shear_stress - 1));
        }
        all.push_back(one);
    }
    return all;
}

std::string agreement_table(const std::vector<EngineAgreement>& agreements) {
    const EngineAgreement& first = agreements.front();
    std::string text = fmt::format("  {:<10} {:>10} {:>10} {:>12} {:>8}  against {}\n", "engine",
                                   "CPU, s", "wall, s", "own error, %", "CPU", first.engine);
    for (const EngineAgreement& one : agreements) {
        text += fmt::format("  {:<10} {:>10.3g} {:>10.3g} {:>12.2g} {:>7.3g}x", one.engine,
                            one.cpu_seconds, one.wall_seconds, 100.0 * one.largest_error,
                            one.cpu_seconds / first.cpu_seconds);
        if (&one != &first)
            text +=
                fmt::format("  {} of {} rows within both errors; largest difference {:.2g} %, "
                            "{:.2g} of both errors",
                            one.within, one.rows, 100.0 * one.worst_difference, one.worst_joint);
        text += '\n';
    }
    return text;
}

std::string comparison_csv(const std::vector<SolvedCase>& solved) {
    std::string text = "row,time_s,shear_rate_1_s";
    for (const SolvedCase& each : solved)
        text += fmt::format(",{0}_stress_Pa,{0}_error_Pa", each.source.name);
    for (std::size_t at = 1; at < solved.size(); ++at)
        text += fmt::format(",{}_difference_over_errors", solved[at].source.name);
    text += '\n';
    std::size_t rows = solved.front().rheogram.points.size();
    for (const SolvedCase& each : solved)
        rows = std::min(rows, each.rheogram.points.size());
    for (std::size_t row = 0; row < rows; ++row) {
        const rheometry::RheogramPoint& first = solved.front().rheogram.points[row];
        text += fmt::format("{},{:.17g},{:.17g}", row + 1, first.time, first.shear_rate);
        for (const SolvedCase& each : solved)
            text += fmt::format(",{:.17g},{:.17g}", each.rheogram.points[row].shear_stress,
                                each.rheogram.points[row].stress_error);
        for (std::size_t at = 1; at < solved.size(); ++at)
            text += fmt::format(",{:.6g}", joint_ratio(solved[at].rheogram.points[row], first));
        text += '\n';
    }
    return text;
}

} // namespace searle::app
