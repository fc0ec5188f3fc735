#pragma once

#include <vector>

namespace searle::solvers::fit_instrument {

/// Chebyshev points of the second kind, increasing from `low` to `high`; degree >= 1. Those of half
/// the degree are every second one.
[[nodiscard]] std::vector<double> chebyshev_points(double low, double high, int degree);

/// The polynomial through values at these points, by the barycentric formula; through one value: a
/// constant.
class ChebyshevCurve {
public:
    ChebyshevCurve(double low, double high, std::vector<double> values);

    [[nodiscard]] const std::vector<double>& values() const { return values_; }
    [[nodiscard]] double at(double x) const;
    /// Derivative, by a central difference good to some 1e-8 of the values.
    [[nodiscard]] double slope_at(double x) const;

private:
    double low_;
    double high_;
    std::vector<double> points_;
    std::vector<double> values_;
};

} // namespace searle::solvers::fit_instrument
