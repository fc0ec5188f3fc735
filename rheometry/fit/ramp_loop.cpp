#include "rheometry/fit/ramp_loop.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace searle::rheometry::fit {
namespace {

constexpr std::size_t fewest_rows = 5;
/// Share of the steps that may go the other way, by scatter of the speed.
constexpr double backward_share = 0.1;

/// One way, rates increasing.
struct Way {
    std::vector<double> rates;
    std::vector<double> values;
};

/// The area under a piecewise linear curve between two rates is linear in its values: the weight of
/// each value.
std::vector<double> area_weights(const Way& way, double low, double high) {
    std::vector<double> weights(way.rates.size());
    for (std::size_t k = 1; k < way.rates.size(); ++k) {
        const double left = way.rates[k - 1];
        const double width = way.rates[k] - left;
        const double from = std::max(low, left);
        const double to = std::min(high, way.rates[k]);
        if (!(to > from) || !(width > 0.0))
            continue;
        const double middle = (0.5 * (from + to) - left) / width;
        weights[k] += (to - from) * middle;
        weights[k - 1] += (to - from) * (1.0 - middle);
    }
    return weights;
}

double area(const Way& way, double low, double high) {
    const std::vector<double> weights = area_weights(way, low, high);
    double sum = 0.0;
    for (std::size_t k = 0; k < weights.size(); ++k)
        sum += weights[k] * way.values[k];
    return sum;
}

/// Variance of the area from how far each value lies off the line through its neighbours, as a
/// share of the value: 1 + (a^2 + b^2) of a point's own variance for neighbours weighed by a and b.
double area_variance(const Way& way, double low, double high) {
    const std::vector<double> weights = area_weights(way, low, high);
    double relative = 0.0;
    std::size_t count = 0;
    for (std::size_t k = 1; k + 1 < way.rates.size(); ++k) {
        const double width = way.rates[k + 1] - way.rates[k - 1];
        if (!(width > 0.0))
            continue;
        const double share = (way.rates[k] - way.rates[k - 1]) / width;
        const double line = way.values[k - 1] + share * (way.values[k + 1] - way.values[k - 1]);
        const double off = (way.values[k] - line) / way.values[k];
        relative += off * off / (1.0 + share * share + (1.0 - share) * (1.0 - share));
        ++count;
    }
    if (count == 0)
        return 0.0;
    relative /= static_cast<double>(count);
    double variance = 0.0;
    for (std::size_t k = 0; k < weights.size(); ++k)
        variance += weights[k] * weights[k] * way.values[k] * way.values[k] * relative;
    return variance;
}

Way way_of(std::span<const double> rates, std::span<const double> values, bool reversed) {
    Way way{{rates.begin(), rates.end()}, {values.begin(), values.end()}};
    if (reversed) {
        std::ranges::reverse(way.rates);
        std::ranges::reverse(way.values);
    }
    return way;
}

/// Nearly all steps go up; a step back of scatter's size is passed over.
bool goes_up(const std::vector<double>& rates) {
    std::size_t back = 0;
    for (std::size_t k = 1; k < rates.size(); ++k)
        back += rates[k] <= rates[k - 1] ? 1 : 0;
    return static_cast<double>(back) <= backward_share * static_cast<double>(rates.size()) &&
           rates.back() > 1.5 * rates.front();
}

} // namespace

std::optional<RampLoop> ramp_loop(std::span<const double> rates, std::span<const double> stresses,
                                  std::span<const double> inertial) {
    if (rates.size() < 2 * fewest_rows)
        return std::nullopt;
    const auto [slowest, fastest] = std::ranges::minmax_element(rates);
    for (const auto turn : {fastest, slowest}) {
        const auto row = static_cast<std::size_t>(turn - rates.begin());
        if (row + 1 < fewest_rows || rates.size() - row < fewest_rows)
            continue;
        const bool up_first = turn == fastest;
        const auto part = [&](std::span<const double> values, bool first) {
            return way_of(first ? rates.first(row + 1) : rates.subspan(row),
                          first ? values.first(row + 1) : values.subspan(row), first != up_first);
        };
        const Way up = part(stresses, up_first);
        const Way down = part(stresses, !up_first);
        if (!goes_up(up.rates) || !goes_up(down.rates))
            continue;
        RampLoop loop;
        loop.turning_row = row;
        loop.low_rate = std::max(up.rates.front(), down.rates.front());
        loop.high_rate = std::min(up.rates.back(), down.rates.back());
        if (!(loop.high_rate > loop.low_rate))
            continue;
        loop.measured =
            area(up, loop.low_rate, loop.high_rate) - area(down, loop.low_rate, loop.high_rate);
        loop.inertial = area(part(inertial, up_first), loop.low_rate, loop.high_rate) -
                        area(part(inertial, !up_first), loop.low_rate, loop.high_rate);
        loop.standard_error = std::sqrt(area_variance(up, loop.low_rate, loop.high_rate) +
                                        area_variance(down, loop.low_rate, loop.high_rate));
        return loop;
    }
    return std::nullopt;
}

} // namespace searle::rheometry::fit
