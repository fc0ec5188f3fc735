#include "solvers/fit_instrument/chebyshev_curve.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace searle::solvers::fit_instrument {

std::vector<double> chebyshev_points(double low, double high, int degree) {
    std::vector<double> points;
    for (int k = 0; k <= degree; ++k)
        points.push_back(0.5 * (low + high) -
                         0.5 * (high - low) * std::cos(std::numbers::pi * k / degree));
    return points;
}

ChebyshevCurve::ChebyshevCurve(double low, double high, std::vector<double> values)
    : low_(low), high_(high), values_(std::move(values)) {
    if (values_.size() > 1)
        points_ = chebyshev_points(low, high, static_cast<int>(values_.size()) - 1);
}

double ChebyshevCurve::at(double x) const {
    if (points_.empty())
        return values_.front();
    double above = 0.0;
    double below = 0.0;
    for (std::size_t k = 0; k < points_.size(); ++k) {
        const double distance = x - points_[k];
        if (std::abs(distance) < 1e-12 * (high_ - low_))
            return values_[k];
        const bool at_end = k == 0 || k + 1 == points_.size();
        const double weight = (k % 2 == 0 ? 1.0 : -1.0) * (at_end ? 0.5 : 1.0) / distance;
        above += weight * values_[k];
        below += weight;
    }
    return above / below;
}

double ChebyshevCurve::slope_at(double x) const {
    if (points_.empty())
        return 0.0;
    const double step = 1e-4 * (high_ - low_);
    return (at(x + step) - at(x - step)) / (2.0 * step);
}

} // namespace searle::solvers::fit_instrument
