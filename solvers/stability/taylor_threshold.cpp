#include "solvers/stability/taylor_threshold.hpp"

#include "solvers/stability/legendre_basis.hpp"
#include "solvers/stability/marginal_problem.hpp"

#include <boost/math/tools/minima.hpp>

#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>

namespace searle::solvers::stability {
namespace {

/// The marginal problem at one radius ratio, as matrices. With y = r/R_bob = exp(L xi),
/// L = ln(delta), b = L k R_bob and P = d^2/dxi^2 - L^2 - b^2 y^2:
///   P y^-2 P u = b^2 G v,  P v = -lambda y^2 u,  u = u' = v = 0 at both walls,
/// where G = y^2 Omega/omega of the steady flow and lambda = 4 L^4 Re^2 / (e^3 (2 + e)), e = delta
/// - 1.
MarginalProblem newtonian_problem(double log_ratio, int modes) {
    const LegendreBasis basis = legendre_basis(modes);
    const double squared_log = log_ratio * log_ratio;
    const Eigen::ArrayXd squared_radius = (2.0 * log_ratio * basis.nodes.array()).exp();
    const Eigen::ArrayXd steady_flow =
        squared_radius * basis.nodes.array().unaryExpr([log_ratio](double xi) {
            return std::expm1(2.0 * log_ratio * (1.0 - xi)) / std::expm1(2.0 * log_ratio);
        });
    const Eigen::ArrayXd weights = basis.weights.array();
    const Eigen::MatrixXd bent = basis.clamped_curvature - squared_log * basis.clamped;
    const Eigen::MatrixXd mixed = weighted_product(bent, weights, basis.clamped);
    return MarginalProblem(
        {.bending = {weighted_product(bent, weights / squared_radius, bent),
                     -(mixed + mixed.transpose()),
                     weighted_product(basis.clamped, weights * squared_radius, basis.clamped)},
         .swirl = {weighted_product(basis.pinned_slope, weights, basis.pinned_slope) +
                       squared_log * weighted_product(basis.pinned, weights, basis.pinned),
                   weighted_product(basis.pinned, weights * squared_radius, basis.pinned)},
         .centrifugal = weighted_product(basis.clamped, weights * steady_flow, basis.pinned),
         .transport = weighted_product(basis.pinned, weights * squared_radius, basis.clamped)});
}

void require_gap(double relative_gap) {
    if (!(relative_gap > 0.0) || !std::isfinite(relative_gap)) {
        throw std::invalid_argument("the Taylor threshold needs a relative gap > 0");
    }
}

TaylorThreshold rising_resolution(double relative_gap) {
    constexpr std::array resolutions{12, 18, 26, 36, 50, 70, 100, 140};
    TaylorThreshold coarse = taylor_threshold_with_modes(relative_gap, resolutions.front());
    for (std::size_t i = 1; i < resolutions.size(); ++i) {
        TaylorThreshold fine = taylor_threshold_with_modes(relative_gap, resolutions[i]);
        fine.relative_error = std::abs(fine.reynolds - coarse.reynolds) / fine.reynolds;
        coarse = fine;
        if (fine.relative_error < 1e-10) {
            break;
        }
    }
    return coarse;
}

} // namespace

TaylorThreshold taylor_threshold_with_modes(double relative_gap, int modes) {
    require_gap(relative_gap);
    if (modes < 4) {
        throw std::invalid_argument("the Taylor threshold needs at least 4 modes");
    }
    const double log_ratio = std::log1p(relative_gap);
    MarginalProblem problem = newtonian_problem(log_ratio, modes);
    // k d at the onset is 3.1 for narrow gaps and rises slowly with the gap.
    constexpr double smallest = 2.0;
    constexpr double largest = 6.0;
    const double scale = log_ratio / relative_gap;
    const auto [wave_number, eigenvalue] = boost::math::tools::brent_find_minima(
        [&](double k) { return 1.0 / problem.largest_inverse(k * scale); }, smallest, largest, 27);
    const double excess = relative_gap / log_ratio;
    return {.reynolds =
                0.5 * excess * excess * std::sqrt(eigenvalue * (2.0 + relative_gap) / relative_gap),
            .wave_number = wave_number,
            .relative_error = 0.0,
            .modes = modes};
}

TaylorThreshold taylor_threshold(double relative_gap) {
    require_gap(relative_gap); // before the look-up: a NaN has no place in an ordered map
    static std::mutex guard;
    static std::map<double, TaylorThreshold> known;
    {
        const std::lock_guard lock(guard);
        if (const auto found = known.find(relative_gap); found != known.end()) {
            return found->second;
        }
    }
    const TaylorThreshold threshold = rising_resolution(relative_gap);
    const std::lock_guard lock(guard);
    return known.emplace(relative_gap, threshold).first->second;
}

} // namespace searle::solvers::stability
