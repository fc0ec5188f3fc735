#include "solvers/stability/taylor_threshold.hpp"

#include "solvers/stability/legendre_basis.hpp"

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
/// - 1. In weak form both operators on the left are symmetric positive definite.
class MarginalProblem {
public:
    MarginalProblem(double relative_gap, int modes)
        : log_ratio_(std::log1p(relative_gap)), guess_(Eigen::VectorXd::Ones(modes)) {
        const LegendreBasis basis = legendre_basis(modes);
        const double squared_log = log_ratio_ * log_ratio_;
        const Eigen::ArrayXd squared_radius = (2.0 * log_ratio_ * basis.nodes.array()).exp();
        const Eigen::ArrayXd steady_flow =
            squared_radius * basis.nodes.array().unaryExpr([this](double xi) {
                return std::expm1(2.0 * log_ratio_ * (1.0 - xi)) / std::expm1(2.0 * log_ratio_);
            });
        const Eigen::ArrayXd weights = basis.weights.array();
        const auto integral = [](const Eigen::MatrixXd& left, const Eigen::ArrayXd& weight,
                                 const Eigen::MatrixXd& right) -> Eigen::MatrixXd {
            return left.transpose() * weight.matrix().asDiagonal() * right;
        };
        const Eigen::MatrixXd bent = basis.clamped_curvature - squared_log * basis.clamped;
        const Eigen::MatrixXd mixed = integral(bent, weights, basis.clamped);
        bending_[0] = integral(bent, weights / squared_radius, bent);
        bending_[1] = -(mixed + mixed.transpose());
        bending_[2] = integral(basis.clamped, weights * squared_radius, basis.clamped);
        swirl_[0] = integral(basis.pinned_slope, weights, basis.pinned_slope) +
                    squared_log * integral(basis.pinned, weights, basis.pinned);
        swirl_[1] = integral(basis.pinned, weights * squared_radius, basis.pinned);
        centrifugal_ = integral(basis.clamped, weights * steady_flow, basis.pinned);
        transport_ = integral(basis.pinned, weights * squared_radius, basis.clamped);
    }

    /// Smallest lambda > 0 at axial wave number b. The inverse operators have positive kernels, so
    /// the largest eigenvalue 1/lambda is simple, real and well apart: power iteration.
    double smallest_eigenvalue(double wave_number) {
        const double square = wave_number * wave_number;
        const Eigen::LLT<Eigen::MatrixXd> bending(bending_[0] +
                                                  square * (bending_[1] + square * bending_[2]));
        const Eigen::LLT<Eigen::MatrixXd> swirl(swirl_[0] + square * swirl_[1]);
        double eigenvalue = 0.0;
        for (int iteration = 0; iteration < 200; ++iteration) {
            guess_.normalize();
            const Eigen::VectorXd next =
                swirl.solve(transport_ * bending.solve(square * (centrifugal_ * guess_)));
            const double estimate = 1.0 / next.dot(guess_);
            const bool settled = std::abs(estimate - eigenvalue) <= 1e-14 * std::abs(estimate);
            eigenvalue = estimate;
            guess_ = next;
            if (settled) {
                break;
            }
        }
        return eigenvalue;
    }

    [[nodiscard]] double log_ratio() const { return log_ratio_; }

private:
    double log_ratio_{};
    std::array<Eigen::MatrixXd, 3> bending_; ///< coefficients of 1, b^2, b^4
    std::array<Eigen::MatrixXd, 2> swirl_;   ///< coefficients of 1, b^2
    Eigen::MatrixXd centrifugal_;
    Eigen::MatrixXd transport_;
    Eigen::VectorXd guess_; ///< eigenvector of the last wave number: a good start for the next
};

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
    MarginalProblem problem(relative_gap, modes);
    // k d at the onset is 3.1 for narrow gaps and rises slowly with the gap.
    constexpr double smallest = 2.0;
    constexpr double largest = 6.0;
    const double scale = problem.log_ratio() / relative_gap;
    const auto [wave_number, eigenvalue] = boost::math::tools::brent_find_minima(
        [&](double k) { return problem.smallest_eigenvalue(k * scale); }, smallest, largest, 27);
    const double excess = relative_gap / problem.log_ratio();
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
