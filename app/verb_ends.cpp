#include "app/verb_ends.hpp"

#include "app/case_reader.hpp"
#include "app/ends_as_json.hpp"
#include "app/exit_code.hpp"
#include "app/fit_options.hpp"
#include "app/interrupt.hpp"
#include "app/progress_line.hpp"
#include "app/result_folder.hpp"
#include "app/solved_case.hpp"
#include "app/usage_error.hpp"
#include "solvers/meridional/bob_solver.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <string_view>

namespace searle::app {
namespace {

using rheometry::EndEffect;
using solvers::axisymmetric::EndEffectTable;

std::string as_text(const EndEffectTable& table, const Case& source) {
    std::string text = fmt::format(
        "End factor c_L: {}, {}\n\n{:>14} {:>12} {:>12} {:>9}   {:<21} {:>12} {:>9}\n",
        geometry::name_of(source.scene.instrument), laws::flow::name_of(source.scene.fluid.law),
        "speed, rad/s", "rate, 1/s", "creeping", "+-", "energy bounds", "with inertia", "+-");
    for (const EndEffect& row : table.rows) {
        text += fmt::format("{:>14.6g} {:>12.6g} {:>12.6f} {:>9.1e}   {:.6f} ... {:.6f}", row.speed,
                            row.shear_rate, row.end_factor, row.error, row.lower, row.upper);
        text += std::isfinite(row.with_inertia)
                    ? fmt::format(" {:>12.6f} {:>9.1e}\n", row.with_inertia, row.with_inertia_error)
                    : fmt::format(" {:>12} {:>9}\n", "-", "-");
    }
    return text;
}

std::vector<double> speeds_of(const EndsOptions& options, const solvers::Scene& scene) {
    if (!options.rates) {
        std::vector<double> rows;
        for (const solvers::RowForecast& row : solvers::make_plan(scene).rows)
            rows.push_back(row.speed);
        return solvers::axisymmetric::speeds_for_table(rows);
    }
    const double rate_per_speed =
        rheometry::conversion_for(scene.instrument, scene.conversion).rate_per_speed;
    std::vector<double> speeds;
    for (const double rate : rates_of(*options.rates, "--rates"))
        speeds.push_back(rate / rate_per_speed);
    return speeds;
}

} // namespace

int ends(const EndsOptions& options) {
    const Case source = read_case(options.case_file, options.overrides);
    if (source.scene.profile)
        throw EngineMissing(fmt::format(
            "{}: geometry.type: a profile has no rotor without ends to compare with, so no c_L; "
            "searle run with solver.engine = \"openfoam\" gives its torque. This table is of a "
            "din-bob, and of a single-gap or double-gap with ends = true",
            source.file.string()));
    if (!geometry::has_ends(source.scene.instrument))
        throw EngineMissing(fmt::format(
            "{}: geometry.type: this {} is a slice without ends; a din-bob has them, and so has a "
            "single-gap or double-gap with ends = true",
            source.file.string(), geometry::name_of(source.scene.instrument)));
    if (options.output) {
        const auto folder = std::filesystem::absolute(*options.output).parent_path();
        if (!std::filesystem::is_directory(folder))
            throw UsageError(fmt::format("-o {}: there is no folder {}", options.output->string(),
                                         folder.string()));
    }
    const std::vector<double> speeds = speeds_of(options, source.scene);
    EndEffectTable table;
    {
        const InterruptWatch watch;
        ProgressLine line(options.quiet);
        table = solvers::meridional::end_effects(source.scene, speeds,
                                                 [&](double fraction, std::string_view stage) {
                                                     if (watch.requested())
                                                         throw solvers::Interrupted();
                                                     line.show(fraction, stage);
                                                 });
    }
    const std::string text = options.json  ? ends_as_json(table, source)
                             : options.csv ? rheometry::end_effect_csv(table.rows)
                                           : as_text(table, source);
    if (options.output)
        replace_file(*options.output, text);
    else
        std::fwrite(text.data(), 1, text.size(), stdout);
    if (table.interrupted) {
        std::fputs(fmt::format("searle: interrupted: {} of {} speeds were finished\n",
                               table.rows.size(), speeds.size())
                       .c_str(),
                   stderr);
        return ExitCode::interrupted;
    }
    if (!table.reached)
        std::fputs(fmt::format("searle: the asked accuracy of {:.3g} % was not reached at every "
                               "speed; the errors say where\n",
                               100.0 * source.scene.solver.accuracy)
                       .c_str(),
                   stderr);
    return table.reached ? ExitCode::done : ExitCode::not_reached;
}

} // namespace searle::app
