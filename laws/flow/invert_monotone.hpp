#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::laws::flow {

/// The rate at which a smooth law without yield stress carries `stress` > 0; relative error a few
/// units of rounding. Newton in ln(rate) on ln(stress), kept between rates that enclose the root.
/// @param lower, upper  rates > 0 with law.stress(lower) <= stress <= law.stress(upper)
template <class Law>
[[nodiscard]] double invert_monotone(const Law& law, double stress, double lower, double upper) {
    double low = std::log(lower);
    double high = std::log(upper);
    double log_rate = low;
    const double target = std::log(stress);
    for (int iteration = 0; iteration < 100; ++iteration) {
        const double rate = std::exp(log_rate);
        const double difference = std::log(law.stress(rate)) - target;
        (difference > 0.0 ? high : low) = log_rate;
        const double step = -difference / law.log_slope(rate);
        double next = log_rate + step;
        if (!(next >= low && next <= high)) {
            next = 0.5 * (low + high);
        }
        const double moved = std::abs(next - log_rate);
        log_rate = next;
        if (moved <= 4.0 * std::numeric_limits<double>::epsilon() * std::max(1.0, std::abs(next))) {
            break;
        }
    }
    return std::exp(log_rate);
}

} // namespace searle::laws::flow
