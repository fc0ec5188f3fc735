#include "solvers/fit_instrument/fit_instrument.hpp"

#include "rheometry/conversion/conversion.hpp"
#include "rheometry/fit/warnings.hpp"
#include "solvers/fit_instrument/end_factors.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace searle::solvers::fit_instrument {
namespace {

namespace fit = rheometry::fit;

/// A slip this much faster than the walls would leave no shear at all.
double largest_slip(const std::vector<Measurement>& measurements, double lowest_stress) {
    double speed = 0.0;
    for (const Measurement& measurement : measurements)
        for (const double each : measurement.speeds)
            speed = std::max(speed, each);
    double radius = 0.0;
    for (const Measurement& measurement : measurements) {
        if (const auto* gap = std::get_if<geometry::ConcentricCylinders>(&measurement.instrument))
            radius = std::max(radius, gap->bob_radius);
        if (const auto* bob = std::get_if<geometry::DinBob>(&measurement.instrument))
            radius = std::max(radius, bob->bob_radius);
        if (const auto* gaps = std::get_if<geometry::DoubleGap>(&measurement.instrument))
            radius = std::max(radius, gaps->radii[3]);
    }
    return speed * radius / lowest_stress;
}

/// Starts for a law with slip: from hardly any to most of the motion.
std::vector<std::vector<double>> with_slip(const std::vector<double>& start, double largest) {
    std::vector<std::vector<double>> starts;
    for (const double share : {0.0, 1e-4, 1e-3, 1e-2}) {
        starts.push_back(start);
        starts.back().push_back(share * largest);
    }
    return starts;
}

/// Ends and inertia are found to a part of what scatter leaves of a law.
constexpr double end_factor_accuracy = 1e-3;
constexpr double inertia_accuracy = 1e-3;
/// Where the backbone of ln c_L has moved by more than this since the flow was solved, it is solved
/// again.
constexpr double largest_move = 1e-2;
/// Inertia below this share of every torque is left out.
constexpr double least_inertia = 2e-4;
/// Both stand when no torque moves by more than this.
constexpr double standing = 3e-4;
constexpr int most_rounds = 6;

/// One law sought through several instruments.
class Search {
public:
    Search(const fit::Model& law, const std::vector<Measurement>& measurements,
           const fit::FlowData& converted, const fit::FitOptions& options, bool slip)
        : law_(law), measurements_(measurements), options_(options), slip_(slip) {
        // The converted curve bounds where the law's parameters can be; a wide gap and its plug
        // shift them, but not by orders of magnitude.
        parameters_ = fit::bounded_parameters(
            law, fit::scale_of(converted.rates, converted.stresses), options, true);
        lowest_stress_ = converted.stresses.front();
        for (const Measurement& measurement : measurements)
            torques_.insert(torques_.end(), measurement.torques.begin(), measurement.torques.end());
    }

    std::vector<Measurement>& measurements() { return measurements_; }

    fit::FitResult fit_from(const std::vector<double>& values, bool intervals) const {
        std::vector<fit::Parameter> parameters = parameters_;
        std::vector<std::vector<double>> starts{values};
        if (slip_) {
            const double largest = largest_slip(measurements_, lowest_stress_);
            parameters.push_back({.key = "slip_coefficient",
                                  .unit = "m/(Pa.s)",
                                  .transform = fit::Transform::identity,
                                  .low = 0.0,
                                  .high = largest,
                                  .low_is_physical = true});
            starts = with_slip({values.begin(), values.begin() + law_size()}, largest);
            if (values.size() > law_.size())
                starts.push_back(values);
        }
        fit::FitOptions options = options_;
        options.profile_intervals = options_.profile_intervals && intervals;
        const InstrumentForward forward(law_, measurements_, slip_);
        fit::FitResult result =
            fit::fit_forward(forward, torques_, {}, parameters, starts, options);
        result.model = law_.name;
        return result;
    }

private:
    [[nodiscard]] std::ptrdiff_t law_size() const {
        return static_cast<std::ptrdiff_t>(law_.size());
    }

    const fit::Model& law_;
    std::vector<Measurement> measurements_;
    const fit::FitOptions& options_;
    bool slip_;
    std::vector<fit::Parameter> parameters_;
    double lowest_stress_{};
    std::vector<double> torques_;
};

std::vector<double> law_search(const fit::Model& law, const fit::FitResult& result) {
    return {result.search.begin(), result.search.begin() + static_cast<std::ptrdiff_t>(law.size())};
}

/// The ends of the measurements' bobs.
class Ends {
public:
    Ends(const std::vector<Measurement>& measurements, const InstrumentEffects& effects) {
        for (const Measurement& measurement : measurements) {
            const auto* bob = std::get_if<geometry::DinBob>(&measurement.instrument);
            bobs_.push_back(bob != nullptr && effects.ends
                                ? std::make_unique<BobEnds>(*bob, measurement.speeds,
                                                            end_factor_accuracy, effects.progress)
                                : nullptr);
        }
    }

    /// Sets c_L and its slopes for a law; solves the flow where that is due. Returns the largest
    /// relative change of a c_L against what the measurement had foreseen.
    /// @param solve  false: the backbone alone, for a first guess
    double update(const fit::Model& law, std::span<const double> search,
                  std::vector<Measurement>& measurements, bool solve) {
        double moved = 0.0;
        for (std::size_t m = 0; m < measurements.size(); ++m) {
            if (!bobs_[m])
                continue;
            Measurement& measurement = measurements[m];
            if (solve && bobs_[m]->change_since_solution(law, search) > largest_move)
                bobs_[m]->solve(law, search);
            EndFactors found = bobs_[m]->at(law, search);
            const std::vector<double> foreseen = foreseen_factors(measurement, search);
            for (std::size_t row = 0; row < foreseen.size(); ++row)
                moved = std::max(moved, std::abs(std::log(found.values[row] / foreseen[row])));
            measurement.end_factors = std::move(found.values);
            measurement.end_factor_slopes = std::move(found.slopes);
            measurement.end_factor_search = std::move(found.search);
        }
        return moved;
    }

    [[nodiscard]] std::vector<ComputedEnds> computed(const std::vector<Measurement>& measurements,
                                                     std::span<const double> search) const {
        std::vector<ComputedEnds> ends;
        for (std::size_t m = 0; m < measurements.size(); ++m)
            if (bobs_[m])
                ends.push_back({.measurement = m,
                                .values = foreseen_factors(measurements[m], search),
                                .relative_error = bobs_[m]->relative_error(),
                                .solutions = bobs_[m]->solutions(),
                                .reached = bobs_[m]->reached(),
                                .stand_in = {}});
        return ends;
    }

private:
    /// c_L as the measurement's expansion has it.
    static std::vector<double> foreseen_factors(const Measurement& measurement,
                                                std::span<const double> search) {
        std::vector<double> factors = measurement.end_factors;
        factors.resize(measurement.speeds.size(), factors.front());
        for (std::size_t row = 0; row < factors.size(); ++row) {
            double change = 0.0;
            for (std::size_t i = 0; i < search.size() && !measurement.end_factor_slopes.empty();
                 ++i)
                change += measurement.end_factor_slopes[row * search.size() + i] *
                          (search[i] - measurement.end_factor_search[i]);
            factors[row] *= std::exp(change);
        }
        return factors;
    }

    std::vector<std::unique_ptr<BobEnds>> bobs_;
};

double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// Largest share of inertia in a row's torque, estimated from the run itself.
double inertia_share(const Measurement& measurement, const RunHistory& run, double density) {
    std::vector<double> viscosities;
    const double stress_per_torque = rheometry::rotor_wall_stress_per_torque(
        measurement.instrument, mean(measurement.end_factors));
    const double rate_per_speed =
        rheometry::conversion_for(measurement.instrument, {}).rate_per_speed;
    for (std::size_t k = 0; k < run.torques.size(); ++k)
        viscosities.push_back(stress_per_torque * run.torques[k] /
                              (rate_per_speed * run.rows.speeds[k]));
    return largest_inertia_share(measurement.instrument, density, run.rows, viscosities);
}

/// Computes the inertia in the runs for a law. Returns the largest change of a row's torque, as a
/// share of it.
double update_inertia(const laws::flow::AnyFlowLaw& law, std::vector<Measurement>& measurements,
                      const InstrumentEffects& effects, std::vector<std::vector<double>>& inertia) {
    double moved = 0.0;
    inertia.resize(measurements.size());
    for (std::size_t m = 0; m < std::min(effects.history.size(), measurements.size()); ++m) {
        const RunHistory& run = effects.history[m];
        Measurement& measurement = measurements[m];
        if (!has_history(run.rows))
            continue;
        inertia[m].resize(run.rows.times.size());
        if (inertia_share(measurement, run, effects.density) < least_inertia)
            continue;
        const double end_factor = mean(measurement.end_factors);
        RampInertia found =
            ramp_inertia(measurement.instrument, law, effects.density, run.rows, inertia_accuracy);
        for (double& torque : found.torques)
            torque *= end_factor;
        inertia[m] = std::move(found.torques);
        measurement.added_torques.resize(measurement.speeds.size());
        for (std::size_t k = 0; k < measurement.speeds.size(); ++k) {
            const std::size_t row = run.used[k];
            // The measurement's rows all turn and resist the same way.
            const double added = std::copysign(1.0, run.rows.speeds[row]) * inertia[m][row];
            moved = std::max(moved, std::abs(added - measurement.added_torques[k]) /
                                        measurement.torques[k]);
            measurement.added_torques[k] = added;
        }
    }
    return moved;
}

/// Fits, and finds ends and inertia for what was fitted, until they stand.
/// @param start  the law's values, SI
void settle(const fit::Model& law, Search& search, const std::vector<double>& start,
            const InstrumentEffects& effects, InstrumentFit& done) {
    Ends ends(search.measurements(), effects);
    ends.update(law, law.search(start), search.measurements(), false);
    done.result = search.fit_from(start, false);
    for (; done.rounds < most_rounds; ++done.rounds) {
        const std::vector<double> values = done.result.values();
        double moved = ends.update(law, law_search(law, done.result), search.measurements(), true);
        if (const auto solver_law = law.for_solvers(std::span(values).first(law.size())))
            moved = std::max(
                moved, update_inertia(*solver_law, search.measurements(), effects, done.inertia));
        if (moved <= standing)
            break;
        done.result = search.fit_from(values, false);
    }
    done.ends = ends.computed(search.measurements(), law_search(law, done.result));
}

} // namespace

InstrumentFit fit_through(const fit::Model& law, const std::vector<Measurement>& measurements,
                          const fit::FlowData& converted, const fit::FitOptions& options, bool slip,
                          const InstrumentEffects& effects) {
    InstrumentFit done;
    done.conventional = fit::fit_flow_curve(law, converted, options);
    Search search(law, measurements, converted, options, slip);
    const std::vector<double> start = done.conventional->values();
    if (law.for_solvers(start)) {
        settle(law, search, start, effects, done);
    } else if (effects.ends || !effects.history.empty()) {
        // Ends and inertia hardly depend on how a curve is written: those of the Herschel-Bulkley
        // law through the same torques stand in.
        const fit::Model& known = *fit::model_named("herschel-bulkley");
        fit::FitOptions free = options;
        free.bounds.clear();
        free.profile_intervals = false;
        Search stand_in(known, measurements, converted, free, slip);
        settle(known, stand_in, fit::fit_flow_curve(known, converted, free).values(), effects,
               done);
        search.measurements() = stand_in.measurements();
        for (Measurement& measurement : search.measurements())
            measurement.end_factor_slopes.clear();
        for (ComputedEnds& each : done.ends) {
            each.stand_in = known.name;
            search.measurements()[each.measurement].end_factors = each.values;
        }
        done.result = search.fit_from(start, false);
    } else {
        done.result = search.fit_from(start, false);
    }
    done.result = search.fit_from(done.result.values(), true);
    done.measurements = search.measurements();
    fit::add_parameter_warnings(done.result);
    return done;
}

} // namespace searle::solvers::fit_instrument
