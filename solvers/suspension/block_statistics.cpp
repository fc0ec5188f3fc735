#include "solvers/suspension/block_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace searle::solvers::suspension {
namespace {

double mean_of(std::span<const double> values) {
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

double squares_about(std::span<const double> values, double mean) {
    double sum = 0.0;
    for (const double value : values)
        sum += (value - mean) * (value - mean);
    return sum;
}

constexpr std::size_t fewest_blocks = 8;

} // namespace

SeriesMean mean_of_series(std::span<const double> values) {
    SeriesMean result;
    if (values.empty())
        return {0.0, std::numeric_limits<double>::infinity(), 1.0};
    result.mean = mean_of(values);
    if (values.size() < fewest_blocks) {
        result.standard_error = std::numeric_limits<double>::infinity();
        return result;
    }
    std::vector<double> blocks(values.begin(), values.end());
    double plain = 0.0;
    double largest = 0.0;
    while (blocks.size() >= fewest_blocks) {
        const auto count = static_cast<double>(blocks.size());
        const double variance = squares_about(blocks, mean_of(blocks)) / (count * (count - 1.0));
        if (plain == 0.0)
            plain = variance;
        largest = std::max(largest, variance);
        for (std::size_t k = 0; 2 * k + 1 < blocks.size(); ++k)
            blocks[k] = 0.5 * (blocks[2 * k] + blocks[2 * k + 1]);
        blocks.resize(blocks.size() / 2);
    }
    result.standard_error = std::sqrt(largest);
    result.inefficiency = plain > 0.0 ? largest / plain : 1.0;
    return result;
}

std::size_t start_up_length(std::span<const double> values) {
    constexpr std::size_t batch = 5;
    const std::size_t batches = values.size() / batch;
    if (batches < 4)
        return 0;
    std::vector<double> means(batches);
    for (std::size_t k = 0; k < batches; ++k)
        means[k] = mean_of(values.subspan(k * batch, batch));
    std::size_t best = 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t cut = 0; cut <= batches / 2; ++cut) {
        const std::span<const double> rest(means.data() + cut, batches - cut);
        const auto count = static_cast<double>(rest.size());
        const double error = squares_about(rest, mean_of(rest)) / (count * count);
        if (error < smallest) {
            smallest = error;
            best = cut;
        }
    }
    return best * batch;
}

LineFit line_at(std::span<const double> x, std::span<const double> values, double at) {
    const auto count = static_cast<double>(values.size());
    if (values.empty())
        return {0.0, std::numeric_limits<double>::infinity()};
    const double middle = mean_of(x);
    const double level = mean_of(values);
    double spread = 0.0;
    double product = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        spread += (x[k] - middle) * (x[k] - middle);
        product += (x[k] - middle) * (values[k] - level);
    }
    const double slope = spread > 0.0 ? product / spread : 0.0;
    LineFit fit{level + slope * (at - middle), std::numeric_limits<double>::infinity()};
    if (values.size() < fewest_blocks)
        return fit;
    std::vector<double> rest(values.size());
    for (std::size_t k = 0; k < values.size(); ++k)
        rest[k] = values[k] - level - slope * (x[k] - middle);
    const double correlated = mean_of_series(rest).inefficiency;
    const double variance = squares_about(rest, 0.0) / (count - 2.0) * correlated;
    fit.standard_error =
        std::sqrt(variance * (1.0 / count + (at - middle) * (at - middle) / spread));
    return fit;
}

} // namespace searle::solvers::suspension
