#include "app/instrument_series.hpp"

#include "app/case_reader.hpp"
#include "app/usage_error.hpp"
#include "rheometry/disturbed_regime.hpp"
#include "rheometry/tables/measured_data.hpp"
#include "solvers/plan_forecast.hpp"
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

/// Share of the torque that secondary flow at the ends may have in a row that is fitted.
constexpr double most_end_flow = 0.01;

void tell(const std::string& line) { std::fputs((line + "\n").c_str(), stderr); }

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

/// What disturbs the laminar flow at a row, with the apparent viscosity of the row; empty: nothing.
std::string disturbance_at(const InstrumentSeries& series, double speed, double torque) {
    const auto gap = outer_gap(series.scene.instrument);
    if (!gap || !(torque > 0.0) || !(speed > 0.0))
        return "";
    const double viscosity =
        series.conversion.shear_stress(torque) / series.conversion.shear_rate(speed);
    const double momentum = series.scene.fluid.density * speed / viscosity;
    if (gap->radius * gap->width * momentum >
        solvers::stability::taylor_threshold(gap->width / gap->radius).reynolds)
        return "taylor-vortices";
    const auto* bob = std::get_if<geometry::DinBob>(&series.scene.instrument);
    if (bob != nullptr &&
        solvers::end_flow_share(bob->radius_ratio(), bob->length_ratio,
                                gap->radius * gap->radius * momentum) > most_end_flow)
        return "end-flow";
    return "";
}

/// The regime that decides whether a row is used: lag is computed where there are times.
std::string deciding_regime(const InstrumentSeries& series, std::size_t row, bool has_history) {
    const double sign = std::copysign(1.0, series.speeds[row]);
    const std::string found =
        disturbance_at(series, std::abs(series.speeds[row]), sign * series.torques[row]);
    if (!found.empty() || series.regimes.empty())
        return found;
    const std::string_view written = rheometry::disturbance_in(series.regimes[row]);
    return written == "lag" && has_history ? "" : std::string(written);
}

void warn_of_export(const std::string& file, const rheometry::ExportedGeometry& exported,
                    const geometry::Instrument& instrument) {
    const auto gap = outer_gap(instrument);
    if (gap && exported.bob_radius && std::abs(gap->radius / *exported.bob_radius - 1.0) > 1e-3)
        tell(fmt::format("{}: warning: the bob's radius is {:.6g} mm in the case, but {:.6g} mm in "
                         "the export",
                         file, 1e3 * gap->radius, 1e3 * *exported.bob_radius));
}

} // namespace

std::vector<InstrumentSeries> read_instrument_series(const FitVerbOptions& options) {
    if (options.case_files.size() != 1 && options.case_files.size() != options.data_files.size())
        throw UsageError(fmt::format("--case: {} cases for {} data files; give one case for all, "
                                     "or one per file in the same order",
                                     options.case_files.size(), options.data_files.size()));
    std::vector<InstrumentSeries> all;
    for (std::size_t i = 0; i < options.data_files.size(); ++i) {
        const auto& case_file =
            options.case_files.size() == 1 ? options.case_files.front() : options.case_files[i];
        const std::string file = options.data_files[i].string();
        const Case read = read_case(case_file, options.overrides);
        if (geometry::is_eccentric(read.scene.instrument))
            throw UsageError(case_file.string() +
                             ": geometry.offset: data are fitted through a centred bob alone; "
                             "offset = \"0 mm\" takes it as centred");
        const rheometry::Conversion conversion =
            rheometry::conversion_for(read.scene.instrument, read.scene.conversion);
        const auto motion = geometry::rotates(read.scene.instrument)
                                ? rheometry::DriveMotion::turning
                                : rheometry::DriveMotion::sliding;
        rheometry::MeasuredData data = rheometry::read_measured_data(options.data_files[i], motion);
        for (const std::string& remark : data.remarks)
            tell(fmt::format("{}: {}", file, remark));
        warn_of_export(file, data.geometry, read.scene.instrument);
        for (rheometry::MeasuredStep& step : data.steps) {
            std::string name = options.data_files[i].stem().string();
            if (!step.name.empty())
                name = fmt::format("{}: {}", name, step.name);
            if (options.curve && name.find(*options.curve) == std::string::npos)
                continue;
            if (!step.is_flow_curve) {
                tell(fmt::format("{}: left out: a start-up at one speed is no flow curve", name));
                continue;
            }
            const bool is_stepped =
                std::holds_alternative<rheometry::Steps>(read.scene.protocol.program);
            all.push_back({.name = std::move(name),
                           .scene = read.scene,
                           .conversion = conversion,
                           // Speeds that jump and are held are no ramp through the rows.
                           .times = is_stepped ? std::vector<double>{} : std::move(step.time),
                           .speeds = std::move(step.speed),
                           .torques = std::move(step.torque),
                           .lines = std::move(step.lines),
                           .regimes = std::move(step.regimes),
                           .is_flow_curve = true});
        }
    }
    if (all.empty())
        throw UsageError(options.curve
                             ? fmt::format("--curve: no step's name holds \"{}\"", *options.curve)
                             : "the data hold no flow curve");
    return all;
}

void add_series(PreparedSeries& prepared, const InstrumentSeries& series,
                const fit::Selection& selection) {
    through::Measurement measurement{
        .instrument = series.scene.instrument,
        .end_factors = {std::holds_alternative<geometry::Box>(series.scene.instrument)
                            ? 1.0
                            : series.conversion.end_factor},
        .speeds = {},
        .torques = {}};
    through::RunHistory run{{series.times, series.speeds}, series.torques, {}};
    const bool has_history = through::has_history(run.rows);
    if (!has_history && !series.times.empty())
        prepared.remarks.push_back(fmt::format(
            "{}: the times do not increase from row to row: the fluid's inertia is not looked at",
            series.name));
    std::vector<fit::MeasuredPoint> points;
    for (std::size_t k = 0; k < series.speeds.size(); ++k)
        points.push_back({.rate = series.conversion.shear_rate(series.speeds[k]),
                          .stress = series.conversion.shear_stress(series.torques[k]),
                          .deviation = std::numeric_limits<double>::quiet_NaN(),
                          .line = k + 1,
                          .regime = deciding_regime(series, k, has_history)});
    fit::FlowData usable = fit::select_points(points, selection);
    for (fit::ExcludedPoint& each : usable.excluded) {
        each.point.line = series.line(each.point.line - 1);
        prepared.excluded.push_back(std::move(each));
    }
    // In the order of the run.
    std::ranges::sort(usable.lines);
    for (const std::size_t line : usable.lines) {
        const std::size_t row = line - 1;
        fit::MeasuredPoint point = points[row];
        point.line = series.line(row);
        prepared.points.push_back(std::move(point));
        measurement.speeds.push_back(std::abs(series.speeds[row]));
        measurement.torques.push_back(std::abs(series.torques[row]));
        run.used.push_back(row);
    }
    for (const std::string& remark : usable.remarks)
        if (remark.find("carry lag") != std::string::npos)
            prepared.remarks.push_back(remark);
    if (measurement.speeds.empty())
        return;
    prepared.measurements.push_back(std::move(measurement));
    prepared.runs.push_back(std::move(run));
    prepared.series.push_back(&series);
}

} // namespace searle::app
