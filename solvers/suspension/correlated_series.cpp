#include "solvers/suspension/correlated_series.hpp"

#include <algorithm>
#include <array>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <Eigen/Dense>
#include <limits>
#include <numeric>
#include <vector>

namespace searle::solvers::suspension {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// Of the prior: what is certain beforehand is little, and tests/suspension/ hold the outcome to
/// processes of known correlation.
constexpr double white_prior = 0.5;
constexpr double longest_correlation = 1.0; ///< over the series' length
constexpr int correlation_times = 14;
/// Share of white noise in the variance of a block's mean.
constexpr std::array noise_shares{0.0, 0.25, 0.5, 0.75, 0.9};
constexpr double unknown = std::numeric_limits<double>::infinity();
/// Two standard deviations of a normal distribution.
constexpr double wanted_probability = 0.9545;

enum class Path { rough, smooth };

/// Twice integrated correlation, in units of the scale squared; `t` in units of the scale.
/// Rough: exp(-t), smooth: (1 + t) exp(-t).
double twice_integrated(Path path, double t) {
    return path == Path::rough ? t - 1.0 + std::exp(-t) : 2.0 * t - 3.0 + (3.0 + t) * std::exp(-t);
}

/// Correlation of the means of blocks with one another.
/// @param time integral of the correlation from 0 to infinity, in blocks
Matrix block_correlation(Path path, double time, Eigen::Index blocks) {
    const double scale = path == Path::rough ? time : 0.5 * time;
    std::vector<double> of_distance(static_cast<std::size_t>(blocks));
    for (std::size_t k = 0; k < of_distance.size(); ++k) {
        const auto distance = static_cast<double>(k);
        of_distance[k] = twice_integrated(path, (distance + 1.0) / scale) -
                         2.0 * twice_integrated(path, distance / scale) +
                         twice_integrated(path, std::abs(distance - 1.0) / scale);
    }
    Matrix matrix(blocks, blocks);
    for (Eigen::Index i = 0; i < blocks; ++i)
        for (Eigen::Index j = 0; j < blocks; ++j)
            matrix(i, j) = of_distance[static_cast<std::size_t>(std::abs(i - j))] / of_distance[0];
    return matrix;
}

/// Student's t of the wanted value, given one correlation, and how likely that is.
struct Explanation {
    double log_weight{};
    double centre{};
    double width{};
};

/// Means of neighbouring values, the last ones whole: the rest of a division falls to the start.
Vector block_means(std::span<const double> values, std::size_t each) {
    const std::size_t blocks = values.size() / each;
    const std::size_t left_out = values.size() - blocks * each;
    Vector means(static_cast<Eigen::Index>(blocks));
    for (std::size_t b = 0; b < blocks; ++b) {
        double sum = 0.0;
        for (const double value : values.subspan(left_out + b * each, each))
            sum += value;
        means(static_cast<Eigen::Index>(b)) = sum / static_cast<double>(each);
    }
    return means;
}

/// Generalised least squares with this correlation; the coefficients and the variance, whose
/// priors are flat (and flat in its logarithm), are integrated out.
Explanation explain(const Matrix& correlation, double log_prior, const Matrix& shapes,
                    const Vector& wanted, const Vector& means) {
    const Eigen::LLT<Matrix> factor(correlation);
    const Matrix white_shapes = factor.matrixL().solve(shapes);
    const Vector white_means = factor.matrixL().solve(means);
    const Matrix normal = white_shapes.transpose() * white_shapes;
    const Eigen::LLT<Matrix> normal_factor(normal);
    const Vector coefficients = normal_factor.solve(white_shapes.transpose() * white_means);
    const double rest = (white_means - white_shapes * coefficients).squaredNorm();
    const auto freedom = static_cast<double>(means.size() - shapes.cols());
    const auto log_root = [](const Eigen::LLT<Matrix>& llt) {
        return llt.matrixLLT().diagonal().array().log().sum();
    };
    return {.log_weight = log_prior - log_root(factor) - log_root(normal_factor) -
                          0.5 * freedom * std::log(rest),
            .centre = wanted.dot(coefficients),
            .width = std::sqrt(rest / freedom * wanted.dot(normal_factor.solve(wanted)))};
}

std::vector<Explanation> explanations(const Matrix& shapes, const Vector& wanted,
                                      const Vector& means) {
    const Eigen::Index blocks = means.size();
    const Matrix identity = Matrix::Identity(blocks, blocks);
    std::vector<Explanation> found{explain(identity, std::log(white_prior), shapes, wanted, means)};
    const auto length = static_cast<double>(blocks);
    const double shortest = 0.5 / length;
    const double prior = std::log(
        (1.0 - white_prior) / (2.0 * correlation_times * static_cast<double>(noise_shares.size())));
    for (const Path path : {Path::rough, Path::smooth})
        for (int k = 0; k < correlation_times; ++k) {
            const double time =
                shortest * std::pow(longest_correlation / shortest,
                                    static_cast<double>(k) / (correlation_times - 1));
            const Matrix correlation = block_correlation(path, time * length, blocks);
            for (const double noise : noise_shares)
                found.push_back(explain((1.0 - noise) * correlation + noise * identity, prior,
                                        shapes, wanted, means));
        }
    double largest = -std::numeric_limits<double>::infinity();
    for (const Explanation& each : found)
        largest = std::max(largest, each.log_weight);
    double sum = 0.0;
    for (const Explanation& each : found)
        sum += std::exp(each.log_weight - largest);
    for (Explanation& each : found)
        each.log_weight -= largest + std::log(sum);
    std::erase_if(found, [](const Explanation& each) { return each.log_weight < -14.0; });
    return found;
}

/// Distance from `value` that holds the truth with the wanted probability.
double wanted_distance(const std::vector<Explanation>& all, double value, double freedom) {
    const boost::math::students_t_distribution<double> student(freedom);
    const auto outside = [&](double distance) {
        double sum = 0.0;
        for (const Explanation& each : all) {
            const double off = value - each.centre;
            sum += std::exp(each.log_weight) * (cdf(student, (-distance + off) / each.width) +
                                                cdf(student, (-distance - off) / each.width));
        }
        return sum;
    };
    double low = 0.0;
    double high = 0.0;
    for (const Explanation& each : all)
        high = std::max(high, each.width);
    while (outside(high) > 1.0 - wanted_probability) {
        low = high;
        high *= 2.0;
    }
    while (high - low > 1e-3 * high) {
        const double middle = 0.5 * (low + high);
        (outside(middle) > 1.0 - wanted_probability ? low : high) = middle;
    }
    return high;
}

/// @param value what is given out as the value, by least squares of all values
/// @param scale size of the values: what differs by its last digits is equal
SeriesEstimate estimate(double value, double scale, const Matrix& shapes, const Vector& wanted,
                        const Vector& means) {
    const Matrix identity = Matrix::Identity(means.size(), means.size());
    const Explanation plain = explain(identity, 0.0, shapes, wanted, means);
    const auto freedom = static_cast<double>(means.size() - shapes.cols());
    if (!(plain.width > 1e-13 * scale))
        return {value, 0.0, static_cast<double>(means.size())};
    const double error = 0.5 * wanted_distance(explanations(shapes, wanted, means), value, freedom);
    const double ratio = plain.width / error;
    return {value, error, static_cast<double>(means.size()) * ratio * ratio};
}

double largest_of(std::span<const double> values) {
    double largest = 0.0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value));
    return largest;
}

std::size_t values_per_block(std::size_t count) { return (count + most_blocks - 1) / most_blocks; }

} // namespace

double plain_mean(std::span<const double> values) {
    if (values.empty())
        return 0.0;
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double value_on_line(std::span<const double> x, std::span<const double> values, double at) {
    const double middle = plain_mean(x);
    const double level = plain_mean(values);
    double spread = 0.0;
    double product = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        spread += (x[k] - middle) * (x[k] - middle);
        product += (x[k] - middle) * (values[k] - level);
    }
    return level + (spread > 0.0 ? product / spread * (at - middle) : 0.0);
}

SeriesEstimate mean_of_series(std::span<const double> values) {
    if (values.size() < fewest_values)
        return {plain_mean(values), unknown, 0.0};
    const Vector means = block_means(values, values_per_block(values.size()));
    return estimate(plain_mean(values), largest_of(values), Matrix::Ones(means.size(), 1),
                    Vector::Ones(1), means);
}

SeriesEstimate line_at(std::span<const double> x, std::span<const double> values, double at) {
    const double value = value_on_line(x, values, at);
    if (values.size() < fewest_values)
        return {value, unknown, 0.0};
    const std::size_t each = values_per_block(values.size());
    const Vector means = block_means(values, each);
    const double middle = plain_mean(x);
    const double unit = std::abs(x.back() - x.front());
    Matrix shapes(means.size(), 2);
    shapes.col(0).setOnes();
    shapes.col(1) = (block_means(x, each).array() - middle) / unit;
    return estimate(value, largest_of(values), shapes, Vector{{1.0, (at - middle) / unit}}, means);
}

} // namespace searle::solvers::suspension
