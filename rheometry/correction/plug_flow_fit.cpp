#include "rheometry/correction/plug_flow_fit.hpp"

#include "rheometry/correction/small_matrix.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace searle::rheometry {
namespace {

constexpr double smallest_index = 0.1;
constexpr double largest_index = 2.5;

struct Data {
    std::span<const double> omega;
    std::span<const double> stress;
    std::span<const double> weights;
    double delta;
};

/// Parameters of the search: yield stress over the smallest stress of the data, ln consistency,
/// index.
using Parameters = Vector<3>;

PlugFlowLaw law_of(const Parameters& parameters, double stress_scale) {
    return {.yield_stress = parameters[0] * stress_scale,
            .consistency = std::exp(parameters[1]),
            .flow_index = parameters[2]};
}

bool is_possible(const Parameters& parameters) {
    return std::abs(parameters[0]) < 10.0 && std::abs(parameters[1]) < 300.0 &&
           parameters[2] > smallest_index && parameters[2] < largest_index;
}

struct Residuals {
    std::vector<double> values; ///< sqrt(weight) ln(model / measured)
    double sum_of_squares = std::numeric_limits<double>::infinity();
};

Residuals residuals_of(const Data& data, const Parameters& parameters) {
    Residuals result;
    if (!is_possible(parameters))
        return result;
    const PlugFlowLaw law = law_of(parameters, data.stress.front());
    result.values.reserve(data.omega.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < data.omega.size(); ++i) {
        const double model = bob_stress(law, data.omega[i], data.delta);
        if (!(std::isfinite(model) && model > 0.0))
            return {};
        result.values.push_back(std::sqrt(data.weights[i]) * std::log(model / data.stress[i]));
        sum += result.values.back() * result.values.back();
    }
    result.sum_of_squares = sum;
    return result;
}

struct Linearised {
    Matrix<3> normal{};
    Vector<3> gradient{};
};

std::optional<Linearised> linearise(const Data& data, const Parameters& parameters,
                                    const Residuals& here) {
    constexpr double step = 1e-6;
    std::array<std::vector<double>, 3> columns;
    for (std::size_t a = 0; a < 3; ++a) {
        Parameters shifted = parameters;
        shifted[a] += step;
        const Residuals there = residuals_of(data, shifted);
        if (!std::isfinite(there.sum_of_squares))
            return std::nullopt;
        for (std::size_t i = 0; i < here.values.size(); ++i)
            columns[a].push_back((there.values[i] - here.values[i]) / step);
    }
    Linearised result;
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t i = 0; i < here.values.size(); ++i) {
            result.gradient[a] += columns[a][i] * here.values[i];
            for (std::size_t b = 0; b < 3; ++b)
                result.normal[a][b] += columns[a][i] * columns[b][i];
        }
    return result;
}

struct Optimum {
    Parameters parameters{};
    double sum_of_squares = std::numeric_limits<double>::infinity();
    Matrix<3> inverse_normal{};
};

/// Levenberg-Marquardt from one start.
std::optional<Optimum> descend(const Data& data, Parameters parameters) {
    Residuals here = residuals_of(data, parameters);
    if (!std::isfinite(here.sum_of_squares))
        return std::nullopt;
    double damping = 1e-3;
    for (int iteration = 0; iteration < 60; ++iteration) {
        const auto linearised = linearise(data, parameters, here);
        if (!linearised)
            return std::nullopt;
        bool improved = false;
        double gain = 0.0;
        for (int attempt = 0; attempt < 12 && !improved; ++attempt) {
            Matrix<3> damped = linearised->normal;
            for (std::size_t a = 0; a < 3; ++a)
                damped[a][a] *= 1.0 + damping;
            const auto inverse = inverse_of_symmetric(damped);
            if (!inverse)
                return std::nullopt;
            const Vector<3> change = product(*inverse, linearised->gradient);
            Parameters next = parameters;
            for (std::size_t a = 0; a < 3; ++a)
                next[a] -= change[a];
            Residuals there = residuals_of(data, next);
            if (there.sum_of_squares < here.sum_of_squares) {
                gain = here.sum_of_squares - there.sum_of_squares;
                parameters = next;
                here = std::move(there);
                damping *= 0.2;
                improved = true;
            } else {
                damping *= 5.0;
            }
        }
        if (!improved || gain <= 1e-10 * here.sum_of_squares)
            break;
    }
    const auto linearised = linearise(data, parameters, here);
    if (!linearised)
        return std::nullopt;
    const auto inverse = inverse_of_symmetric(linearised->normal);
    if (!inverse)
        return std::nullopt;
    return Optimum{parameters, here.sum_of_squares, *inverse};
}

/// ln consistency that fits best on average for a given yield stress and index: the speed scales
/// with consistency^(-1/n), so one evaluation at consistency 1 is enough.
double log_consistency(const Data& data, double yield_ratio, double flow_index) {
    const PlugFlowLaw unit{yield_ratio * data.stress.front(), 1.0, flow_index};
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < data.omega.size(); ++i) {
        const double speed = bob_speed(unit, data.stress[i], data.delta);
        if (speed > 0.0) {
            sum += flow_index * std::log(speed / data.omega[i]);
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : 0.0;
}

} // namespace

double PlugFlowLaw::rate(double stress) const {
    const double excess = stress - yield_stress;
    return excess > 0.0 ? std::pow(excess / consistency, 1.0 / flow_index) : 0.0;
}

double PlugFlowLaw::rate_slope(double stress) const {
    const double excess = stress - yield_stress;
    return excess > 0.0 ? rate(stress) / (flow_index * excess) : 0.0;
}

double bob_speed(const PlugFlowLaw& law, double stress, double delta) {
    const double excess = stress - law.yield_stress;
    if (!(excess > 0.0))
        return 0.0;
    // With q = yield + excess s^3 the power of the rate at the yield surface (s = 0) becomes at
    // least s^3, so that Gauss' rule is not disturbed by it.
    const double power = 1.0 / law.flow_index;
    const double lowest = std::max(0.0, (stress / (delta * delta) - law.yield_stress) / excess);
    const auto integrand = [&](double s) {
        const double cube = s * s * s;
        return std::pow(cube, power) * s * s / (law.yield_stress + excess * cube);
    };
    const double integral =
        boost::math::quadrature::gauss<double, 30>::integrate(integrand, std::cbrt(lowest), 1.0);
    return 1.5 * excess * std::pow(excess / law.consistency, power) * integral;
}

double bob_stress(const PlugFlowLaw& law, double omega, double delta) {
    // ln(speed) is nearly straight over ln(stress - yield): Newton steps in these, within a
    // bracket.
    const double base = std::max(law.yield_stress, 0.0);
    const double goal = std::log(omega);
    const double newtonian_rate = omega * 2.0 / -std::expm1(-2.0 * std::log(delta));
    double excess = std::log(law.consistency) + law.flow_index * std::log(newtonian_rate);
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < 100; ++iteration) {
        const double stress = base + std::exp(excess);
        const double speed = bob_speed(law, stress, delta);
        const double miss = std::log(speed) - goal;
        if (!std::isfinite(miss))
            return std::numeric_limits<double>::quiet_NaN();
        (miss > 0.0 ? upper : lower) = excess;
        const double slope = 0.5 * (law.rate(stress) - law.rate(stress / (delta * delta))) /
                             stress / speed * std::exp(excess);
        const double newton_step = -miss / slope;
        if (std::abs(newton_step) < 1e-13 * std::max(1.0, std::abs(excess)))
            break;
        double next = excess + newton_step;
        if (!(next > lower && next < upper))
            next = std::isfinite(lower) && std::isfinite(upper) ? 0.5 * (lower + upper)
                                                                : excess - std::copysign(1.0, miss);
        excess = next;
    }
    return base + std::exp(excess);
}

std::optional<PlugFlowFit> fit_plug_flow(std::span<const double> omega,
                                         std::span<const double> stress,
                                         std::span<const double> weights, double delta) {
    if (omega.size() < 6)
        return std::nullopt;
    const Data data{omega, stress, weights, delta};
    std::optional<Optimum> best;
    for (const double yield_ratio : {0.95, 0.6, 0.0}) {
        for (const double flow_index : {0.4, 0.8}) {
            const auto found = descend(
                data, {yield_ratio, log_consistency(data, yield_ratio, flow_index), flow_index});
            if (found && (!best || found->sum_of_squares < best->sum_of_squares))
                best = found;
        }
    }
    if (!best)
        return std::nullopt;
    const double total_weight = std::reduce(weights.begin(), weights.end());
    const double freedom = static_cast<double>(omega.size() - 3);
    const double variance = best->sum_of_squares / freedom * best->inverse_normal[0][0];
    return PlugFlowFit{.law = law_of(best->parameters, stress.front()),
                       .yield_standard_error = stress.front() * std::sqrt(variance),
                       .residual = std::sqrt(best->sum_of_squares / total_weight)};
}

} // namespace searle::rheometry
