#include "solvers/plan_vortices.hpp"

#include "solvers/stability/onset_curve.hpp"
#include "solvers/stability/taylor_threshold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::solvers {
namespace {

/// Asked of the linear problem: far below what sets in at the onset of an instrument.
constexpr double onset_tolerance = 1e-4;
/// Past so many times the onset, where flow is turbulent, the critical Reynolds number is no longer
/// followed; where to look by the estimate, which errs on the early side.
constexpr double far_past = 20.0;
constexpr double far_past_by_estimate = 100.0;

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

std::string where(const geometry::Instrument& instrument) {
    if (std::holds_alternative<geometry::DoubleGap>(instrument)) {
        return "; for the outer gap: the inner one, whose outer wall turns, is stable after "
               "Rayleigh";
    }
    if (std::holds_alternative<geometry::DinBob>(instrument)) {
        return "; of the cylindrical part, endless: flow at the bob's ends sets in before and "
               "blurs the onset";
    }
    return "";
}

} // namespace

Layer::Layer(const InstrumentGap& gap, const Fluid& fluid, const GapState& state)
    : gap_(gap), fluid_(fluid), state_(state) {
    if (gap.plane_width > 0.0) {
        return;
    }
    depth_ = std::log1p(gap.annulus.width() / gap.annulus.inner_radius);
    const double yield = laws::flow::yield_stress(fluid.law);
    if (yield > 0.0) {
        const double excess =
            std::visit([&](const auto& law) { return double{law.excess_stress(state.inner_rate)}; },
                       fluid.law);
        const double sheared = 0.5 * std::log1p(excess / yield);
        partly_sheared_ = sheared < depth_;
        depth_ = std::min(depth_, sheared);
    }
}

double Layer::relative_width() const { return std::expm1(depth_); }

double Layer::outer_radius() const {
    return partly_sheared_ ? gap_.annulus.inner_radius * std::exp(depth_)
                           : gap_.annulus.outer_radius;
}

double Layer::kinematic_viscosity(bool may_thicken) const {
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

double Layer::wall_kinematic_viscosity() const {
    return state_.inner_stress / state_.inner_rate / fluid_.density;
}

double Layer::viscosity_at(double stress, double rate) const {
    const double slope =
        std::visit([rate](const auto& law) { return double{law.log_slope(rate)}; }, fluid_.law);
    return stress / rate * std::sqrt(std::sqrt(slope));
}

VortexForecast::VortexForecast(const InstrumentGap& gap, const Fluid& fluid)
    : gap_(gap), fluid_(fluid),
      newtonian_(std::holds_alternative<laws::flow::Newtonian>(fluid.law)),
      may_thicken_(thickens(fluid.law)),
      relative_gap_(gap.annulus.width() / gap.annulus.inner_radius) {}

void VortexForecast::add(std::size_t index, const RowForecast& row, RowFacts& facts,
                         const Layer& layer) {
    const double viscosity = layer.kinematic_viscosity(may_thicken_);
    const double speed = std::abs(row.speed);
    const double tip_speed = speed * gap_.annulus.inner_radius;
    facts.reynolds = tip_speed * gap_.annulus.width() / viscosity;
    facts.end_reynolds = tip_speed * gap_.annulus.inner_radius / viscosity;
    double critical = stability::taylor_threshold(relative_gap_).reynolds;
    double reynolds = facts.reynolds;
    if (layer.partly_sheared()) {
        if (!layers_) {
            layers_.emplace(relative_gap_);
        }
        critical = layers_->critical_reynolds(layer.relative_width());
        reynolds = facts.end_reynolds * layer.relative_width();
    }
    seen_.push_back(
        {.index = index,
         .speed = speed,
         .wall_reynolds = tip_speed * gap_.annulus.width() / layer.wall_kinematic_viscosity(),
         .estimate = reynolds / critical});
}

double VortexForecast::energy_ratio(double speed) const {
    return stability::energy_ratio(gap_.annulus, fluid_.law, speed, fluid_.density);
}

double VortexForecast::slowest_doubtful(double slowest, double fastest) const {
    if (energy_ratio(slowest) > 1.0) {
        return slowest;
    }
    // Strides counted from the fastest speed, so that slower rows do not move the answer.
    constexpr double stride = 0.1;
    int doubtful = 0;
    int stable = static_cast<int>(std::ceil(std::log(fastest / slowest) / stride));
    while (stable - doubtful > 1) {
        const int middle = (stable + doubtful) / 2;
        (energy_ratio(fastest * std::exp(-stride * middle)) > 1.0 ? doubtful : stable) = middle;
    }
    return fastest * std::exp(-stride * doubtful);
}

std::string VortexForecast::judge_by_linear_theory(std::vector<RowForecast>& rows,
                                                   std::vector<RowFacts>& facts,
                                                   TaylorOnset& onset) const {
    const auto by_speed = [](const Seen& a, const Seen& b) { return a.speed < b.speed; };
    double fastest = std::ranges::max_element(seen_, by_speed)->speed;
    const double slowest =
        slowest_doubtful(std::ranges::min_element(seen_, by_speed)->speed, fastest);
    const Seen* far = nullptr;
    for (const Seen& row : seen_) {
        if (row.estimate > far_past_by_estimate && row.speed > slowest &&
            (far == nullptr || row.speed < far->speed)) {
            far = &row;
        }
    }
    if (far != nullptr &&
        far->wall_reynolds >
            far_past * stability::layer_onset(gap_.annulus, fluid_.law, far->speed, onset_tolerance)
                           .reynolds) {
        fastest = far->speed;
    }
    const stability::OnsetCurve curve(gap_.annulus, fluid_.law, slowest, fastest, onset_tolerance);
    double speed_of_largest = fastest;
    double nearest_speed = fastest;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Seen& row : seen_) {
        facts[row.index].reynolds = row.wall_reynolds;
        const double ratio = row.wall_reynolds / curve.critical_reynolds(row.speed);
        rows[row.index].taylor_ratio = ratio;
        if (ratio > onset.largest_ratio) {
            onset.largest_ratio = ratio;
            onset.reynolds = row.wall_reynolds;
            onset.critical_reynolds = row.wall_reynolds / ratio;
            speed_of_largest = row.speed;
        }
        if (const double distance = std::abs(std::log(ratio)); distance < nearest) {
            nearest = distance;
            nearest_speed = row.speed;
        }
    }
    std::string text =
        "Linear stability of this fluid's own steady flow to axisymmetric vortices, their stress "
        "with the tangent viscosity in the direction of shear and the apparent one in all others; "
        "Re with the apparent viscosity at the bob's wall; ";
    const auto critical = stability::critical_speed(gap_.annulus, fluid_.law, fluid_.density,
                                                    nearest_speed, onset_tolerance);
    if (critical) {
        onset.wave_number = critical->onset.wave_number;
        onset.critical_speed = critical->speed;
        onset.relative_error = critical->relative_error;
        text += fmt::format("relative error {:.0e} of the onset", critical->relative_error);
    } else {
        const stability::LayerOnset there =
            stability::layer_onset(gap_.annulus, fluid_.law, speed_of_largest, onset_tolerance);
        onset.wave_number = there.wave_number;
        onset.relative_error = there.relative_error;
        text += "no speed within a factor of a thousand is the onset";
    }
    return text + fmt::format(", {:.0e} of the ratios", std::max(curve.relative_error(), 1e-9));
}

TaylorOnset VortexForecast::judge(const geometry::Instrument& instrument,
                                  std::vector<RowForecast>& rows, std::vector<RowFacts>& facts) {
    const stability::TaylorThreshold threshold = stability::taylor_threshold(relative_gap_);
    TaylorOnset onset{.critical_reynolds = threshold.reynolds,
                      .wave_number = threshold.wave_number,
                      .relative_error = threshold.relative_error,
                      .critical_speed = {},
                      .onset_shear_rate = {},
                      .basis = {}};
    const auto largest_energy_ratio = [&] {
        double largest = 0.0;
        const auto [slow, fast] = std::ranges::minmax_element(
            seen_, [](const Seen& a, const Seen& b) { return a.speed < b.speed; });
        for (const double speed : {slow->speed, fast->speed}) {
            largest = std::max(largest, energy_ratio(speed));
        }
        return largest;
    };
    const double energy = newtonian_ || seen_.empty() ? 0.0 : largest_energy_ratio();
    if (energy > 1.0) {
        onset.basis = judge_by_linear_theory(rows, facts, onset);
    } else {
        for (const Seen& row : seen_) {
            rows[row.index].taylor_ratio = row.estimate;
            onset.reynolds = std::max(onset.reynolds, facts[row.index].reynolds);
            onset.largest_ratio = std::max(onset.largest_ratio, row.estimate);
            if (newtonian_) {
                onset.critical_speed = row.speed / row.estimate;
            }
        }
        onset.basis =
            newtonian_
                ? "Exact linear stability of the steady flow of this Newtonian fluid"
                : fmt::format("No disturbance can grow at these speeds: the energy that one draws "
                              "from the flow is at most {:.2g} of what it dissipates (energy "
                              "method); the ratio is an estimate, with the threshold of a "
                              "Newtonian fluid and the viscosity eta^(3/4) (d tau / d gamma)^(1/4) "
                              "at the bob's wall",
                              energy);
    }
    onset.basis += where(instrument) + ".";
    return onset;
}

} // namespace searle::solvers
