#include "app/model_free.hpp"

#include "rheometry/correction/rotor_rate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace searle::app {
namespace {

namespace through = solvers::fit_instrument;

/// Quantile of the normal distribution for a 95 % band.
constexpr double normal_quantile = 1.959964;

ModelFreeRecord inversion_of(const InstrumentSeries& series, const through::Measurement& measured,
                             const through::RunHistory& run) {
    // The inversion wants the stress of the endless bob: c_L of each row is taken out here.
    const double reference = series.conversion.end_factor;
    std::vector<double> torques;
    for (std::size_t k = 0; k < measured.torques.size(); ++k) {
        const double own = measured.end_factors.size() == 1 ? measured.end_factors.front()
                                                            : measured.end_factors[k];
        const double added = measured.added_torques.empty() ? 0.0 : measured.added_torques[k];
        torques.push_back((measured.torques[k] - added) * reference / own);
    }
    const rheometry::RotorRates found =
        rheometry::rotor_rates(series.scene.instrument, reference, measured.speeds, torques);
    ModelFreeRecord record;
    record.series = series.name;
    record.yield_stress = found.rates.yield_stress;
    record.yield_standard_error = found.rates.yield_standard_error;
    for (std::size_t k = 0; k < torques.size(); ++k) {
        const rheometry::WallRate& rate = found.rates.rows[k];
        const double width = std::exp(normal_quantile * rate.standard_error / rate.rate);
        record.rows.push_back({.line = series.line(run.used[k]),
                               .speed = measured.speeds[k],
                               .stress = found.stresses[k],
                               .rate = rate.rate,
                               .low = rate.rate / width,
                               .high = rate.rate * width,
                               .branch = rate.branch,
                               .law_rate = std::numeric_limits<double>::quiet_NaN()});
    }
    return record;
}

/// The law's rate at the rotor at each row's speed: at the stress that the fitted torque has there.
/// @param first  of the rows in the fit
void set_law_rates(ModelFreeRecord& inversion, const fit::Model& law, const fit::FitResult& result,
                   const through::Measurement& measured, std::size_t first) {
    std::vector<double> values = result.values();
    values.resize(law.size());
    for (std::size_t k = 0; k < inversion.rows.size(); ++k) {
        const double added = measured.added_torques.empty() ? 0.0 : measured.added_torques[k];
        const double stress = inversion.rows[k].stress * (result.fitted[first + k] - added) /
                              (measured.torques[k] - added);
        inversion.rows[k].law_rate = law.rate(values, stress);
    }
}

std::optional<fit::RampLoop> loop_of(const InstrumentSeries& series,
                                     const std::vector<double>& inertia) {
    if (inertia.size() != series.speeds.size())
        return std::nullopt;
    std::vector<double> rates;
    std::vector<double> stresses;
    std::vector<double> inertial;
    for (std::size_t k = 0; k < inertia.size(); ++k) {
        // A ramp from rest or to rest has rows without speed.
        if (!(series.speeds[k] > 0.0))
            continue;
        rates.push_back(series.conversion.shear_rate(series.speeds[k]));
        stresses.push_back(series.conversion.shear_stress(series.torques[k]));
        inertial.push_back(series.conversion.shear_stress(inertia[k]));
    }
    return fit::ramp_loop(rates, stresses, inertial);
}

} // namespace

void add_model_free(CurveRecord& record, const fit::Model& law, const through::InstrumentFit& done,
                    const PreparedSeries& prepared) {
    for (const LawRecord& other : record.laws)
        if (other.result.criteria.aicc <= done.result.criteria.aicc)
            return;
    record.model_free.clear();
    record.loops.clear();
    std::size_t first = 0;
    for (std::size_t m = 0; m < prepared.series.size(); ++m) {
        const InstrumentSeries& series = *prepared.series[m];
        through::Measurement measured = done.measurements[m];
        for (const through::ComputedEnds& ends : done.ends)
            if (ends.measurement == m)
                measured.end_factors = ends.values;
        ModelFreeRecord inversion = inversion_of(series, measured, prepared.runs[m]);
        set_law_rates(inversion, law, done.result, measured, first);
        first += inversion.rows.size();
        record.model_free.push_back(std::move(inversion));
        if (m < done.inertia.size())
            if (const auto loop = loop_of(series, done.inertia[m]))
                record.loops.push_back({series.name, *loop});
    }
}

std::vector<std::string> loop_warnings(const CurveRecord& record) {
    std::vector<std::string> warnings;
    for (const LoopRecord& each : record.loops) {
        const fit::RampLoop& loop = each.loop;
        const std::string areas = fmt::format(
            "the ways up and down enclose {:.3g} Pa/s, of which the fluid's inertia is {:.3g}",
            loop.measured, loop.inertial);
        if (std::abs(loop.rest()) > 3.0 * loop.standard_error)
            warnings.push_back(fmt::format(
                "{}; the rest, {:.3g} +- {:.2g} Pa/s, is thixotropy or another history of the "
                "sample: the law is a mean of both ways, and its intervals do not hold for it",
                areas, loop.rest(), loop.standard_error));
        else if (std::abs(loop.inertial) > 3.0 * loop.standard_error)
            warnings.push_back(
                fmt::format("{}; the rest, {:.2g} +- {:.2g} Pa/s, is scatter: no thixotropy shows",
                            areas, loop.rest(), loop.standard_error));
    }
    return warnings;
}

} // namespace searle::app
