#include "rheometry/fit/nearby_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace searle::rheometry::fit {
namespace {

constexpr std::size_t most_parameters = 12;
constexpr double first_damping = 1e-4;
/// With this much damping a step is too short to matter.
constexpr double largest_damping = 1e14;

using Vector = std::array<double, most_parameters>;

/// Residuals and derivatives at one set of parameters.
struct State {
    std::vector<double> parameters;
    std::vector<double> residuals;
    std::vector<double> jacobian;
    double sum = std::numeric_limits<double>::infinity();
};

void evaluate(const LeastSquaresProblem& problem, State& state) {
    state.sum = std::numeric_limits<double>::infinity();
    if (!problem.evaluate(state.parameters, state.residuals, state.jacobian))
        return;
    double sum = 0.0;
    for (const double residual : state.residuals)
        sum += residual * residual;
    if (std::isfinite(sum))
        state.sum = sum;
}

/// J^T J and J^T r, the matrix row by row.
struct NormalEquations {
    std::array<double, most_parameters * most_parameters> matrix{};
    Vector gradient{};

    NormalEquations(const State& state, std::size_t count) {
        for (std::size_t row = 0; row < state.residuals.size(); ++row) {
            const double* const slopes = state.jacobian.data() + row * count;
            for (std::size_t i = 0; i < count; ++i) {
                gradient[i] += slopes[i] * state.residuals[row];
                for (std::size_t k = 0; k <= i; ++k)
                    matrix[i * count + k] += slopes[i] * slopes[k];
            }
        }
    }
};

/// Solves the damped equations for the chosen parameters by Cholesky's factors; false where they
/// are singular to working precision.
bool solve_damped(const NormalEquations& equations, std::size_t count,
                  std::span<const std::size_t> chosen, const Vector& scale, double damping,
                  Vector& step) {
    std::array<double, most_parameters * most_parameters> factor;
    const std::size_t size = chosen.size();
    Vector half{};
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t k = 0; k <= i; ++k) {
            double entry = equations.matrix[chosen[i] * count + chosen[k]] /
                           (scale[chosen[i]] * scale[chosen[k]]);
            if (i == k)
                entry += damping;
            for (std::size_t j = 0; j < k; ++j)
                entry -= factor[i * size + j] * factor[k * size + j];
            if (i != k)
                factor[i * size + k] = entry / factor[k * size + k];
            else if (entry > 1e-15)
                factor[i * size + i] = std::sqrt(entry);
            else
                return false;
        }
        double right = -equations.gradient[chosen[i]] / scale[chosen[i]];
        for (std::size_t j = 0; j < i; ++j)
            right -= factor[i * size + j] * half[j];
        half[i] = right / factor[i * size + i];
    }
    for (std::size_t i = size; i-- > 0;) {
        double value = half[i];
        for (std::size_t j = i + 1; j < size; ++j)
            value -= factor[j * size + i] * half[j];
        half[i] = value / factor[i * size + i];
    }
    for (std::size_t i = 0; i < size; ++i)
        step[chosen[i]] = half[i] / scale[chosen[i]];
    return true;
}

/// Decrease of the sum of squares that the linearised residuals promise.
double promised_decrease(const NormalEquations& equations, std::size_t count, const Vector& moved) {
    double linear = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        linear += equations.gradient[i] * moved[i];
        for (std::size_t k = 0; k < i; ++k)
            square += 2.0 * equations.matrix[i * count + k] * moved[i] * moved[k];
        square += equations.matrix[i * count + i] * moved[i] * moved[i];
    }
    return -2.0 * linear - square;
}

} // namespace

Minimum minimise_nearby(const LeastSquaresProblem& problem, std::span<const double> start,
                        const SearchEffort& effort) {
    const std::size_t count = start.size();
    if (count > most_parameters)
        return minimise(problem, start, effort);
    State state{.parameters = {start.begin(), start.end()},
                .residuals = std::vector<double>(problem.residuals),
                .jacobian = std::vector<double>(problem.residuals * count)};
    for (std::size_t i = 0; i < count; ++i)
        state.parameters[i] = std::clamp(start[i], problem.low[i], problem.high[i]);
    evaluate(problem, state);
    Minimum minimum{.parameters = state.parameters, .sum_of_squares = state.sum};
    if (!std::isfinite(state.sum))
        return minimum;

    State trial = state;
    Vector scale{};
    double damping = first_damping;
    double growth = 2.0;
    for (; minimum.iterations < effort.most_iterations && !minimum.converged;
         ++minimum.iterations) {
        const NormalEquations equations(state, count);
        std::array<std::size_t, most_parameters> list{};
        std::size_t chosen = 0;
        for (std::size_t i = 0; i < count; ++i) {
            scale[i] = std::max(scale[i], std::sqrt(equations.matrix[i * count + i]));
            const bool pressed =
                (state.parameters[i] <= problem.low[i] && equations.gradient[i] >= 0.0) ||
                (state.parameters[i] >= problem.high[i] && equations.gradient[i] <= 0.0);
            if (problem.low[i] < problem.high[i] && !pressed && scale[i] > 0.0)
                list[chosen++] = i;
        }
        if (chosen == 0 || state.sum == 0.0) {
            minimum.converged = true;
            break;
        }
        bool lower = false;
        while (!lower && !minimum.converged) {
            Vector step{};
            if (solve_damped(equations, count, std::span(list).first(chosen), scale, damping,
                             step)) {
                Vector moved{};
                for (std::size_t i = 0; i < count; ++i) {
                    trial.parameters[i] =
                        std::clamp(state.parameters[i] + step[i], problem.low[i], problem.high[i]);
                    moved[i] = trial.parameters[i] - state.parameters[i];
                }
                evaluate(problem, trial);
                const double promised = promised_decrease(equations, count, moved);
                const double decrease = state.sum - trial.sum;
                // Less than rounding leaves of the sum is neither a rise nor a fall.
                if (std::abs(promised) <= 1e-15 * state.sum)
                    minimum.converged = true;
                if (decrease > 0.0) {
                    minimum.converged = minimum.converged ||
                                        (decrease <= effort.relative_decrease * state.sum &&
                                         promised <= 4.0 * effort.relative_decrease * state.sum);
                    std::swap(state, trial);
                    const double quality = promised > 0.0 ? decrease / promised : 0.5;
                    damping *= std::max(0.1, 1.0 - std::pow(2.0 * quality - 1.0, 3.0));
                    growth = 2.0;
                    lower = true;
                }
            }
            if (!lower) {
                damping = std::max(damping, 1e-12) * growth;
                growth *= 2.0;
                if (damping > largest_damping)
                    minimum.converged = true;
            }
        }
    }
    minimum.parameters = std::move(state.parameters);
    minimum.sum_of_squares = state.sum;
    return minimum;
}

} // namespace searle::rheometry::fit
