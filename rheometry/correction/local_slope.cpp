#include "rheometry/correction/local_slope.hpp"

#include "rheometry/correction/small_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace searle::rheometry {
namespace {

constexpr std::size_t smallest_window = 5;
/// Half width of the confidence intervals of the window rule, in standard errors.
constexpr double interval_half_width = 1.5;
/// Neighbours on each side whose scatter is pooled.
constexpr std::size_t pooled_neighbours = 12;
/// Neighbours on each side in the median of the window sizes.
constexpr std::size_t median_reach = 3;

struct Points {
    std::span<const double> x;
    std::span<const double> y;
    std::span<const double> weights;
};

/// y = sum of c_k (x - x0)^k over a window.
template <std::size_t Size>
struct PolynomialFit {
    Vector<Size> coefficients{};
    /// Of the coefficients, for a scatter of 1 in a single measurement.
    Vector<Size> unit_variances{};
    /// Sum of the squared residuals of the window, unweighted by distance, over the degrees of
    /// freedom.
    double scatter_squared{};
};

struct Window {
    std::size_t first;
    std::size_t last; ///< inclusive
};

/// The `count` points nearest to x[centre].
Window nearest(std::span<const double> x, std::size_t centre, std::size_t count) {
    Window window{centre, centre};
    while (window.last - window.first + 1 < count) {
        const bool left_open = window.first > 0;
        const bool right_open = window.last + 1 < x.size();
        const bool take_left = left_open && (!right_open || x[centre] - x[window.first - 1] <=
                                                                x[window.last + 1] - x[centre]);
        if (take_left)
            --window.first;
        else
            ++window.last;
    }
    return window;
}

template <std::size_t Size>
std::optional<PolynomialFit<Size>> fit(const Points& points, std::size_t centre, Window window) {
    const double x0 = points.x[centre];
    const std::size_t count = window.last - window.first + 1;
    const double reach = std::max(x0 - points.x[window.first], points.x[window.last] - x0);
    const double bandwidth =
        reach * static_cast<double>(count + 1) / static_cast<double>(count - 1);

    Matrix<Size> normal{};
    Matrix<Size> noise{};
    Vector<Size> moment{};
    for (std::size_t i = window.first; i <= window.last; ++i) {
        const double u = (points.x[i] - x0) / bandwidth;
        const double kernel = 1.0 - u * u;
        const double weight = kernel * points.weights[i];
        Vector<Size> basis{1.0};
        for (std::size_t a = 1; a < Size; ++a)
            basis[a] = u * basis[a - 1];
        for (std::size_t a = 0; a < Size; ++a) {
            moment[a] += weight * basis[a] * points.y[i];
            for (std::size_t b = 0; b < Size; ++b) {
                normal[a][b] += weight * basis[a] * basis[b];
                noise[a][b] += kernel * weight * basis[a] * basis[b];
            }
        }
    }
    const std::optional<Matrix<Size>> inverse = inverse_of_symmetric(normal);
    if (!inverse)
        return std::nullopt;

    PolynomialFit<Size> result;
    const Vector<Size> scaled = product(*inverse, moment);
    double power = 1.0;
    for (std::size_t a = 0; a < Size; ++a, power *= bandwidth) {
        const Vector<Size> spread = product(noise, (*inverse)[a]);
        double variance = 0.0;
        for (std::size_t b = 0; b < Size; ++b)
            variance += (*inverse)[a][b] * spread[b];
        result.coefficients[a] = scaled[a] / power;
        result.unit_variances[a] = variance / (power * power);
    }
    for (std::size_t i = window.first; i <= window.last; ++i) {
        const double distance = points.x[i] - x0;
        double curve = 0.0;
        for (std::size_t a = Size; a-- > 0;)
            curve = curve * distance + result.coefficients[a];
        const double residual = points.y[i] - curve;
        result.scatter_squared += points.weights[i] * residual * residual;
    }
    result.scatter_squared /= static_cast<double>(count - Size);
    return result;
}

/// Variance of a single measurement around the curve near each point, from the smallest windows.
std::vector<double> pooled_scatter_squared(const Points& points) {
    const std::size_t count = points.x.size();
    std::vector<double> single(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t centre = std::clamp<std::size_t>(i, 2, count - 3);
        if (const auto found = fit<3>(points, centre, {centre - 2, centre + 2}))
            single[i] = found->scatter_squared;
    }
    std::vector<double> pooled(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t first = i > pooled_neighbours ? i - pooled_neighbours : 0;
        const std::size_t last = std::min(count - 1, i + pooled_neighbours);
        for (std::size_t k = first; k <= last; ++k)
            pooled[i] += single[k] / static_cast<double>(last - first + 1);
    }
    return pooled;
}

std::vector<std::size_t> window_sizes(std::size_t count) {
    std::vector<std::size_t> sizes;
    for (std::size_t size = smallest_window; size < count;
         size += std::max<std::size_t>(1, size / 5))
        sizes.push_back(size);
    sizes.push_back(count);
    return sizes;
}

/// The largest window that the intersection rule allows for the slope of a quadratic.
std::size_t best_window(const Points& points, std::size_t centre, double scatter_squared,
                        std::span<const std::size_t> sizes) {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    std::size_t best = sizes.front();
    for (const std::size_t size : sizes) {
        const auto found = fit<3>(points, centre, nearest(points.x, centre, size));
        if (!found)
            continue;
        const double half_width =
            interval_half_width * std::sqrt(scatter_squared * found->unit_variances[1]);
        lower = std::max(lower, found->coefficients[1] - half_width);
        upper = std::min(upper, found->coefficients[1] + half_width);
        if (lower > upper)
            break;
        best = size;
    }
    return best;
}

/// The median of each window and its neighbours: scatter stops the rule early at single points.
std::vector<std::size_t> smoothed(const std::vector<std::size_t>& windows) {
    std::vector<std::size_t> result(windows.size());
    for (std::size_t i = 0; i < windows.size(); ++i) {
        const std::size_t reach = std::min({i, windows.size() - 1 - i, median_reach});
        const auto first = windows.begin() + static_cast<std::ptrdiff_t>(i - reach);
        std::vector<std::size_t> near(first, first + static_cast<std::ptrdiff_t>(2 * reach + 1));
        std::ranges::sort(near);
        result[i] = near[reach];
    }
    return result;
}

} // namespace

std::vector<LocalSlope> local_slopes(std::span<const double> x, std::span<const double> y,
                                     std::span<const double> weights) {
    if (x.size() < smallest_window || y.size() != x.size() || weights.size() != x.size())
        throw std::invalid_argument("local_slopes: 5 points or more, as many y and weights as x");
    const Points points{x, y, weights};
    const std::vector<double> scatter = pooled_scatter_squared(points);
    const std::vector<std::size_t> sizes = window_sizes(x.size());
    constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
    std::vector<LocalSlope> slopes(x.size(),
                                   {not_known, not_known, not_known, not_known, not_known, 0});
    std::vector<std::size_t> windows(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        windows[i] = best_window(points, i, scatter[i], sizes);
    windows = smoothed(windows);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const std::size_t window = windows[i];
        const Window near = nearest(x, i, window);
        const auto quadratic = fit<3>(points, i, near);
        const auto cubic = fit<4>(points, i, near);
        if (!quadratic || !cubic)
            continue;
        const double variance = std::max(scatter[i], cubic->scatter_squared);
        const double bend = cubic->coefficients[1] - quadratic->coefficients[1];
        slopes[i] = {.value = cubic->coefficients[0],
                     .slope = cubic->coefficients[1],
                     .slope_standard_error =
                         std::sqrt(variance * cubic->unit_variances[1] + 0.5 * bend * bend),
                     .curvature = 2.0 * cubic->coefficients[2],
                     .curvature_standard_error =
                         2.0 * std::sqrt(variance * cubic->unit_variances[2]),
                     .window = window};
    }
    return slopes;
}

} // namespace searle::rheometry
