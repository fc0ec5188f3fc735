#include "app/fit_curves.hpp"

#include "app/fit_options.hpp"
#include "app/usage_error.hpp"
#include "rheometry/fit/fit.hpp"
#include "rheometry/tables/flow_curves.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <map>

namespace searle::app {
namespace {

void tell(const std::string& line) { std::fputs((line + "\n").c_str(), stderr); }

std::vector<rheometry::FlowCurveTable> read_all(const FitVerbOptions& options) {
    std::vector<rheometry::FlowCurveTable> curves;
    for (const auto& file : options.data_files) {
        rheometry::FlowCurveFile read =
            rheometry::read_flow_curves(file, deviation_column_of(options));
        for (const std::string& remark : read.remarks)
            tell(fmt::format("{}: {}", file.string(), remark));
        for (rheometry::FlowCurveTable& curve : read.curves)
            if (!options.curve || curve.name.find(*options.curve) != std::string::npos)
                curves.push_back(std::move(curve));
    }
    if (curves.empty())
        throw UsageError(fmt::format("--curve: no curve's name holds \"{}\"", *options.curve));
    if (!options.joint)
        return curves;
    rheometry::FlowCurveTable joined{fmt::format("{} curves together", curves.size()), {}};
    for (const rheometry::FlowCurveTable& curve : curves)
        joined.points.insert(joined.points.end(), curve.points.begin(), curve.points.end());
    return {joined};
}

/// The points left out, counted by reason, with the lines of the first few.
void tell_of_excluded(const CurveRecord& curve) {
    struct Left {
        std::size_t count{};
        std::string lines;
    };
    std::map<std::string, Left> by_reason;
    for (const fit::ExcludedPoint& each : curve.data.excluded) {
        Left& left = by_reason[each.reason];
        ++left.count;
        if (each.point.line > 0 && left.count <= 5)
            left.lines += fmt::format("{}{}", left.lines.empty() ? "" : ", ", each.point.line);
    }
    for (const auto& [reason, left] : by_reason)
        tell(fmt::format("{}: left out {} point{}{}: {}", curve.name, left.count,
                         left.count == 1 ? "" : "s",
                         left.lines.empty() ? ""
                                            : fmt::format(" (line {}{})", left.lines,
                                                          left.count > 5 ? ", ..." : ""),
                         reason));
}

std::vector<fit::RateWindow> windows_for(const fit::FlowData& data) {
    // A decade beyond the data on either side: what another setting of the same drive may reach.
    return {{"", {0.1 * data.rates.front(), 10.0 * data.rates.back()}}};
}

} // namespace

std::vector<CurveRecord> fit_curves(const FitVerbOptions& options) {
    const std::vector<fit::Model> laws = laws_of(options.model);
    const fit::FitOptions how = fit_options_of(options);
    const fit::Selection selection = selection_of(options);
    const std::vector<double> rates =
        options.predict ? rates_of(*options.predict, "--predict") : std::vector<double>();
    std::vector<CurveRecord> records;
    for (const rheometry::FlowCurveTable& curve : read_all(options)) {
        CurveRecord record;
        record.name = curve.name;
        record.data = fit::select_points(curve.points, selection);
        tell_of_excluded(record);
        try {
            std::vector<fit::FitResult> results;
            if (laws.size() == 1)
                results.push_back(fit::fit_flow_curve(laws.front(), record.data, how));
            else
                results = fit::fit_all(laws, record.data, how);
            for (fit::FitResult& result : results) {
                LawRecord law;
                law.law = fit::model_named(result.model);
                if (!rates.empty())
                    law.predictions = fit::predict(*law.law, result, record.data, rates);
                if (options.design)
                    law.designs = fit::suggest_windows(*law.law, result, windows_for(record.data),
                                                       static_cast<std::size_t>(*options.design));
                law.result = std::move(result);
                record.laws.push_back(std::move(law));
            }
        } catch (const fit::FitError& error) {
            record.failure = error.what();
        }
        records.push_back(std::move(record));
    }
    return records;
}

} // namespace searle::app
