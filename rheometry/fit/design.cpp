#include "rheometry/fit/design.hpp"

#include "rheometry/fit/least_squares.hpp"
#include "rheometry/fit/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace searle::rheometry::fit {
namespace {

constexpr std::size_t candidates = 121;

/// Sums of outer products of sensitivities over the scatter.
class Information {
public:
    Information(const Model& model, const FitResult& result) : model_(model), result_(result) {
        for (std::size_t i = 0; i < result.estimates.size(); ++i)
            if (!result.estimates[i].parameter.held)
                searched_.push_back(i);
    }

    /// Rows of sensitivities over the scatter of a point, searched parameters only.
    [[nodiscard]] std::vector<double> rows(std::span<const double> rates) const {
        const std::size_t count = result_.search.size();
        std::vector<double> stresses(rates.size());
        std::vector<double> jacobian(rates.size() * count);
        model_.stresses(result_.search, rates, stresses, jacobian);
        std::vector<double> scaled;
        for (std::size_t k = 0; k < rates.size(); ++k) {
            const double unit =
                result_.weighting == Weighting::absolute ? result_.units.front() : stresses[k];
            for (const std::size_t i : searched_)
                scaled.push_back(jacobian[k * count + i] / (unit * result_.residual_deviation));
        }
        return scaled;
    }
    [[nodiscard]] std::size_t size() const { return searched_.size(); }
    [[nodiscard]] const std::vector<std::size_t>& searched() const { return searched_; }

private:
    const Model& model_;
    const FitResult& result_;
    std::vector<std::size_t> searched_;
};

void add_row(std::vector<double>& matrix, std::span<const double> row, double sign) {
    for (std::size_t i = 0; i < row.size(); ++i)
        for (std::size_t k = 0; k < row.size(); ++k)
            matrix[i * row.size() + k] += sign * row[i] * row[k];
}

} // namespace

Design suggest_points(const Model& model, const FitResult& result, const RateWindow& window,
                      std::size_t count) {
    const Information information(model, result);
    const std::size_t size = information.size();
    const std::vector<double> rates = spread_rates(window.rates.low, window.rates.high, candidates);
    const std::vector<double> rows = information.rows(rates);
    const auto row = [&](std::size_t k) { return std::span(rows).subspan(k * size, size); };

    std::vector<double> present(size * size, 0.0);
    std::vector<double> tiny(size, 0.0);
    for (std::size_t k = 0; k < rates.size(); ++k)
        for (std::size_t i = 0; i < size; ++i)
            tiny[i] = std::max(tiny[i], std::abs(row(k)[i]));
    for (std::size_t k = 0; k < result.present_rates.size(); ++k) {
        const double rate = result.present_rates[k];
        const std::vector<double> own = information.rows(std::span(&rate, 1));
        add_row(present, own, 1.0);
    }
    std::vector<double> before = present;
    // A direction that nothing determines yet still needs a determinant to start from.
    for (std::size_t i = 0; i < size; ++i)
        before[i * size + i] += 1e-9 * std::max(tiny[i] * tiny[i], 1e-300);

    std::vector<double> matrix = before;
    std::vector<std::size_t> chosen;
    const auto best_addition = [&]() {
        std::size_t best = 0;
        double largest = -std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < rates.size(); ++k) {
            std::vector<double> with = matrix;
            add_row(with, row(k), 1.0);
            const double value = log_determinant(with, size);
            if (value > largest) {
                largest = value;
                best = k;
            }
        }
        return best;
    };
    for (std::size_t n = 0; n < count; ++n) {
        chosen.push_back(best_addition());
        add_row(matrix, row(chosen.back()), 1.0);
    }
    for (int sweep = 0; sweep < 20; ++sweep) {
        bool exchanged = false;
        for (std::size_t& point : chosen) {
            add_row(matrix, row(point), -1.0);
            const std::size_t better = best_addition();
            exchanged = exchanged || better != point;
            point = better;
            add_row(matrix, row(point), 1.0);
        }
        if (!exchanged)
            break;
    }

    Design design;
    design.window = window.name;
    std::sort(chosen.begin(), chosen.end());
    for (const std::size_t k : chosen) {
        if (!design.points.empty() && design.points.back().rate == rates[k])
            ++design.points.back().repeats;
        else
            design.points.push_back({rates[k], 1});
    }
    const std::vector<double> covariance = inverse_of_positive(matrix, size);
    const std::vector<double> old = inverse_of_positive(present, size);
    const std::size_t all = result.estimates.size();
    design.shrinkage.assign(all, std::numeric_limits<double>::quiet_NaN());
    design.standard_errors.assign(all, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t s = 0; s < size && !covariance.empty(); ++s) {
        const std::size_t i = information.searched()[s];
        const double deviation = std::sqrt(covariance[s * size + s]);
        design.standard_errors[i] =
            deviation * search_slope(result.estimates[i].parameter.transform, result.search[i]);
        if (!old.empty())
            design.shrinkage[i] = deviation / std::sqrt(old[s * size + s]);
    }
    design.volume_ratio =
        std::exp(0.5 * (log_determinant(present, size) - log_determinant(matrix, size)));
    return design;
}

std::vector<Design> suggest_windows(const Model& model, const FitResult& result,
                                    const std::vector<RateWindow>& windows, std::size_t count) {
    std::vector<Design> designs;
    for (const RateWindow& window : windows)
        designs.push_back(suggest_points(model, result, window, count));
    std::stable_sort(designs.begin(), designs.end(), [](const Design& a, const Design& b) {
        return a.volume_ratio < b.volume_ratio;
    });
    return designs;
}

} // namespace searle::rheometry::fit
