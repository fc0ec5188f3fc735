#include "solvers/radial/gap_grid.hpp"

#include <cmath>

namespace searle::solvers::radial {
namespace {

/// a > 0 with a / (exp(a) - 1) = slope, for 0 < slope < 1: the stretching of x = (e^(as) - 1)/(e^a
/// - 1).
double stretching(double slope) {
    double a = std::log(1.0 / slope) + 1.0;
    for (int iteration = 0; iteration < 60; ++iteration) {
        // Fixed point of a = ln(1 + a / slope): a contraction for slope < 1.
        const double next = std::log1p(a / slope);
        if (std::abs(next - a) < 1e-12 * a) {
            return next;
        }
        a = next;
    }
    return a;
}

} // namespace

std::vector<double> graded_grid(const GapShape& shape, double layer, int elements) {
    const double slope = 4.0 * layer / shape.width();
    const bool stretched = slope < 0.9;
    const double a = stretched ? stretching(slope) : 0.0;
    std::vector<double> x(static_cast<std::size_t>(elements) + 1);
    for (int k = 0; k <= elements; ++k) {
        const double s = static_cast<double>(k) / elements;
        const double from_wall =
            shape.width() * (stretched ? std::expm1(a * s) / std::expm1(a) : s);
        const int place = shape.outer_wall_moves ? elements - k : k;
        x[static_cast<std::size_t>(place)] =
            shape.outer_wall_moves ? shape.outer - from_wall : shape.inner + from_wall;
    }
    x.front() = shape.inner;
    x.back() = shape.outer;
    return x;
}

} // namespace searle::solvers::radial
