#include "app/verb_convert.hpp"

#include "app/case_reader.hpp"
#include "app/exit_code.hpp"
#include "app/result_folder.hpp"
#include "rheometry/converted_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iostream>
#include <stdexcept>
#include <system_error>

namespace searle::app {
namespace {

namespace fs = std::filesystem;
using rheometry::Conversion;
using rheometry::ConvertedStep;
using rheometry::MeasuredData;
using rheometry::MeasuredStep;

Conversion conversion_of(const Case& read) {
    const Conversion conversion =
        rheometry::conversion_for(read.scene.instrument, read.scene.conversion);
    if (conversion.end_factor_provisional) {
        casefile::Fault fault;
        fault.key = "conversion.end_factor";
        fault.problem =
            "a computed end factor needs the flow around the ends, which a conversion of "
            "measured data does not solve";
        fault.allowed = "a number above 0, such as 1.10";
        throw CaseError({fault});
    }
    return conversion;
}

void check_output(const ConvertOptions& options) {
    if (!options.output)
        return;
    const fs::path& output = *options.output;
    const auto refuse = [&output](std::string_view reason) {
        throw OutputPlaceError(fmt::format("{}: {}", output.string(), reason));
    };
    std::error_code error;
    if (fs::equivalent(output, options.data_file, error) ||
        fs::equivalent(output, options.case_file, error))
        refuse("this file is read from; give another one with -o");
    const fs::file_status status = fs::status(output, error);
    if (fs::is_directory(status))
        refuse("is a folder; a file is needed");
    if (fs::exists(status) && !fs::is_regular_file(status))
        refuse("is no plain file; without -o the table goes to standard output");
    const fs::path parent = settled_path(output).parent_path();
    if (!fs::is_directory(parent, error))
        refuse(fmt::format("there is no folder {}", parent.string()));
}

/// "Flow sweep - 3" for the whole name, or "3" for the number that ends it, which counts all steps
/// of the export, those that cannot be converted included.
void keep_only(MeasuredData& data, const std::string& wanted, const fs::path& file) {
    std::vector<std::string> names;
    for (const MeasuredStep& step : data.steps)
        names.push_back(fmt::format("\"{}\"", step.name));
    const bool by_name = std::ranges::any_of(
        data.steps, [&](const MeasuredStep& step) { return step.name == wanted; });
    std::erase_if(data.steps, [&](const MeasuredStep& step) {
        return by_name ? step.name != wanted : !step.name.ends_with(" - " + wanted);
    });
    const auto refuse = [&](std::string_view reason) {
        throw rheometry::TableError(
            file.string(),
            {{0,
              {},
              fmt::format("--step {}: {}; allowed: {}", wanted, reason,
                          names == std::vector<std::string>{"\"\""}
                              ? "none, since the file is a plain table"
                              : fmt::format("{}, or the number that ends one of these names",
                                            fmt::join(names, ", ")))}});
    };
    if (data.steps.empty())
        refuse("there is no such step");
    if (data.steps.size() > 1)
        refuse(fmt::format("{} steps have this number", data.steps.size()));
}

/// Bob and cup of the case, where it has one of each.
struct Radii {
    double bob{};
    double cup{};
    double length{};
};

std::optional<Radii> radii_of(const geometry::Instrument& instrument) {
    if (const auto* gap = std::get_if<geometry::ConcentricCylinders>(&instrument))
        return Radii{gap->bob_radius, gap->cup_radius, gap->height};
    if (const auto* bob = std::get_if<geometry::DinBob>(&instrument))
        return Radii{bob->bob_radius, bob->cup_radius, bob->height()};
    return std::nullopt;
}

void compare_length(std::vector<std::string>& remarks, std::string_view what, double in_case,
                    const std::optional<double>& in_export) {
    if (in_export && std::abs(in_case / *in_export - 1.0) > 1e-3)
        remarks.push_back(
            fmt::format("warning: the {} is {:.6g} mm in the case, but {:.6g} mm in the "
                        "export",
                        what, 1e3 * in_case, 1e3 * *in_export));
}

std::vector<std::string> remarks_on_geometry(const geometry::Instrument& instrument,
                                             const Conversion& conversion,
                                             const rheometry::ExportedGeometry& exported) {
    std::vector<std::string> remarks;
    const std::optional<Radii> radii = radii_of(instrument);
    if (radii) {
        compare_length(remarks, "bob's radius", radii->bob, exported.bob_radius);
        compare_length(remarks, "cup's radius", radii->cup, exported.cup_radius);
        compare_length(remarks, "bob's length", radii->length, exported.bob_length);
    }
    if (exported.end_factor && std::abs(conversion.end_factor / *exported.end_factor - 1.0) > 1e-6)
        remarks.push_back(fmt::format("warning: c_L is {} in the case, but {} in the export",
                                      conversion.end_factor, *exported.end_factor));
    return remarks;
}

std::vector<std::string> remarks_on(const ConvertedStep& step) {
    std::vector<std::string> remarks;
    const std::string where = step.name.empty() ? "" : fmt::format("step \"{}\": ", step.name);
    const auto compare = [&](std::string_view what, double difference) {
        if (std::isfinite(difference))
            remarks.push_back(
                fmt::format("{}{}the {} differs from the export's own by at most {:.1e}",
                            difference > 1e-3 ? "warning: " : "", where, what, difference));
    };
    compare("stress", step.stress_difference);
    compare("rate", step.rate_difference);
    if (step.disturbed_rows > 0)
        remarks.push_back(fmt::format(
            "{}{} of {} rows carry lag, vortices or end flow (column regime): they have no true "
            "rate at the bob and are left out of the others'",
            where, step.disturbed_rows, step.rheogram.points.size()));
    if (const auto& yield = step.at_rotor.rates.yield_stress)
        remarks.push_back(fmt::format("{}the slow end extrapolates to a yield stress of {:.4g} +- "
                                      "{:.2g} Pa at the bob (if the "
                                      "fluid does not slip)",
                                      where, *yield, step.at_rotor.rates.yield_standard_error));
    return remarks;
}

void tell(const ConvertOptions& options, const std::vector<std::string>& lines) {
    if (options.quiet)
        return;
    for (const std::string& line : lines)
        std::fputs(fmt::format("{}\n", line).c_str(), stderr);
}

} // namespace

int convert(const ConvertOptions& options) {
    const Case read = read_case(options.case_file, options.overrides);
    const geometry::Instrument& instrument = read.scene.instrument;
    const Conversion conversion = conversion_of(read);
    check_output(options);
    const auto motion = geometry::rotates(instrument) ? rheometry::DriveMotion::turning
                                                      : rheometry::DriveMotion::sliding;
    MeasuredData data = rheometry::read_measured_data(options.data_file, motion);
    if (options.step)
        keep_only(data, *options.step, options.data_file);

    std::vector<ConvertedStep> steps;
    for (const MeasuredStep& step : data.steps) {
        try {
            steps.push_back(rheometry::convert_step(step, instrument, conversion));
        } catch (const std::overflow_error& error) {
            throw rheometry::TableError(
                options.data_file.string(),
                {{0,
                  {},
                  fmt::format("{}{}{}", step.name, step.name.empty() ? "" : ", ", error.what())}});
        }
    }
    const std::string table = rheometry::converted_csv(steps, instrument, conversion);

    tell(options, {fmt::format("{}: {}", geometry::name_of(instrument),
                               rheometry::describe(conversion, instrument))});
    tell(options, data.remarks);
    tell(options, remarks_on_geometry(instrument, conversion, data.geometry));
    for (const ConvertedStep& step : steps)
        tell(options, remarks_on(step));
    if (options.output)
        replace_file(*options.output, table);
    else
        std::cout << table;
    return ExitCode::done;
}

} // namespace searle::app
