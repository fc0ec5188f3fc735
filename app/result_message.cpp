#include "app/result_message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace searle::app {
namespace {

std::string regime_counts(const RunSummary& summary) {
    std::string text;
    for (const auto& [regime, count] : summary.regimes)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, regime);
    return text;
}

std::string last_point(const RunRecord& record) {
    const rheometry::RheogramPoint& point = record.rheogram.points.back();
    const bool turning = geometry::rotates(record.source.scene.instrument);
    std::string text = fmt::format("{:.5g} 1/s, {:.5g} Pa, ", point.shear_rate, point.shear_stress);
    if (std::isfinite(point.viscosity))
        text += fmt::format("{:.5g} Pa.s, ", point.viscosity);
    return text + fmt::format("{} {:.5g} {}", turning ? "torque" : "force", point.torque,
                              turning ? "N.m" : "N");
}

std::string warning_lines(const std::vector<std::string>& warnings) {
    std::string text;
    for (const std::string& warning : warnings)
        text += fmt::format("  warning: {}\n", warning);
    return text;
}

std::string remark_lines(const std::vector<std::string>& remarks) {
    std::string text;
    for (const std::string& remark : remarks)
        text += fmt::format("  {}\n", remark);
    return text;
}

std::string largest_error(const RunSummary& summary) {
    return fmt::format("{:.2g} % of the stress ({:.2g} % asked), {:.2g} Pa",
                       100.0 * summary.solver.worst_relative_error,
                       100.0 * summary.solver.accuracy_asked, summary.solver.largest_stress_error);
}

} // namespace

std::string result_message(const RunRecord& record, const std::filesystem::path& folder) {
    const RunSummary& summary = record.summary;
    const std::string& title = summary.title.empty() ? summary.origin.name : summary.title;
    return fmt::format(
        "{}: {} points, {}\n  regimes: {}\n  largest error: {}\n  last point: {}\n{}{}"
        "  results: {}\n",
        title, summary.rows, summary.solver.model, regime_counts(summary), largest_error(summary),
        last_point(record), remark_lines(summary.remarks), warning_lines(summary.warnings),
        (folder / "report.html").string());
}

std::string result_message(const SweepRecord& record, const std::filesystem::path& folder) {
    const SweepSummary& summary = record.summary;
    std::string text = fmt::format("{}: {} runs\n", summary.title, summary.runs.size());
    std::size_t width = 0;
    for (const SweepRun& run : summary.runs)
        width = std::max(width, run.name.size());
    for (const RunRecord& run : record.runs)
        text += fmt::format("  {:<{}}  {} points ({}); last: {}\n", run.source.name, width,
                            run.summary.rows, regime_counts(run.summary), last_point(run));
    text += remark_lines(summary.remarks);
    text += warning_lines(summary.warnings);
    long with_warnings =
        std::count_if(record.runs.begin(), record.runs.end(),
                      [](const RunRecord& run) { return !run.summary.warnings.empty(); });
    if (with_warnings > 0)
        text += fmt::format("  {} of the runs have warnings; see their reports\n", with_warnings);
    return text + fmt::format("  results: {}\n", (folder / "report.html").string());
}

} // namespace searle::app
