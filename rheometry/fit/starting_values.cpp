#include "rheometry/fit/starting_values.hpp"

#include "rheometry/fit/positive_least_squares.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace searle::rheometry::fit {
namespace {

constexpr std::size_t most_sample_points = 40;
constexpr std::size_t most_starts = 3;

struct Sample {
    std::vector<double> rates;
    std::vector<double> stresses;
};

Sample sample_of(std::span<const double> rates, std::span<const double> stresses) {
    Sample sample;
    const std::size_t stride = std::max<std::size_t>(1, rates.size() / most_sample_points);
    for (std::size_t k = 0; k < rates.size(); k += stride) {
        sample.rates.push_back(rates[k]);
        sample.stresses.push_back(stresses[k]);
    }
    if ((rates.size() - 1) % stride != 0) {
        sample.rates.push_back(rates.back());
        sample.stresses.push_back(stresses.back());
    }
    return sample;
}

/// Keeps the best few starts of a grid.
class BestStarts {
public:
    void offer(double misfit, std::vector<double> values) {
        if (!std::isfinite(misfit))
            return;
        const auto place =
            std::upper_bound(starts_.begin(), starts_.end(), misfit,
                             [](double value, const Start& start) { return value < start.misfit; });
        starts_.insert(place, {misfit, std::move(values)});
        if (starts_.size() > most_starts)
            starts_.pop_back();
    }
    [[nodiscard]] std::vector<std::vector<double>> values() const {
        std::vector<std::vector<double>> result;
        for (const Start& start : starts_)
            result.push_back(start.values);
        return result;
    }

private:
    struct Start {
        double misfit{};
        std::vector<double> values;
    };
    std::vector<Start> starts_;
};

/// Grid search over what is not linear: `columns(k, nonlinear)` are the linear terms at point k.
template <std::size_t Count, class Columns>
LinearTerms<Count> linear_part(const Sample& sample, const Columns& columns) {
    PositiveLeastSquares<Count> system;
    for (std::size_t k = 0; k < sample.rates.size(); ++k) {
        std::array<double, Count> row = columns(sample.rates[k]);
        for (double& entry : row)
            entry /= sample.stresses[k];
        system.add(row, 1.0);
    }
    return system.solve();
}

std::vector<double> logarithmic_grid(double low, double high, int count) {
    std::vector<double> grid;
    for (int i = 0; i < count; ++i)
        grid.push_back(low * std::pow(high / low, i / double(std::max(1, count - 1))));
    return grid;
}

constexpr std::array flow_indices{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.3, 1.8, 2.5};

/// Laws stress = yield + linear terms in rate^n.
std::vector<std::vector<double>> index_starts(const Model& model, const Sample& sample,
                                              const DataScale& scale) {
    BestStarts best;
    const bool sisko = model.name == "sisko";
    for (const double index : flow_indices) {
        if (sisko && index == 1.0)
            continue;
        const auto terms = linear_part<2>(sample, [&](double rate) {
            return std::array{sisko ? rate : 1.0, std::pow(rate, index)};
        });
        const double least = 1e-6 * scale.lowest_stress / std::pow(scale.highest_rate, index);
        best.offer(terms.misfit, {terms.factor[0], std::max(terms.factor[1], least), index});
    }
    return best.values();
}

std::vector<std::vector<double>> plateau_starts(const Model& model, const Sample& sample,
                                                const DataScale& scale) {
    BestStarts best;
    const bool cross = model.name == "cross";
    const std::vector<double> transitions =
        cross ? std::vector{1.0} : std::vector{0.5, 1.0, 2.0, 5.0};
    for (const double time :
         logarithmic_grid(0.1 / scale.highest_rate, 10.0 / scale.lowest_rate, 9))
        for (const double index : {0.05, 0.25, 0.45, 0.65, 0.85})
            for (const double transition : transitions) {
                const auto terms = linear_part<2>(sample, [&](double rate) {
                    const double share = cross ? 1.0 / (1.0 + std::pow(time * rate, 1.0 - index))
                                               : std::pow(1.0 + std::pow(time * rate, transition),
                                                          (index - 1.0) / transition);
                    return std::array{rate * share, rate * (1.0 - share)};
                });
                const double zero = std::max(terms.factor[0], 0.2 * scale.lowest_viscosity);
                std::vector<double> values{zero, std::min(terms.factor[1], zero), time, index};
                if (!cross)
                    values.push_back(transition);
                best.offer(terms.misfit, std::move(values));
            }
    return best.values();
}

/// The law gives the rate for a stress: linear in 1 / zero_viscosity and the power term's factor.
std::vector<std::vector<double>> ellis_starts(const Sample& sample, const DataScale& scale) {
    BestStarts best;
    for (const double exponent : {1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 7.0, 10.0}) {
        PositiveLeastSquares<2> system;
        for (std::size_t k = 0; k < sample.rates.size(); ++k) {
            const double stress = sample.stresses[k] / scale.highest_stress;
            // A relative deviation of the stress is `exponent` times as large in the rate.
            system.add({stress / sample.rates[k], std::pow(stress, exponent) / sample.rates[k]},
                       1.0);
        }
        const auto terms = system.solve();
        const double linear = std::max(terms.factor[0], 1e-6 * terms.factor[1]);
        const double power = std::max(terms.factor[1], 1e-6 * terms.factor[0]);
        if (!(linear > 0.0))
            continue;
        best.offer(terms.misfit / (exponent * exponent),
                   {scale.highest_stress / linear,
                    scale.highest_stress * std::pow(linear / power, 1.0 / (exponent - 1.0)),
                    exponent});
    }
    return best.values();
}

std::vector<std::vector<double>> windhab_starts(const Sample& sample, const DataScale& scale) {
    BestStarts best;
    for (const double rate_scale : logarithmic_grid(scale.lowest_rate, scale.highest_rate, 9)) {
        const auto terms = linear_part<3>(sample, [&](double rate) {
            return std::array{1.0, -std::expm1(-rate / rate_scale), rate};
        });
        best.offer(terms.misfit,
                   {terms.factor[0], terms.factor[0] + terms.factor[1],
                    std::max(terms.factor[2], 1e-4 * scale.lowest_viscosity), rate_scale});
    }
    return best.values();
}

std::vector<double> power_law_start(const Sample& sample) {
    double mean_x = 0.0;
    double mean_y = 0.0;
    const auto count = static_cast<double>(sample.rates.size());
    for (std::size_t k = 0; k < sample.rates.size(); ++k) {
        mean_x += std::log(sample.rates[k]) / count;
        mean_y += std::log(sample.stresses[k]) / count;
    }
    double xx = 0.0;
    double xy = 0.0;
    for (std::size_t k = 0; k < sample.rates.size(); ++k) {
        const double x = std::log(sample.rates[k]) - mean_x;
        xx += x * x;
        xy += x * (std::log(sample.stresses[k]) - mean_y);
    }
    const double index = xx > 0.0 ? std::clamp(xy / xx, 0.02, 4.0) : 1.0;
    return {std::exp(mean_y - index * mean_x), index};
}

} // namespace

std::vector<std::vector<double>> starting_values(const Model& model, std::span<const double> rates,
                                                 std::span<const double> stresses) {
    const Sample sample = sample_of(rates, stresses);
    const DataScale scale = scale_of(sample.rates, sample.stresses);
    if (model.name == "newtonian") {
        const auto terms = linear_part<1>(sample, [](double rate) { return std::array{rate}; });
        return {{terms.factor[0]}};
    }
    if (model.name == "bingham") {
        const auto terms = linear_part<2>(sample, [](double rate) {
            return std::array{1.0, rate};
        });
        return {{terms.factor[0], std::max(terms.factor[1], 1e-4 * scale.lowest_viscosity)}};
    }
    if (model.name == "casson") {
        // Linear in the roots; a relative deviation of a root is half that of the stress.
        PositiveLeastSquares<2> system;
        for (std::size_t k = 0; k < sample.rates.size(); ++k) {
            const double root = std::sqrt(sample.stresses[k]);
            system.add({1.0 / root, std::sqrt(sample.rates[k]) / root}, 1.0);
        }
        const auto terms = system.solve();
        return {{terms.factor[0] * terms.factor[0],
                 std::max(terms.factor[1] * terms.factor[1], 1e-4 * scale.lowest_viscosity)}};
    }
    if (model.name == "power-law")
        return {power_law_start(sample)};
    if (model.name == "ellis")
        return ellis_starts(sample, scale);
    if (model.name == "windhab")
        return windhab_starts(sample, scale);
    if (model.name == "carreau-yasuda" || model.name == "cross")
        return plateau_starts(model, sample, scale);
    return index_starts(model, sample, scale);
}

} // namespace searle::rheometry::fit
