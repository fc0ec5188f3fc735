#include "rheometry/fit/least_squares.hpp"

// g++ 12 warns about its own AVX-512 intrinsics once Eigen has inlined them (GCC bug 105593).
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <ceres/cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <Eigen/Dense>
#include <glog/logging.h>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::rheometry::fit {
namespace {

/// The parameters that are not held, as one block of one cost function.
class BlockCost final : public ceres::CostFunction {
public:
    BlockCost(const LeastSquaresProblem& problem, std::vector<std::size_t> searched,
              std::vector<double> parameters)
        : problem_(problem), searched_(std::move(searched)), parameters_(std::move(parameters)),
          jacobian_(problem.residuals * parameters_.size()) {
        set_num_residuals(static_cast<int>(problem.residuals));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(searched_.size()));
    }

    bool Evaluate(const double* const* blocks, double* residuals,
                  double** jacobians) const override {
        for (std::size_t i = 0; i < searched_.size(); ++i)
            parameters_[searched_[i]] = blocks[0][i];
        const bool wanted = jacobians != nullptr && jacobians[0] != nullptr;
        const std::span<double> full = wanted ? std::span(jacobian_) : std::span<double>();
        if (!problem_.evaluate(parameters_, {residuals, problem_.residuals}, full))
            return false;
        if (wanted)
            for (std::size_t row = 0; row < problem_.residuals; ++row)
                for (std::size_t i = 0; i < searched_.size(); ++i)
                    jacobians[0][row * searched_.size() + i] =
                        jacobian_[row * parameters_.size() + searched_[i]];
        return true;
    }

private:
    const LeastSquaresProblem& problem_;
    std::vector<std::size_t> searched_;
    mutable std::vector<double> parameters_;
    mutable std::vector<double> jacobian_;
};

double sum_of_squares_at(const LeastSquaresProblem& problem, std::span<const double> parameters) {
    std::vector<double> residuals(problem.residuals);
    if (!problem.evaluate(parameters, residuals, {}))
        return std::numeric_limits<double>::infinity();
    double sum = 0.0;
    for (const double residual : residuals)
        sum += residual * residual;
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

/// Gauss-Newton steps from where the trust region stopped: the search ends when the sum of squares
/// stands still, at which half of the parameters' digits may still be open.
void polish(const LeastSquaresProblem& problem, const std::vector<std::size_t>& searched,
            Minimum& minimum) {
    const std::size_t count = minimum.parameters.size();
    const auto columns = static_cast<Eigen::Index>(searched.size());
    if (problem.residuals < searched.size())
        return;
    std::vector<double> residuals(problem.residuals);
    std::vector<double> jacobian(problem.residuals * count);
    double last_step = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 8; ++round) {
        if (!problem.evaluate(minimum.parameters, residuals, jacobian))
            return;
        Eigen::MatrixXd matrix(static_cast<Eigen::Index>(problem.residuals), columns);
        for (Eigen::Index row = 0; row < matrix.rows(); ++row)
            for (Eigen::Index i = 0; i < columns; ++i)
                matrix(row, i) = jacobian[static_cast<std::size_t>(row) * count +
                                          searched[static_cast<std::size_t>(i)]];
        const Eigen::VectorXd scale = matrix.colwise().norm();
        if (!(scale.minCoeff() > 0.0))
            return;
        matrix *= scale.cwiseInverse().asDiagonal();
        const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(matrix);
        if (std::abs(factors.matrixR()(columns - 1, columns - 1)) < 1e-9)
            return;
        const Eigen::VectorXd step =
            scale.cwiseInverse().asDiagonal() *
            factors.solve(Eigen::Map<const Eigen::VectorXd>(residuals.data(), matrix.rows()));
        std::vector<double> next = minimum.parameters;
        double largest = 0.0;
        for (std::size_t i = 0; i < searched.size(); ++i) {
            const double change = step(static_cast<Eigen::Index>(i));
            double& value = next[searched[i]];
            largest = std::max(largest, std::abs(change) / std::max(std::abs(value), 1e-300));
            value -= change;
            if (value < problem.low[searched[i]] || value > problem.high[searched[i]])
                return;
        }
        // Only small steps that get smaller: anything else is not the end of a search.
        if (!(largest < 1e-3 && largest < last_step))
            return;
        const double sum = sum_of_squares_at(problem, next);
        // A residual is the small difference of numbers near 1: what rounding leaves of the sum.
        const double rounding =
            1e-12 + 1e-14 / std::sqrt(minimum.sum_of_squares / double(problem.residuals));
        if (!(sum <= minimum.sum_of_squares * (1.0 + rounding)))
            return;
        minimum.parameters = std::move(next);
        minimum.sum_of_squares = std::min(sum, minimum.sum_of_squares);
        last_step = largest;
        if (largest < 1e-15)
            return;
    }
}

} // namespace

Minimum minimise(const LeastSquaresProblem& problem, std::span<const double> start,
                 const SearchEffort& effort) {
    Minimum minimum;
    minimum.parameters.assign(start.begin(), start.end());
    std::vector<std::size_t> searched;
    for (std::size_t i = 0; i < start.size(); ++i) {
        minimum.parameters[i] = std::clamp(start[i], problem.low[i], problem.high[i]);
        if (problem.low[i] < problem.high[i])
            searched.push_back(i);
    }
    minimum.sum_of_squares = sum_of_squares_at(problem, minimum.parameters);
    if (!std::isfinite(minimum.sum_of_squares))
        return minimum;
    if (searched.empty() || minimum.sum_of_squares == 0.0) {
        minimum.converged = true;
        return minimum;
    }

    std::vector<double> block;
    for (const std::size_t i : searched)
        block.push_back(minimum.parameters[i]);
    ceres::Problem search;
    search.AddResidualBlock(new BlockCost(problem, searched, minimum.parameters), nullptr,
                            block.data());
    for (std::size_t i = 0; i < searched.size(); ++i) {
        search.SetParameterLowerBound(block.data(), static_cast<int>(i), problem.low[searched[i]]);
        search.SetParameterUpperBound(block.data(), static_cast<int>(i), problem.high[searched[i]]);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.num_threads = 1;
    options.max_num_iterations = effort.most_iterations;
    options.function_tolerance = effort.relative_decrease;
    options.gradient_tolerance = 1e-18;
    options.parameter_tolerance = 1e-13;
    // A step to where the law has no value is turned back, not an end.
    options.max_num_consecutive_invalid_steps = 40;
    // Ceres would report on standard error; all that matters is in the summary.
    FLAGS_minloglevel = google::GLOG_FATAL;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &search, &summary);

    std::vector<double> found = minimum.parameters;
    for (std::size_t i = 0; i < searched.size(); ++i)
        found[searched[i]] =
            std::clamp(block[i], problem.low[searched[i]], problem.high[searched[i]]);
    const double sum = sum_of_squares_at(problem, found);
    if (sum <= minimum.sum_of_squares) {
        minimum.parameters = std::move(found);
        minimum.sum_of_squares = sum;
    }
    minimum.converged = summary.termination_type == ceres::CONVERGENCE;
    minimum.iterations = static_cast<int>(summary.iterations.size());
    if (effort.relative_decrease <= 1e-12)
        polish(problem, searched, minimum);
    return minimum;
}

std::optional<std::vector<double>> inverse_normal_matrix(std::span<const double> jacobian,
                                                         std::size_t parameters,
                                                         const std::vector<bool>& is_free) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < parameters; ++i)
        if (is_free[i])
            chosen.push_back(i);
    const std::size_t rows = jacobian.size() / parameters;
    const auto count = static_cast<Eigen::Index>(chosen.size());
    std::vector<double> inverse(parameters * parameters, 0.0);
    if (chosen.empty())
        return inverse;
    if (rows < chosen.size())
        return std::nullopt;
    Eigen::MatrixXd columns(static_cast<Eigen::Index>(rows), count);
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t i = 0; i < chosen.size(); ++i)
            columns(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(i)) =
                jacobian[row * parameters + chosen[i]];
    const Eigen::VectorXd scale = columns.colwise().norm();
    if (!(scale.minCoeff() > 0.0) || !std::isfinite(scale.maxCoeff()))
        return std::nullopt;
    columns *= scale.cwiseInverse().asDiagonal();
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(columns);
    if (std::abs(factors.matrixR()(count - 1, count - 1)) < 1e-12)
        return std::nullopt;
    const Eigen::MatrixXd root = factors.matrixR().topLeftCorner(count, count);
    const Eigen::MatrixXd half =
        factors.colsPermutation() * Eigen::MatrixXd(root.triangularView<Eigen::Upper>().solve(
                                        Eigen::MatrixXd::Identity(count, count)));
    const Eigen::MatrixXd scaled = half * half.transpose();
    for (std::size_t i = 0; i < chosen.size(); ++i)
        for (std::size_t k = 0; k < chosen.size(); ++k) {
            const auto row = static_cast<Eigen::Index>(i);
            const auto column = static_cast<Eigen::Index>(k);
            inverse[chosen[i] * parameters + chosen[k]] =
                scaled(row, column) / (scale(row) * scale(column));
        }
    return inverse;
}

namespace {

/// Cholesky factors of a matrix scaled to a unit diagonal.
struct ScaledFactors {
    Eigen::VectorXd scale;
    Eigen::LLT<Eigen::MatrixXd> factors;
    bool positive{};
};

ScaledFactors scaled_factors(std::span<const double> matrix, std::size_t size) {
    const auto count = static_cast<Eigen::Index>(size);
    const Eigen::Map<const Eigen::MatrixXd> given(matrix.data(), count, count);
    ScaledFactors result;
    result.scale = given.diagonal().cwiseSqrt();
    if (!(result.scale.minCoeff() > 0.0))
        return result;
    const Eigen::VectorXd inverse = result.scale.cwiseInverse();
    result.factors.compute(inverse.asDiagonal() * given * inverse.asDiagonal());
    result.positive = result.factors.info() == Eigen::Success &&
                      Eigen::VectorXd(result.factors.matrixLLT().diagonal()).minCoeff() > 1e-7;
    return result;
}

} // namespace

double log_determinant(std::span<const double> matrix, std::size_t size) {
    const ScaledFactors found = scaled_factors(matrix, size);
    if (!found.positive)
        return -std::numeric_limits<double>::infinity();
    return 2.0 * (Eigen::VectorXd(found.factors.matrixLLT().diagonal()).array().log().sum() +
                  found.scale.array().log().sum());
}

std::vector<double> inverse_of_positive(std::span<const double> matrix, std::size_t size) {
    const ScaledFactors found = scaled_factors(matrix, size);
    if (!found.positive)
        return {};
    const auto count = static_cast<Eigen::Index>(size);
    const Eigen::VectorXd inverse = found.scale.cwiseInverse();
    const Eigen::MatrixXd result = inverse.asDiagonal() *
                                   found.factors.solve(Eigen::MatrixXd::Identity(count, count)) *
                                   inverse.asDiagonal();
    return {result.data(), result.data() + result.size()};
}

} // namespace searle::rheometry::fit
