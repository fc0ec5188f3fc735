#include "app/fit_through_instrument.hpp"

#include "app/fit_curves.hpp"
#include "app/fit_options.hpp"
#include "app/instrument_series.hpp"
#include "app/model_free.hpp"
#include "app/progress_line.hpp"
#include "app/usage_error.hpp"
#include "rheometry/fit/fit.hpp"
#include "solvers/fit_instrument/geometry_candidates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace searle::app {
namespace {

namespace through = solvers::fit_instrument;

/// What the options ask of every law.
struct Asked {
    fit::FitOptions how;
    bool slip{};
    bool computed_ends{};
    std::vector<double> rates;
    std::size_t design{};
};

std::vector<EndsRecord> ends_of(const through::InstrumentFit& done,
                                const PreparedSeries& prepared) {
    std::vector<EndsRecord> records;
    for (const through::ComputedEnds& ends : done.ends) {
        const auto [least, most] = std::ranges::minmax(ends.values);
        const InstrumentSeries& series = *prepared.series[ends.measurement];
        records.push_back({.series = series.name,
                           .least = least,
                           .most = most,
                           .of_case = series.conversion.end_factor,
                           .relative_error = ends.relative_error,
                           .stand_in = ends.stand_in});
    }
    return records;
}

/// Pa per unit observed, of the first instrument with the ends as computed.
double stress_per_torque(const through::InstrumentFit& done, const PreparedSeries& prepared) {
    const InstrumentSeries& series = *prepared.series.front();
    return series.conversion.stress_per_torque * series.conversion.end_factor /
           done.measurements.front().end_factors.front();
}

std::vector<fit::Candidates> candidates_for(const fit::Model& law, const fit::FitResult& result,
                                            const PreparedSeries& prepared) {
    std::vector<geometry::Instrument> own;
    for (const InstrumentSeries* series : prepared.series)
        own.push_back(series->scene.instrument);
    std::vector<fit::Candidates> sets;
    for (const through::GeometryChoice& choice : through::usual_geometries(own))
        sets.push_back(through::candidates_of(choice, law, result,
                                              prepared.series.front()->scene.fluid.density, false));
    return sets;
}

LawRecord fit_law(const fit::Model& law, const PreparedSeries& prepared, CurveRecord& record,
                  const Asked& asked) {
    ProgressLine line(false);
    line.set_prefix(std::string(law.name) + ": ");
    const through::InstrumentEffects effects{
        .ends = asked.computed_ends,
        .density = prepared.series.front()->scene.fluid.density,
        .history = prepared.runs,
        .progress = [&](double fraction, std::string_view stage) { line.show(fraction, stage); }};
    through::InstrumentFit done = through::fit_through(law, prepared.measurements, record.data,
                                                       asked.how, asked.slip, effects);
    LawRecord each;
    each.law = fit::model_named(law.name);
    each.conventional = done.conventional->estimates;
    each.ends = ends_of(done, prepared);
    const fit::FitResult as_curve = fit::law_part(
        done.result, law.size(), stress_per_torque(done, prepared), record.data.rates);
    if (!asked.rates.empty())
        each.predictions = fit::predict(*each.law, as_curve, record.data, asked.rates);
    each.curve = fit::predict(
        *each.law, as_curve, record.data,
        fit::spread_rates(0.5 * record.data.rates.front(), 2.0 * record.data.rates.back(), 121));
    if (asked.design > 0) {
        const through::InstrumentForward forward(law, done.measurements, asked.slip);
        each.designs =
            fit::suggest_designs(done.result, fit::sensitivities(forward, done.result),
                                 candidates_for(law, done.result, prepared), asked.design);
    }
    add_model_free(record, law, done, prepared);
    std::vector<std::string> warnings = record.data.remarks;
    for (const EndsRecord& ends : each.ends)
        if (ends.relative_error > 3e-3)
            warnings.push_back(fmt::format("{}: c_L is known to {:.1g} % only", ends.series,
                                           100.0 * ends.relative_error));
    // Two ways with a loop between them are no curve that falls here and there.
    if (!record.loops.empty())
        std::erase_if(warnings, [](const std::string& warning) {
            return warning.starts_with("the stress falls");
        });
    for (const std::string& warning : loop_warnings(record))
        warnings.push_back(warning);
    each.result = std::move(done.result);
    each.result.warnings.insert(each.result.warnings.begin(), warnings.begin(), warnings.end());
    return each;
}

CurveRecord fit_prepared(const std::string& name, const PreparedSeries& prepared,
                         const FitVerbOptions& options, const Asked& asked) {
    CurveRecord record;
    record.name = name;
    record.through_instrument = true;
    for (const fit::MeasuredPoint& point : prepared.points)
        record.observed_rates.push_back(std::abs(point.rate));
    for (const through::Measurement& measurement : prepared.measurements)
        record.observed.insert(record.observed.end(), measurement.torques.begin(),
                               measurement.torques.end());
    fit::Selection all;
    all.keep_disturbed = true;
    record.data = fit::select_points(prepared.points, all);
    record.data.excluded = prepared.excluded;
    record.data.remarks.insert(record.data.remarks.begin(), prepared.remarks.begin(),
                               prepared.remarks.end());
    tell_of_excluded(record);
    if (prepared.measurements.empty()) {
        record.failure =
            prepared.excluded.empty()
                ? std::string("there are no rows")
                : fmt::format("none of the {} rows can be used; the first: {}",
                              prepared.excluded.size(), prepared.excluded.front().reason);
        return record;
    }
    for (const fit::Model& law : laws_of(options.model)) {
        try {
            record.laws.push_back(fit_law(law, prepared, record, asked));
        } catch (const fit::FitError& error) {
            record.failure = error.what();
        }
    }
    if (!record.laws.empty())
        record.failure.clear();
    std::stable_sort(record.laws.begin(), record.laws.end(),
                     [](const LawRecord& a, const LawRecord& b) {
                         return a.result.criteria.aicc < b.result.criteria.aicc;
                     });
    return record;
}

} // namespace

std::vector<CurveRecord> fit_through_instrument(const FitVerbOptions& options) {
    Asked asked{.how = fit_options_of(options),
                .slip = options.slip,
                .computed_ends = !options.fixed_ends,
                .rates = options.predict ? rates_of(*options.predict, "--predict")
                                         : std::vector<double>(),
                .design = static_cast<std::size_t>(options.design.value_or(0))};
    if (asked.how.weighting == fit::Weighting::custom)
        throw UsageError("--weights with --case takes relative, fitted, absolute or log");
    const fit::Selection selection = selection_of(options);
    const std::vector<InstrumentSeries> all = read_instrument_series(options);
    std::vector<CurveRecord> records;
    if (options.joint) {
        PreparedSeries prepared;
        for (const InstrumentSeries& series : all)
            add_series(prepared, series, selection);
        records.push_back(
            fit_prepared(fmt::format("{} series together", all.size()), prepared, options, asked));
        return records;
    }
    for (const InstrumentSeries& series : all) {
        PreparedSeries prepared;
        add_series(prepared, series, selection);
        records.push_back(fit_prepared(series.name, prepared, options, asked));
    }
    return records;
}

} // namespace searle::app
