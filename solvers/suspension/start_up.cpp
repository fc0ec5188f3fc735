#include "solvers/suspension/start_up.hpp"

#include "solvers/suspension/correlated_series.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace searle::solvers::suspension {
namespace {

double squares_about(std::span<const double> values, double mean) {
    double sum = 0.0;
    for (const double value : values)
        sum += (value - mean) * (value - mean);
    return sum;
}

} // namespace

std::size_t start_up_length(std::span<const double> values) {
    constexpr std::size_t batch = 5;
    const std::size_t batches = values.size() / batch;
    if (batches < 4)
        return 0;
    std::vector<double> means(batches);
    for (std::size_t k = 0; k < batches; ++k)
        means[k] = plain_mean(values.subspan(k * batch, batch));
    std::size_t best = 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t cut = 0; cut <= batches / 2; ++cut) {
        const std::span<const double> rest(means.data() + cut, batches - cut);
        const auto count = static_cast<double>(rest.size());
        const double error = squares_about(rest, plain_mean(rest)) / (count * count);
        if (error < smallest) {
            smallest = error;
            best = cut;
        }
    }
    return best * batch;
}

} // namespace searle::solvers::suspension
