#include "solvers/fit_instrument/fit_instrument.hpp"

#include "rheometry/conversion/conversion.hpp"
#include "rheometry/fit/warnings.hpp"
#include "solvers/fit_instrument/end_factors.hpp"

#include <algorithm>
#include <cmath>
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
/// Where the expansion of ln c_L foresees a larger change than this, c_L is solved again.
constexpr double largest_foreseen = 5e-3;
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

/// Largest change of ln c_L that the expansion foresees; infinite where there is none yet.
double foreseen_change(const Measurement& measurement, std::span<const double> search) {
    if (measurement.end_factor_slopes.empty())
        return std::numeric_limits<double>::infinity();
    double largest = 0.0;
    for (std::size_t row = 0; row < measurement.speeds.size(); ++row) {
        double change = 0.0;
        for (std::size_t i = 0; i < search.size(); ++i)
            change += measurement.end_factor_slopes[row * search.size() + i] *
                      (search[i] - measurement.end_factor_search[i]);
        largest = std::max(largest, std::abs(change));
    }
    return largest;
}

/// Solves the ends of the DIN bobs again where the law has moved. Returns whether any was.
bool update_ends(const fit::Model& law, std::span<const double> search,
                 std::vector<Measurement>& measurements, const InstrumentEffects& effects,
                 std::vector<ComputedEnds>& ends) {
    bool updated = false;
    for (std::size_t m = 0; m < measurements.size(); ++m) {
        Measurement& measurement = measurements[m];
        const auto* bob = std::get_if<geometry::DinBob>(&measurement.instrument);
        if (bob == nullptr || foreseen_change(measurement, search) <= largest_foreseen)
            continue;
        EndFactors found = end_factors_of(*bob, law, search, measurement.speeds,
                                          end_factor_accuracy, effects.progress);
        std::erase_if(ends, [m](const ComputedEnds& old) { return old.measurement == m; });
        ends.push_back({.measurement = m,
                        .values = found.values,
                        .relative_error = found.relative_error,
                        .solutions = found.solutions,
                        .reached = found.reached,
                        .stand_in = {}});
        measurement.end_factors = std::move(found.values);
        measurement.end_factor_slopes = std::move(found.slopes);
        measurement.end_factor_search = std::move(found.search);
        updated = true;
    }
    return updated;
}

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
void settle(const fit::Model& law, Search& search, const InstrumentEffects& effects,
            InstrumentFit& done) {
    for (; done.rounds < most_rounds; ++done.rounds) {
        const std::vector<double> values = done.result.values();
        const auto solver_law = law.for_solvers(std::span(values).first(law.size()));
        bool stands = true;
        if (effects.ends)
            stands = !update_ends(law, law_search(law, done.result), search.measurements(), effects,
                                  done.ends);
        if (solver_law &&
            update_inertia(*solver_law, search.measurements(), effects, done.inertia) > standing)
            stands = false;
        if (stands)
            return;
        done.result = search.fit_from(done.result.values(), false);
    }
}

/// c_L at the fitted parameters, with the change since it was solved.
void note_final_ends(const InstrumentFit& done, const fit::Model& law,
                     const std::vector<Measurement>& measurements,
                     std::vector<ComputedEnds>& ends) {
    const std::vector<double> search = law_search(law, done.result);
    for (ComputedEnds& each : ends) {
        const Measurement& measurement = measurements[each.measurement];
        for (std::size_t row = 0; row < each.values.size(); ++row) {
            double change = 0.0;
            for (std::size_t i = 0; i < law.size() && !measurement.end_factor_slopes.empty(); ++i)
                change += measurement.end_factor_slopes[row * law.size() + i] *
                          (search[i] - measurement.end_factor_search[i]);
            each.values[row] = measurement.end_factors[row] * std::exp(change);
        }
    }
}

} // namespace

InstrumentFit fit_through(const fit::Model& law, const std::vector<Measurement>& measurements,
                          const fit::FlowData& converted, const fit::FitOptions& options, bool slip,
                          const InstrumentEffects& effects) {
    InstrumentFit done;
    done.conventional = fit::fit_flow_curve(law, converted, options);
    Search search(law, measurements, converted, options, slip);
    if (law.for_solvers(done.conventional->values())) {
        done.result = search.fit_from(done.conventional->values(), false);
        settle(law, search, effects, done);
    } else if (effects.ends || !effects.history.empty()) {
        // Ends and inertia hardly depend on how a curve is written: those of the Herschel-Bulkley
        // law through the same torques stand in.
        const fit::Model& known = *fit::model_named("herschel-bulkley");
        fit::FitOptions free = options;
        free.bounds.clear();
        free.profile_intervals = false;
        const fit::FitResult start = fit::fit_flow_curve(known, converted, free);
        Search stand_in(known, measurements, converted, free, slip);
        done.result = stand_in.fit_from(start.values(), false);
        settle(known, stand_in, effects, done);
        note_final_ends(done, known, stand_in.measurements(), done.ends);
        for (Measurement& measurement : stand_in.measurements())
            measurement.end_factor_slopes.clear();
        for (ComputedEnds& each : done.ends) {
            each.stand_in = known.name;
            stand_in.measurements()[each.measurement].end_factors = each.values;
        }
        search.measurements() = stand_in.measurements();
        done.result = search.fit_from(done.conventional->values(), false);
    } else {
        done.result = search.fit_from(done.conventional->values(), false);
    }
    done.result = search.fit_from(done.result.values(), true);
    if (law.for_solvers(done.conventional->values()))
        note_final_ends(done, law, search.measurements(), done.ends);
    done.measurements = search.measurements();
    fit::add_parameter_warnings(done.result);
    return done;
}

} // namespace searle::solvers::fit_instrument
