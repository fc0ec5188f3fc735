#include "rheometry/fit/design.hpp"

#include "rheometry/fit/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace searle::rheometry::fit {
namespace {

/// Parameters that are searched for.
std::vector<std::size_t> searched_of(const FitResult& result) {
    std::vector<std::size_t> searched;
    for (std::size_t i = 0; i < result.estimates.size(); ++i)
        if (!result.estimates[i].parameter.held)
            searched.push_back(i);
    return searched;
}

/// The columns of the searched parameters only, row by row.
std::vector<double> chosen_columns(const Sensitivities& all,
                                   const std::vector<std::size_t>& searched) {
    std::vector<double> rows;
    for (std::size_t k = 0; k < all.size(); ++k)
        for (const std::size_t i : searched)
            rows.push_back(all.rows[k * all.parameters + i]);
    return rows;
}

void add_row(std::vector<double>& matrix, std::span<const double> row, double sign) {
    for (std::size_t i = 0; i < row.size(); ++i)
        for (std::size_t k = 0; k < row.size(); ++k)
            matrix[i * row.size() + k] += sign * row[i] * row[k];
}

} // namespace

Sensitivities sensitivities(const ForwardModel& forward, const FitResult& result,
                            double unit_ratio) {
    const std::size_t count = result.search.size();
    std::vector<double> values(forward.size());
    Sensitivities found{std::vector<double>(forward.size() * count), count};
    if (!forward.predict(result.search, values, found.rows))
        return {{}, count};
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double unit =
            result.weighting == Weighting::absolute ? result.units.front() * unit_ratio : values[k];
        for (std::size_t i = 0; i < count; ++i)
            found.rows[k * count + i] /= unit * result.residual_deviation;
    }
    return found;
}

Design suggest_points(const FitResult& result, const Sensitivities& present_rows,
                      const Candidates& candidates, std::size_t count) {
    const std::vector<std::size_t> searched = searched_of(result);
    const std::size_t size = searched.size();
    const std::vector<double>& rates = candidates.rates;
    const std::vector<double> rows = chosen_columns(candidates.sensitivities, searched);
    const auto row = [&](std::size_t k) { return std::span(rows).subspan(k * size, size); };

    std::vector<double> present(size * size, 0.0);
    std::vector<double> tiny(size, 0.0);
    for (std::size_t k = 0; k < rates.size(); ++k)
        for (std::size_t i = 0; i < size; ++i)
            tiny[i] = std::max(tiny[i], std::abs(row(k)[i]));
    const std::vector<double> own = chosen_columns(present_rows, searched);
    for (std::size_t k = 0; k < present_rows.size(); ++k)
        add_row(present, std::span(own).subspan(k * size, size), 1.0);
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
    design.name = candidates.name;
    design.low_rate = rates.front();
    design.high_rate = rates.back();
    std::sort(chosen.begin(), chosen.end());
    for (const std::size_t k : chosen) {
        if (!design.points.empty() && design.points.back().rate == rates[k])
            ++design.points.back().repeats;
        else
            design.points.push_back(
                {rates[k], candidates.speeds.empty() ? 0.0 : candidates.speeds[k], 1});
    }
    const std::vector<double> covariance = inverse_of_positive(matrix, size);
    const std::vector<double> old = inverse_of_positive(present, size);
    const std::size_t all = result.estimates.size();
    design.shrinkage.assign(all, std::numeric_limits<double>::quiet_NaN());
    design.standard_errors.assign(all, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t s = 0; s < size && !covariance.empty(); ++s) {
        const std::size_t i = searched[s];
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

std::vector<Design> suggest_designs(const FitResult& result, const Sensitivities& present,
                                    const std::vector<Candidates>& sets, std::size_t count) {
    std::vector<Design> designs;
    for (const Candidates& candidates : sets)
        if (!candidates.rates.empty() && candidates.sensitivities.size() == candidates.rates.size())
            designs.push_back(suggest_points(result, present, candidates, count));
    std::stable_sort(designs.begin(), designs.end(), [](const Design& a, const Design& b) {
        return a.volume_ratio < b.volume_ratio;
    });
    return designs;
}

} // namespace searle::rheometry::fit
