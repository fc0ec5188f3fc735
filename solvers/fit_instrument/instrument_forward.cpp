#include "solvers/fit_instrument/instrument_forward.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace searle::solvers::fit_instrument {
namespace {

struct GapPart {
    radial::AnnularGap gap;
    double torque_per_stress{};
};

GapPart gap_part(double inner, double outer, double height) {
    return {{inner, outer}, 2.0 * std::numbers::pi * inner * inner * height};
}

/// The expansion of ln c_L about a law is not believed beyond this.
constexpr double largest_change = 0.15;

double added_torque(const std::vector<double>& added, std::size_t row) {
    return added.empty() ? 0.0 : added[row];
}

std::vector<GapPart> parts_of(const geometry::Instrument& instrument) {
    if (const auto* gap = std::get_if<geometry::ConcentricCylinders>(&instrument))
        return {gap_part(gap->bob_radius, gap->cup_radius, gap->height)};
    if (const auto* bob = std::get_if<geometry::DinBob>(&instrument))
        return {gap_part(bob->bob_radius, bob->cup_radius, bob->height())};
    if (const auto* gaps = std::get_if<geometry::DoubleGap>(&instrument))
        return {gap_part(gaps->radii[0], gaps->radii[1], gaps->height),
                gap_part(gaps->radii[2], gaps->radii[3], gaps->height)};
    return {};
}

} // namespace

InstrumentForward::InstrumentForward(const rheometry::fit::Model& law,
                                     const std::vector<Measurement>& measurements, bool slip)
    : law_(law), slip_(slip) {
    for (const Measurement& measurement : measurements) {
        Device device;
        device.speeds = measurement.speeds;
        device.end_factors = measurement.end_factors;
        device.end_factors.resize(measurement.speeds.size(), measurement.end_factors.front());
        device.end_factor_slopes = measurement.end_factor_slopes;
        device.end_factor_search = measurement.end_factor_search;
        device.added_torques = measurement.added_torques;
        for (const GapPart& part : parts_of(measurement.instrument))
            device.parts.push_back(
                {GapCurve(part.gap, measurement.speeds), part.torque_per_stress});
        if (const auto* box = std::get_if<geometry::Box>(&measurement.instrument)) {
            device.area = box->length * box->width;
            device.gap = box->gap;
        }
        size_ += device.speeds.size();
        devices_.push_back(std::move(device));
    }
}

double InstrumentForward::end_factor_change(const Device& device, std::size_t row,
                                            std::span<const double> search) const {
    double change = 0.0;
    const std::size_t count = law_.size();
    for (std::size_t i = 0; i < count && !device.end_factor_slopes.empty(); ++i)
        change +=
            device.end_factor_slopes[row * count + i] * (search[i] - device.end_factor_search[i]);
    return change;
}

bool InstrumentForward::predict_box(const Device& device, std::span<const double> search,
                                    std::span<double> values, std::span<double> jacobian) const {
    std::vector<double> rates;
    for (const double speed : device.speeds)
        rates.push_back(speed / device.gap);
    const std::size_t count = law_.size();
    std::vector<double> plain(jacobian.empty() ? 0 : rates.size() * count);
    law_.stresses(search.first(count), rates, values, plain);
    for (std::size_t k = 0; k < rates.size(); ++k) {
        values[k] = values[k] * device.area + added_torque(device.added_torques, k);
        // Slip in a box is left out: it needs a second gap to be told from the law.
        for (std::size_t i = 0; i < search.size() && !jacobian.empty(); ++i)
            jacobian[k * search.size() + i] = i < count ? plain[k * count + i] * device.area : 0.0;
    }
    return true;
}

bool InstrumentForward::predict_gaps(const Device& device, std::span<const double> search,
                                     std::span<double> values, std::span<double> jacobian) const {
    const std::size_t count = law_.size();
    const double slip = slip_ ? search[count] : 0.0;
    for (std::size_t k = 0; k < device.speeds.size(); ++k) {
        values[k] = 0.0;
        const double change = end_factor_change(device, k, search);
        const double bent = std::clamp(change, -largest_change, largest_change);
        const double factor = device.end_factors[k] * std::exp(bent);
        for (std::size_t i = 0; i < search.size() && !jacobian.empty(); ++i)
            jacobian[k * search.size() + i] = 0.0;
        for (const Part& part : device.parts) {
            const GapResponse flow =
                part.curve.at(k, law_, search.first(count), slip, !jacobian.empty());
            if (!std::isfinite(flow.inner_stress))
                return false;
            const double lever = part.torque_per_stress * factor;
            values[k] += lever * flow.inner_stress;
            if (jacobian.empty())
                continue;
            for (std::size_t i = 0; i < count; ++i)
                jacobian[k * search.size() + i] += lever * flow.derivatives[i];
            if (slip_)
                jacobian[k * search.size() + count] += lever * flow.slip_derivative;
        }
        if (!jacobian.empty() && bent == change && !device.end_factor_slopes.empty())
            for (std::size_t i = 0; i < count; ++i)
                jacobian[k * search.size() + i] +=
                    values[k] * device.end_factor_slopes[k * count + i];
        values[k] += added_torque(device.added_torques, k);
    }
    return true;
}

bool InstrumentForward::predict(std::span<const double> search, std::span<double> values,
                                std::span<double> jacobian) const {
    std::size_t first = 0;
    for (const Device& device : devices_) {
        const std::size_t rows = device.speeds.size();
        const auto own_values = values.subspan(first, rows);
        const auto own_jacobian =
            jacobian.empty() ? jacobian
                             : jacobian.subspan(first * search.size(), rows * search.size());
        const bool done = device.parts.empty()
                              ? predict_box(device, search, own_values, own_jacobian)
                              : predict_gaps(device, search, own_values, own_jacobian);
        if (!done)
            return false;
        first += rows;
    }
    return true;
}

} // namespace searle::solvers::fit_instrument
