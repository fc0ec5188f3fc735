#include "solvers/fit_instrument/fit_instrument.hpp"

#include "rheometry/fit/warnings.hpp"

#include <algorithm>
#include <cmath>

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

} // namespace

InstrumentFit fit_through(const fit::Model& law, const std::vector<Measurement>& measurements,
                          const fit::FlowData& converted, const fit::FitOptions& options,
                          bool slip) {
    InstrumentFit done;
    done.conventional = fit::fit_flow_curve(law, converted, options);

    // The converted curve bounds where the law's parameters can be; a wide gap and its plug shift
    // them, but not by orders of magnitude.
    std::vector<fit::Parameter> parameters = fit::bounded_parameters(
        law, fit::scale_of(converted.rates, converted.stresses), options, true);
    std::vector<std::vector<double>> starts{done.conventional->values()};
    if (slip) {
        const double largest = largest_slip(measurements, converted.stresses.front());
        parameters.push_back({.key = "slip_coefficient",
                              .unit = "m/(Pa.s)",
                              .transform = fit::Transform::identity,
                              .low = 0.0,
                              .high = largest,
                              .low_is_physical = true});
        starts = with_slip(starts.front(), largest);
    }
    const InstrumentForward forward(law, measurements, slip);
    std::vector<double> torques;
    for (const Measurement& measurement : measurements)
        torques.insert(torques.end(), measurement.torques.begin(), measurement.torques.end());
    done.result = fit::fit_forward(forward, torques, {}, parameters, starts, options);
    done.result.model = law.name;
    fit::add_parameter_warnings(done.result);
    return done;
}

} // namespace searle::solvers::fit_instrument
