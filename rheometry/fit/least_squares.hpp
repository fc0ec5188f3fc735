#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace searle::rheometry::fit {

/// Residuals and, where asked for, their derivatives (row by row); false: no value there.
using ResidualFunction = std::function<bool(
    std::span<const double> parameters, std::span<double> residuals, std::span<double> jacobian)>;

/// A nonlinear least-squares problem within bounds.
struct LeastSquaresProblem {
    ResidualFunction evaluate;
    std::size_t residuals{};
    std::vector<double> low;  ///< per parameter
    std::vector<double> high; ///< per parameter; equal to `low` holds the parameter
};

struct Minimum {
    std::vector<double> parameters;
    double sum_of_squares{}; ///< of the residuals
    bool converged{};
    int iterations{};
};

/// How far a search goes.
struct SearchEffort {
    int most_iterations = 400;
    /// Ends when a step lowers the sum of squares by less than this part.
    double relative_decrease = 1e-16;
};

/// Levenberg-Marquardt with exact derivatives down to rounding (Ceres, trust region, dense QR).
/// A start outside the bounds is moved to them. Not converged: the residuals have no value at the
/// start, or the iterations ran out.
[[nodiscard]] Minimum minimise(const LeastSquaresProblem& problem, std::span<const double> start,
                               const SearchEffort& effort = {});

/// Inverse of J^T J for the free parameters (rows and columns of the others are 0); no value when
/// the free columns depend on each other to working precision.
/// @param jacobian  row by row
[[nodiscard]] std::optional<std::vector<double>>
inverse_normal_matrix(std::span<const double> jacobian, std::size_t parameters,
                      const std::vector<bool>& is_free);

/// ln det of a symmetric matrix, row by row; -infinity when it is not positive definite.
[[nodiscard]] double log_determinant(std::span<const double> matrix, std::size_t size);

/// Inverse of a symmetric positive definite matrix; empty when it is none to working precision.
[[nodiscard]] std::vector<double> inverse_of_positive(std::span<const double> matrix,
                                                      std::size_t size);

} // namespace searle::rheometry::fit
