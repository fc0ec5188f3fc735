#include "app/bench/bench_text.hpp"

#include "app/bench/work_precision.hpp"

#include <fmt/format.h>

#include <cmath>

namespace searle::app::bench {
namespace {

std::string number(double value, const char* format) {
    return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "";
}

std::string ratio_text(const Ratio& ratio) {
    return fmt::format("{}{:.{}f}", ratio.at_least ? "> " : "", ratio.ratio,
                       ratio.ratio < 10.0 ? 1 : 0);
}

/// A text for CSV: quotes only where they are needed.
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char letter : text)
        quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + '"';
}

const SceneResult* scene_named(const BenchResult& result, const std::string& name) {
    for (const SceneResult& scene : result.scenes)
        if (scene.name == name)
            return &scene;
    return nullptr;
}

} // namespace

std::string time_text(double seconds) {
    if (!std::isfinite(seconds))
        return "-";
    if (seconds < 1e-3)
        return fmt::format("{:.3g} us", 1e6 * seconds);
    if (seconds < 1.0)
        return fmt::format("{:.3g} ms", 1e3 * seconds);
    return seconds < 1000.0 ? fmt::format("{:.3g} s", seconds) : fmt::format("{:.0f} s", seconds);
}

std::string error_text(double error) {
    return std::isfinite(error) ? fmt::format("{:.1e}", error) : "-";
}

std::string bench_text(const BenchResult& result) {
    std::string text = fmt::format("searle {}, {}\n", result.version, result.machine);
    for (const SceneResult& scene : result.scenes) {
        text += fmt::format("\n{}: {}\n  errors against {}\n", scene.name, scene.title,
                            scene.reference);
        if (std::isfinite(scene.whole_program))
            text += fmt::format("  `searle run` as a whole, accuracy 1e-3: {}\n",
                                time_text(scene.whole_program));
        text += fmt::format("  {:<62} {:>10} {:>10} {:>10} {:>10} {:>9} {:>7}\n",
                            scene.cost_unit.empty() ? "" : scene.cost_unit, "true error",
                            "estimate", "CPU", "least", "unknowns", "MiB");
        for (const Measurement& point : scene.points)
            text += fmt::format("  {:<62} {:>10} {:>10} {:>10} {:>10} {:>9} {:>7}{}\n",
                                point.code + ", " + point.setting, error_text(point.true_error),
                                error_text(point.estimate), time_text(point.cpu_median),
                                time_text(point.cpu_least), number(point.unknowns, "{:.0f}"),
                                number(point.peak_MiB, "{:.0f}"),
                                point.remark.empty() ? "" : "  " + point.remark);
    }
    const std::vector<Ratio> ratios = ratios_of(result);
    if (!ratios.empty())
        text += "\nCPU time of a peer over that of searle, where both are equally far off\n";
    for (const Ratio& ratio : ratios)
        text += fmt::format("  {:<26} {:<62} error {:>8}  {} : {} = {}\n", ratio.scene, ratio.peer,
                            error_text(ratio.error), time_text(ratio.peer_cpu),
                            time_text(ratio.own_cpu), ratio_text(ratio));
    for (const std::string& note : result.notes)
        text += "note: " + note + "\n";
    return text;
}

std::string bench_csv(const BenchResult& result) {
    std::string text = "scene,code,setting,asked,true_error,reference_error,error_estimate,"
                       "cpu_median_s,cpu_least_s,repeats,unknowns,peak_MiB,remark\n";
    for (const SceneResult& scene : result.scenes)
        for (const Measurement& point : scene.points)
            text += fmt::format(
                "{},{},{},{},{},{},{},{},{},{},{},{},{}\n", scene.name, field(point.code),
                field(point.setting), number(point.asked, "{:g}"),
                number(point.true_error, "{:.6g}"), number(scene.reference_error, "{:.6g}"),
                number(point.estimate, "{:.6g}"), number(point.cpu_median, "{:.6g}"),
                number(point.cpu_least, "{:.6g}"), point.repeats, number(point.unknowns, "{:.0f}"),
                number(point.peak_MiB, "{:.1f}"), field(point.remark));
    return text;
}

std::string readme_block(const BenchResult& result) {
    std::string text = fmt::format(
        "{}\n| scene | peer at its best | its error | its CPU | Searle there | ratio |\n"
        "|---|---|---|---|---|---|\n",
        readme_begin);
    for (const Ratio& ratio : least_ratios(ratios_of(result))) {
        const SceneResult* scene = scene_named(result, ratio.scene);
        const std::string per = scene->cost_unit.empty() ? "" : " per strain";
        text += fmt::format("| {} | {} | {} | {}{} | {}{} | {} |\n", scene->title, ratio.peer,
                            error_text(ratio.error), time_text(ratio.peer_cpu), per,
                            time_text(ratio.own_cpu), per, ratio_text(ratio));
    }
    return text + fmt::format("\n{}{}.\n{}\n", result.quick ? "A quick run. " : "", result.machine,
                              readme_end);
}

std::string benchmark_tables(const BenchResult& result) {
    std::string text =
        fmt::format("Measured by Searle {} on: {}.\n", result.version, result.machine);
    for (const SceneResult& scene : result.scenes) {
        text +=
            fmt::format("\n### {}\n\n{}. Errors against {}.{}\n\n| code | setting | true error "
                        "| estimate | {} | unknowns | MiB | |\n|---|---|---|---|---|---|---|---|\n",
                        scene.name, scene.title, scene.reference,
                        std::isfinite(scene.whole_program)
                            ? fmt::format(" `searle run` as a whole at 1e-3: {} of CPU.",
                                          time_text(scene.whole_program))
                            : "",
                        scene.cost_unit.empty() ? "CPU" : scene.cost_unit);
        for (const Measurement& point : scene.points)
            text +=
                fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", point.code,
                            point.setting, error_text(point.true_error), error_text(point.estimate),
                            time_text(point.cpu_median), number(point.unknowns, "{:.0f}"),
                            number(point.peak_MiB, "{:.0f}"), point.remark);
    }
    text += "\n### Ratios at equal true error\n\n| scene | peer | error | its CPU | Searle there | "
            "ratio |\n|---|---|---|---|---|---|\n";
    for (const Ratio& ratio : ratios_of(result))
        text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", ratio.scene, ratio.peer,
                            error_text(ratio.error), time_text(ratio.peer_cpu),
                            time_text(ratio.own_cpu), ratio_text(ratio));
    return text;
}

} // namespace searle::app::bench
