#include "app/engine_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace searle::app {
namespace {

std::string engine_of(const SolvedCase& solved) {
    return solved.source.scene.solver.engine == solvers::Engine::openfoam ? "openfoam" : "native";
}

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

std::size_t common_rows(const ComparedCase& compared) {
    std::size_t rows = compared.solved.front()->rheogram.points.size();
    for (const SolvedCase* each : compared.solved)
        rows = std::min(rows, each->rheogram.points.size());
    return rows;
}

std::string header_of(const ComparedCase& compared) {
    std::string text = compared.name.empty() ? "" : "case,";
    text += "row,time_s,shear_rate_1_s";
    for (const SolvedCase* each : compared.solved)
        text += fmt::format(",{0}_stress_Pa,{0}_error_Pa", engine_of(*each));
    for (std::size_t at = 1; at < compared.solved.size(); ++at)
        text += fmt::format(",{}_difference_over_errors", engine_of(*compared.solved[at]));
    return text + '\n';
}

} // namespace

std::vector<EngineAgreement> agreements(const ComparedCase& compared) {
    std::vector<EngineAgreement> all;
    const auto& reference = compared.solved.front()->rheogram.points;
    for (const SolvedCase* each : compared.solved) {
        EngineAgreement one{.engine = engine_of(*each),
                            .largest_error = each->solution.worst_relative_error,
                            .cpu_seconds = cpu_seconds_of(*each),
                            .wall_seconds = each->clock.wall_seconds()};
        const auto& points = each->rheogram.points;
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

std::string agreement_table(const ComparedCase& compared) {
    const std::vector<EngineAgreement> all = agreements(compared);
    const EngineAgreement& first = all.front();
    std::string text = compared.name.empty() ? "" : compared.name + '\n';
    text += fmt::format("  {:<10} {:>10} {:>10} {:>12} {:>8}  against {}\n", "engine", "CPU, s",
                        "wall, s", "own error, %", "CPU", first.engine);
    for (const EngineAgreement& one : all) {
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

std::vector<std::string> agreement_remarks(const ComparedCase& compared) {
    const std::vector<EngineAgreement> all = agreements(compared);
    const EngineAgreement& first = all.front();
    std::vector<std::string> remarks;
    for (std::size_t at = 1; at < all.size(); ++at) {
        const EngineAgreement& one = all[at];
        remarks.push_back(fmt::format(
            "{}{} of {} rows of {} lie within both engines' errors of {}; the largest difference "
            "is {:.2g} % ({:.2g} of both errors). CPU: {:.3g} s against {:.3g} s, {:.3g} times.",
            compared.name.empty() ? "" : compared.name + ": ", one.within, one.rows, one.engine,
            first.engine, 100.0 * one.worst_difference, one.worst_joint, one.cpu_seconds,
            first.cpu_seconds, one.cpu_seconds / first.cpu_seconds));
    }
    return remarks;
}

std::string comparison_csv(const std::vector<ComparedCase>& cases) {
    std::string text;
    std::string header;
    for (const ComparedCase& compared : cases) {
        if (const std::string own = header_of(compared); own != header)
            text += header = own;
        for (std::size_t row = 0; row < common_rows(compared); ++row) {
            const rheometry::RheogramPoint& first = compared.solved.front()->rheogram.points[row];
            text += compared.name.empty() ? "" : compared.name + ',';
            text += fmt::format("{},{:.17g},{:.17g}", row + 1, first.time, first.shear_rate);
            for (const SolvedCase* each : compared.solved)
                text += fmt::format(",{:.17g},{:.17g}", each->rheogram.points[row].shear_stress,
                                    each->rheogram.points[row].stress_error);
            for (std::size_t at = 1; at < compared.solved.size(); ++at)
                text += fmt::format(",{:.6g}",
                                    joint_ratio(compared.solved[at]->rheogram.points[row], first));
            text += '\n';
        }
    }
    return text;
}

} // namespace searle::app
