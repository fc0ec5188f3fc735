#include "solvers/radial/tabulated_inverse.hpp"

#include <boost/math/interpolators/quintic_hermite.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace searle::solvers::radial {
namespace {

constexpr double smallest = 1e-10;
constexpr double largest = 1e6;
/// Interval in ln(RATE) for a law of sharpness 1: the error is h^6 / 46080 times the sixth
/// derivative.
constexpr double widest_interval = 0.04;
constexpr double most_intervals = 40'000.0;

} // namespace

struct InverseTable::Spline {
    boost::math::interpolators::cardinal_quintic_hermite<std::vector<double>> pieces;
};

template <class Law>
InverseTable::InverseTable(const Law& law, double typical_stress)
    : low_(std::log(typical_stress * smallest)), high_(std::log(typical_stress * largest)) {
    // Where the law is flattest an interval of stress is the widest one of rate: 1 / flow_index.
    const double wished =
        (high_ - low_) / widest_interval * law.sharpness() / std::min(1.0, double{law.flow_index});
    if (wished > most_intervals) {
        // Such a table would cost more than it saves: every rate is found by iteration.
        high_ = low_;
        return;
    }
    const auto count = static_cast<std::size_t>(wished) + 2;
    const double step = (high_ - low_) / static_cast<double>(count - 1);
    std::vector<double> value(count);
    std::vector<double> slope(count);
    std::vector<double> curvature(count);
    for (std::size_t k = 0; k < count; ++k) {
        const double rate = law.rate_at_excess(std::exp(low_ + static_cast<double>(k) * step));
        value[k] = std::log(rate);
        const double law_slope = law.log_slope(rate);
        slope[k] = 1.0 / law_slope;
        // d(law_slope)/d ln(rate), by a central difference of fourth order.
        const double h = 1e-3;
        const double bend =
            (8.0 * (law.log_slope(rate * std::exp(h)) - law.log_slope(rate * std::exp(-h))) -
             (law.log_slope(rate * std::exp(2 * h)) - law.log_slope(rate * std::exp(-2 * h)))) /
            (12.0 * h);
        curvature[k] = -bend / (law_slope * law_slope * law_slope);
    }
    spline_ = std::make_shared<const Spline>(
        Spline{{std::move(value), std::move(slope), std::move(curvature), low_, step}});
    // The last interval's end belongs to the law itself: the spline may not be asked past it.
    high_ = low_ + step * static_cast<double>(count - 1) * (1.0 - 1e-12);
}

InverseTable::Point InverseTable::at(double log_stress) const {
    return {spline_->pieces(log_stress), spline_->pieces.prime(log_stress)};
}

template <class Law>
double TabulatedLaw<Law>::rate_at_excess(double excess) const {
    if (!(excess > 0.0)) {
        return 0.0;
    }
    const double log_stress = std::log(excess);
    return table.covers(log_stress) ? std::exp(table.at(log_stress).log_rate)
                                    : Law::rate_at_excess(excess);
}

template InverseTable::InverseTable(const laws::flow::CarreauYasuda&, double);
template InverseTable::InverseTable(const laws::flow::Cross&, double);
template struct TabulatedLaw<laws::flow::CarreauYasuda>;
template struct TabulatedLaw<laws::flow::Cross>;

} // namespace searle::solvers::radial
