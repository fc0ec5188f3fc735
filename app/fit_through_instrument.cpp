#include "app/fit_through_instrument.hpp"

#include "app/case_reader.hpp"
#include "app/fit_options.hpp"
#include "app/usage_error.hpp"
#include "rheometry/fit/fit.hpp"
#include "rheometry/tables/measured_data.hpp"
#include "solvers/fit_instrument/fit_instrument.hpp"
#include "solvers/stability/taylor_threshold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

namespace searle::app {
namespace {

namespace through = solvers::fit_instrument;

void tell(const std::string& line) { std::fputs((line + "\n").c_str(), stderr); }

/// Rows of one file with the instrument they come from, before anything is left out.
struct Series {
    std::string name;
    solvers::Scene scene;
    rheometry::Conversion conversion;
    std::vector<double> speeds;
    std::vector<double> torques;
};

/// Bob and gap where Taylor vortices are known to start.
struct OuterGap {
    double radius{};
    double width{};
};

std::optional<OuterGap> outer_gap(const geometry::Instrument& instrument) {
    if (const auto* gap = std::get_if<geometry::ConcentricCylinders>(&instrument))
        return OuterGap{gap->bob_radius, gap->gap()};
    if (const auto* bob = std::get_if<geometry::DinBob>(&instrument))
        return OuterGap{bob->bob_radius, bob->gap()};
    if (const auto* gaps = std::get_if<geometry::DoubleGap>(&instrument))
        return OuterGap{gaps->radii[2], gaps->outer_gap()};
    return std::nullopt;
}

/// Re over its critical value, with the apparent viscosity of the row.
double taylor_ratio(const Series& series, double speed, double torque) {
    const auto gap = outer_gap(series.scene.instrument);
    if (!gap || !(torque > 0.0))
        return 0.0;
    const double viscosity =
        series.conversion.shear_stress(torque) / series.conversion.shear_rate(speed);
    const double reynolds =
        gap->radius * speed * gap->width * series.scene.fluid.density / viscosity;
    return reynolds / solvers::stability::taylor_threshold(gap->width / gap->radius).reynolds;
}

std::vector<Series> read_series(const FitVerbOptions& options) {
    if (options.case_files.size() != 1 && options.case_files.size() != options.data_files.size())
        throw UsageError(fmt::format("--case: {} cases for {} data files; give one case for all, "
                                     "or one per file in the same order",
                                     options.case_files.size(), options.data_files.size()));
    std::vector<Series> all;
    for (std::size_t i = 0; i < options.data_files.size(); ++i) {
        const auto& case_file =
            options.case_files.size() == 1 ? options.case_files.front() : options.case_files[i];
        const Case read = read_case(case_file, options.overrides);
        const rheometry::Conversion conversion =
            rheometry::conversion_for(read.scene.instrument, read.scene.conversion);
        if (conversion.end_factor_provisional)
            tell(fmt::format("{}: no end factor can be computed for a fluid that is yet to be "
                             "found; c_L = {} is used",
                             case_file.string(), conversion.end_factor));
        const auto motion = geometry::rotates(read.scene.instrument)
                                ? rheometry::DriveMotion::turning
                                : rheometry::DriveMotion::sliding;
        rheometry::MeasuredData data = rheometry::read_measured_data(options.data_files[i], motion);
        for (const std::string& remark : data.remarks)
            tell(fmt::format("{}: {}", options.data_files[i].string(), remark));
        for (rheometry::MeasuredStep& step : data.steps) {
            std::string name = options.data_files[i].stem().string();
            if (!step.name.empty())
                name = fmt::format("{}: {}", name, step.name);
            if (options.curve && name.find(*options.curve) == std::string::npos)
                continue;
            all.push_back({std::move(name), read.scene, conversion, std::move(step.speed),
                           std::move(step.torque)});
        }
    }
    if (all.empty())
        throw UsageError(
            fmt::format("--curve: no step's name holds \"{}\"", options.curve.value_or("")));
    return all;
}

/// Rows that can be used, by instrument, and the curve that the conversion makes of them.
struct Prepared {
    std::vector<through::Measurement> measurements;
    std::vector<fit::MeasuredPoint> points; ///< usable ones
    std::vector<fit::ExcludedPoint> excluded;
};

void add_series(Prepared& prepared, const Series& series, const fit::Selection& selection) {
    through::Measurement measurement{
        series.scene.instrument, {series.conversion.end_factor}, {}, {}};
    if (std::holds_alternative<geometry::Box>(series.scene.instrument))
        measurement.end_factors = {1.0};
    std::vector<fit::MeasuredPoint> points;
    for (std::size_t k = 0; k < series.speeds.size(); ++k) {
        const double speed = std::abs(series.speeds[k]);
        const double torque = std::copysign(1.0, series.speeds[k]) * series.torques[k];
        const bool vortices =
            speed > 0.0 && torque > 0.0 && taylor_ratio(series, speed, torque) > 1.0;
        points.push_back({.rate = series.conversion.shear_rate(series.speeds[k]),
                          .stress = series.conversion.shear_stress(series.torques[k]),
                          .deviation = std::numeric_limits<double>::quiet_NaN(),
                          .line = k + 1,
                          .regime = vortices ? "taylor-vortices" : ""});
    }
    const fit::FlowData usable = fit::select_points(points, selection);
    prepared.excluded.insert(prepared.excluded.end(), usable.excluded.begin(),
                             usable.excluded.end());
    for (const std::size_t line : usable.lines) {
        prepared.points.push_back(points[line - 1]);
        measurement.speeds.push_back(std::abs(series.speeds[line - 1]));
        measurement.torques.push_back(std::abs(series.torques[line - 1]));
    }
    if (!measurement.speeds.empty())
        prepared.measurements.push_back(std::move(measurement));
}

CurveRecord fit_prepared(const std::string& name, const Prepared& prepared,
                         const FitVerbOptions& options) {
    CurveRecord record;
    record.name = name;
    record.through_instrument = true;
    fit::Selection all;
    all.keep_disturbed = true;
    record.data = fit::select_points(prepared.points, all);
    record.data.excluded = prepared.excluded;
    if (!prepared.excluded.empty())
        tell(fmt::format("{}: left out {} rows; the first, row {}: {}", name,
                         prepared.excluded.size(), prepared.excluded.front().point.line,
                         prepared.excluded.front().reason));
    for (const fit::Model& law : laws_of(options.model)) {
        try {
            through::InstrumentFit done = through::fit_through(
                law, prepared.measurements, record.data, fit_options_of(options), options.slip);
            LawRecord each;
            each.law = fit::model_named(law.name);
            each.conventional = done.conventional->estimates;
            each.result = std::move(done.result);
            each.result.warnings.insert(each.result.warnings.begin(), record.data.remarks.begin(),
                                        record.data.remarks.end());
            record.laws.push_back(std::move(each));
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
    if (options.predict || options.design)
        throw UsageError("--predict and --design work on rheograms; convert the data first");
    const fit::FitOptions how = fit_options_of(options);
    if (how.weighting == fit::Weighting::custom)
        throw UsageError("--weights with --case takes relative, fitted, absolute or log");
    const fit::Selection selection = selection_of(options);
    const std::vector<Series> all = read_series(options);
    std::vector<CurveRecord> records;
    if (options.joint) {
        Prepared prepared;
        for (const Series& series : all)
            add_series(prepared, series, selection);
        records.push_back(
            fit_prepared(fmt::format("{} series together", all.size()), prepared, options));
        return records;
    }
    for (const Series& series : all) {
        Prepared prepared;
        add_series(prepared, series, selection);
        records.push_back(fit_prepared(series.name, prepared, options));
    }
    return records;
}

} // namespace searle::app
