#include "app/verb_fit.hpp"

#include "app/exit_code.hpp"
#include "app/fit_curves.hpp"
#include "app/fit_options.hpp"
#include "app/fit_record.hpp"
#include "app/fit_through_instrument.hpp"
#include "app/result_folder.hpp"
#include "app/usage_error.hpp"
#include "app/versions.hpp"
#include "rheometry/report/fit_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace searle::app {
namespace {

std::string page_of(const std::vector<CurveRecord>& curves) {
    rheometry::report::FitPageInput input;
    input.program_version = std::string(program_version());
    for (const CurveRecord& curve : curves) {
        rheometry::report::FittedCurve shown{
            .name = curve.name, .data = curve.data, .laws = {}, .failure = curve.failure};
        for (const LawRecord& law : curve.laws)
            shown.laws.push_back({law.law, law.result, law.conventional, law.curve});
        for (const ModelFreeRecord& record : curve.model_free)
            for (const ModelFreeRow& row : record.rows)
                shown.rotor_points.push_back({row.stress, row.rate, row.low, row.high});
        shown.observed = curve.observed;
        shown.observed_rates = curve.observed_rates;
        shown.notes = notes_on(curve);
        input.curves.push_back(std::move(shown));
    }
    return rheometry::report::render_fit_page(input);
}

void check_outputs(const FitVerbOptions& options) {
    for (const auto& output : options.outputs) {
        const std::string ending = output.extension().string();
        if (ending != ".html" && ending != ".json" && ending != ".csv")
            throw UsageError(
                fmt::format("-o {}: the ending must be .html, .json or .csv", output.string()));
        for (const auto& data : options.data_files) {
            std::error_code ignored;
            if (std::filesystem::equivalent(output, data, ignored))
                throw OutputPlaceError(fmt::format(
                    "{}: this file is read from; give another one with -o", output.string()));
        }
        const auto folder = settled_path(output).parent_path();
        std::error_code ignored;
        if (!std::filesystem::is_directory(folder, ignored))
            throw OutputPlaceError(
                fmt::format("{}: there is no folder {}", output.string(), folder.string()));
    }
}

} // namespace

int fit_laws(const FitVerbOptions& options) {
    check_outputs(options);
    if (options.case_files.empty() && (options.slip || options.fixed_ends || options.model_free))
        throw UsageError(
            fmt::format("{} needs --case: it works on raw torques through the instrument",
                        options.slip         ? "--slip"
                        : options.fixed_ends ? "--fixed-ends"
                                             : "--model-free"));
    const bool several_laws = laws_of(options.model).size() > 1;
    const std::vector<CurveRecord> curves =
        options.case_files.empty() ? fit_curves(options) : fit_through_instrument(options);
    for (const auto& output : options.outputs) {
        const std::string ending = output.extension().string();
        if (ending == ".html")
            replace_file(output, page_of(curves));
        else
            replace_file(output, ending == ".json" ? fits_as_json(curves, several_laws)
                                                   : fits_as_csv(curves));
    }
    if (options.json)
        std::cout << fits_as_json(curves, several_laws);
    else if (options.csv)
        std::cout << (options.predict      ? predictions_as_csv(curves)
                      : options.model_free ? model_free_as_csv(curves)
                                           : fits_as_csv(curves));
    else
        std::cout << fits_as_text(curves, options.model_free);
    const bool any = std::any_of(curves.begin(), curves.end(),
                                 [](const CurveRecord& curve) { return curve.failure.empty(); });
    if (!any) {
        std::fputs(fmt::format("searle: {}\n", curves.front().failure).c_str(), stderr);
        return ExitCode::wrong_usage;
    }
    return ExitCode::done;
}

} // namespace searle::app
