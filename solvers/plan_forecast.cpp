#include "solvers/plan_forecast.hpp"

#include "rheometry/schedule.hpp"
#include "solvers/plan_lag.hpp"
#include "solvers/plan_steady_curve.hpp"
#include "solvers/regime.hpp"
#include "solvers/stability/taylor_threshold.hpp"
#include "solvers/stability/threshold_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace searle::solvers {
namespace {

using Schedule = std::variant<rheometry::SteadySpeeds, rheometry::SpeedHistory>;

std::vector<double> row_speeds(const Schedule& schedule) {
    if (const auto* series = std::get_if<rheometry::SteadySpeeds>(&schedule)) {
        return series->speeds;
    }
    const auto& history = std::get<rheometry::SpeedHistory>(schedule);
    std::vector<double> speeds;
    speeds.reserve(history.row_times.size());
    for (const double time : history.row_times) {
        speeds.push_back(history.speed_at(time));
    }
    return speeds;
}

/// Every speed that a steady flow will be asked for: of the rows, and where the history bends.
std::vector<double> visited_speeds(const Schedule& schedule, const std::vector<double>& rows) {
    std::vector<double> speeds = rows;
    if (const auto* history = std::get_if<rheometry::SpeedHistory>(&schedule)) {
        speeds.push_back(history->initial_speed);
        for (const rheometry::SpeedHistory::Piece& piece : history->pieces) {
            speeds.push_back(piece.start_speed);
            speeds.push_back(piece.end_speed);
        }
    }
    return speeds;
}

/// The sheared layer of the gap that decides about vortices: the one outside the bob or rotor.
class Layer {
public:
    Layer(const InstrumentGap& gap, const Fluid& fluid, const GapState& state)
        : gap_(gap), fluid_(fluid), state_(state) {
        if (gap.plane_width > 0.0) {
            return;
        }
        depth_ = std::log1p(gap.annulus.width() / gap.annulus.inner_radius);
        const double yield = laws::flow::yield_stress(fluid.law);
        if (yield > 0.0) {
            const double excess = std::visit(
                [&](const auto& law) { return double{law.excess_stress(state.inner_rate)}; },
                fluid.law);
            const double sheared = 0.5 * std::log1p(excess / yield);
            partly_sheared_ = sheared < depth_;
            depth_ = std::min(depth_, sheared);
        }
    }

    [[nodiscard]] bool partly_sheared() const { return partly_sheared_; }
    /// Width over the inner radius.
    [[nodiscard]] double relative_width() const { return std::expm1(depth_); }
    [[nodiscard]] double outer_radius() const {
        return partly_sheared_ ? gap_.annulus.inner_radius * std::exp(depth_)
                               : gap_.annulus.outer_radius;
    }
    /// The viscosity that vortices are judged with, over the density: eta^(3/4) (d tau / d
    /// gamma)^(1/4) at the inner wall; for a fluid that thickens the smallest such value in the
    /// layer. Docs/plan.md has what this rests on.
    [[nodiscard]] double kinematic_viscosity(bool may_thicken) const {
        double smallest = viscosity_at(state_.inner_stress, state_.inner_rate);
        if (may_thicken) {
            for (const double depth : {0.25 * depth_, 0.5 * depth_, 0.75 * depth_, depth_}) {
                const double stress = state_.inner_stress * std::exp(-2.0 * depth);
                const double rate = laws::flow::rate(fluid_.law, stress);
                if (rate > 0.0) {
                    smallest = std::min(smallest, viscosity_at(stress, rate));
                }
            }
        }
        return smallest / fluid_.density;
    }

private:
    [[nodiscard]] double viscosity_at(double stress, double rate) const {
        const double slope =
            std::visit([rate](const auto& law) { return double{law.log_slope(rate)}; }, fluid_.law);
        return stress / rate * std::sqrt(std::sqrt(slope));
    }

    const InstrumentGap& gap_;
    const Fluid& fluid_;
    const GapState& state_;
    double depth_{};
    bool partly_sheared_{};
};

/// True when the viscosity rises with the rate at some of the rates between two bounds.
bool thickens(const laws::flow::AnyFlowLaw& law) {
    for (double rate = 1e-12; rate < 1e13; rate *= 10.0) {
        const double slope =
            std::visit([rate](const auto& chosen) { return double{chosen.log_slope(rate)}; }, law);
        if (slope > 1.0 + 1e-9) {
            return true;
        }
    }
    return false;
}

std::string taylor_basis(const Scene& scene) {
    std::string text;
    if (std::holds_alternative<laws::flow::Newtonian>(scene.fluid.law)) {
        text = "Exact linear stability of the steady flow of this Newtonian fluid";
    } else {
        text = "An estimate: the exact threshold of a Newtonian fluid, with Re taken with the "
               "viscosity eta^(3/4) (d tau / d gamma)^(1/4) at the bob's wall, which errs on the "
               "early side: for power-law fluids by up to 6 % in narrow gaps, by more in wide ones";
        if (laws::flow::yield_stress(scene.fluid.law) > 0.0) {
            text += "; where the gap is partly sheared, for the sheared layer alone";
        }
    }
    if (std::holds_alternative<geometry::DoubleGap>(scene.instrument)) {
        text += "; for the outer gap: the inner one, whose outer wall turns, is stable after "
                "Rayleigh";
    }
    if (std::holds_alternative<geometry::DinBob>(scene.instrument)) {
        text += "; of the cylindrical part, endless: flow at the bob's ends sets in before and "
                "blurs the onset";
    }
    return text + ".";
}

/// Fills in what concerns vortices, row by row.
class TaylorForecast {
public:
    TaylorForecast(const InstrumentGap& gap, const laws::flow::AnyFlowLaw& law)
        : gap_(gap), newtonian_(std::holds_alternative<laws::flow::Newtonian>(law)),
          may_thicken_(thickens(law)),
          relative_gap_(gap.annulus.width() / gap.annulus.inner_radius),
          threshold_(stability::taylor_threshold(relative_gap_)) {}

    void add(RowForecast& row, RowFacts& facts, const Layer& layer) {
        const double viscosity = layer.kinematic_viscosity(may_thicken_);
        const double tip_speed = std::abs(row.speed) * gap_.annulus.inner_radius;
        facts.reynolds = tip_speed * gap_.annulus.width() / viscosity;
        facts.end_reynolds = tip_speed * gap_.annulus.inner_radius / viscosity;
        double critical = threshold_.reynolds;
        double reynolds = facts.reynolds;
        if (layer.partly_sheared()) {
            if (!layers_) {
                layers_.emplace(relative_gap_);
            }
            critical = layers_->critical_reynolds(layer.relative_width());
            reynolds = facts.end_reynolds * layer.relative_width();
        }
        row.taylor_ratio = reynolds / critical;
        largest_reynolds_ = std::max(largest_reynolds_, facts.reynolds);
        largest_ratio_ = std::max(largest_ratio_, row.taylor_ratio);
        if (row.taylor_ratio > 1.0 || (newtonian_ && row.taylor_ratio > 0.0)) {
            const double at_onset =
                std::abs(row.shear_rate) / (newtonian_ ? row.taylor_ratio : 1.0);
            onset_shear_rate_ = std::min(onset_shear_rate_, at_onset);
        }
    }

    [[nodiscard]] TaylorOnset result(std::string basis) const {
        TaylorOnset onset{.critical_reynolds = threshold_.reynolds,
                          .reynolds = largest_reynolds_,
                          .wave_number = threshold_.wave_number,
                          .largest_ratio = largest_ratio_,
                          .onset_shear_rate = {},
                          .basis = std::move(basis)};
        if (std::isfinite(onset_shear_rate_)) {
            onset.onset_shear_rate = onset_shear_rate_;
        }
        return onset;
    }

private:
    const InstrumentGap& gap_;
    bool newtonian_;
    bool may_thicken_;
    double relative_gap_;
    stability::TaylorThreshold threshold_;
    std::optional<stability::ThresholdCurve> layers_;
    double largest_reynolds_ = 0.0;
    double largest_ratio_ = 0.0;
    double onset_shear_rate_ = std::numeric_limits<double>::infinity();
};

} // namespace

double end_flow_share(double radius_ratio, double length_ratio, double reynolds) {
    // M / M_creeping - 1 of the ISO bob: Re^2 at first, Re^0.8 where boundary layers form.
    constexpr double slow = 9.7e-7;
    constexpr double turning_point = 185.0;
    constexpr double exponent = 0.6;
    const double iso = slow * reynolds * reynolds /
                       std::pow(1.0 + std::pow(reynolds / turning_point, 2), exponent);
    // The torque of the cylinder over that of the ISO one, both over R^3.
    constexpr double iso_ratio = 1.0847;
    constexpr double iso_length = 3.0;
    const auto narrowness = [](double ratio) { return 1.0 - 1.0 / (ratio * ratio); };
    const double cylinder =
        length_ratio / iso_length * narrowness(iso_ratio) / narrowness(radius_ratio);
    const double extra = iso / cylinder;
    return extra / (1.0 + extra);
}

Forecast forecast(const Scene& scene) {
    Forecast result;
    result.conversion = rheometry::conversion_for(scene.instrument, scene.conversion);
    const Schedule schedule = rheometry::schedule(scene.protocol, result.conversion);
    const std::vector<double> speeds = row_speeds(schedule);
    SteadyCurve curve(scene.instrument, scene.fluid, visited_speeds(schedule, speeds));
    result.steady_series = std::holds_alternative<rheometry::SteadySpeeds>(schedule);

    std::vector<double> times;
    std::vector<LagForecast> lags(speeds.size());
    if (const auto* history = std::get_if<rheometry::SpeedHistory>(&schedule)) {
        times = history->row_times;
        lags = forecast_lag(*history, curve);
    } else {
        times = settling_times(curve, 0.0, speeds, scene.solver.accuracy);
    }

    const bool has_ends = geometry::has_ends(scene.instrument);
    const double end_factor = has_ends ? result.conversion.end_factor : 1.0;
    const InstrumentGap& decisive = curve.gaps().back();
    const bool is_plane = decisive.plane_width > 0.0;
    std::optional<TaylorForecast> vortices;
    if (!is_plane) {
        vortices.emplace(decisive, scene.fluid.law);
    }

    result.rows.resize(speeds.size());
    result.facts.resize(speeds.size());
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        RowForecast& row = result.rows[i];
        RowFacts& facts = result.facts[i];
        row.time = times[i];
        row.speed = speeds[i];
        row.shear_rate = result.conversion.shear_rate(row.speed);
        row.lag_share = lags[i].share;
        facts.largest_lag = lags[i].largest;
        if (row.speed != 0.0) {
            const SteadyState& state = curve.at(row.speed);
            row.steady_stress =
                std::copysign(result.conversion.shear_stress(state.torque * end_factor), row.speed);
            for (std::size_t g = 0; g < curve.gaps().size(); ++g) {
                const Layer layer(curve.gaps()[g], scene.fluid, state.gaps[g]);
                facts.partly_sheared = facts.partly_sheared || layer.partly_sheared();
                if (g + 1 < curve.gaps().size()) {
                    continue;
                }
                facts.rotor_wall_rate = state.gaps[g].inner_rate;
                if (is_plane) {
                    facts.reynolds = std::abs(row.speed) * decisive.plane_width /
                                     layer.kinematic_viscosity(false);
                } else {
                    facts.yield_radius = layer.outer_radius();
                    vortices->add(row, facts, layer);
                }
            }
            if (has_ends) {
                const double radius = decisive.annulus.inner_radius;
                const double height =
                    decisive.torque_per_stress / (2.0 * std::numbers::pi * radius * radius);
                facts.end_flow_share = end_flow_share(decisive.annulus.outer_radius / radius,
                                                      height / radius, facts.end_reynolds);
                row.end_flow_share = facts.end_flow_share;
            }
            facts.definition_error =
                std::abs(row.steady_stress) /
                    laws::flow::stress(scene.fluid.law, std::abs(row.shear_rate)) -
                1.0;
        }
        row.regime = regime_name({.speed = row.speed,
                                  .partly_sheared = facts.partly_sheared,
                                  .taylor_ratio = row.taylor_ratio,
                                  .lag_share = row.lag_share,
                                  .end_flow_share = facts.end_flow_share,
                                  .accuracy = scene.solver.accuracy});
    }
    if (vortices) {
        result.taylor = vortices->result(taylor_basis(scene));
    }
    return result;
}

} // namespace searle::solvers
