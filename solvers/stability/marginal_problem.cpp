#include "solvers/stability/marginal_problem.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace searle::solvers::stability {
namespace {

/// Both operators at one wave number, factorised.
struct Factors {
    double square;
    Eigen::LLT<Eigen::MatrixXd> bending;
    Eigen::LLT<Eigen::MatrixXd> swirl;

    Factors(const MarginalProblem::Matrices& of, double wave_number)
        : square(wave_number * wave_number),
          bending(of.bending[0] + square * (of.bending[1] + square * of.bending[2])),
          swirl(of.swirl[0] + square * of.swirl[1]) {}
};

} // namespace

double MarginalProblem::largest_inverse(double wave_number) {
    const Factors factors(matrices_, wave_number);
    double eigenvalue = 0.0;
    for (int iteration = 0; iteration < 200; ++iteration) {
        guess_.normalize();
        const Eigen::VectorXd next = factors.swirl.solve(
            matrices_.transport *
            factors.bending.solve(factors.square * (matrices_.centrifugal * guess_)));
        const double estimate = next.dot(guess_);
        const bool settled = std::abs(estimate - eigenvalue) <= 1e-14 * std::abs(estimate);
        eigenvalue = estimate;
        guess_ = next;
        if (settled) {
            break;
        }
    }
    return eigenvalue;
}

double MarginalProblem::largest_inverse_of_all(double wave_number) const {
    const Factors factors(matrices_, wave_number);
    const Eigen::MatrixXd loop = factors.swirl.solve(
        matrices_.transport * factors.bending.solve(factors.square * matrices_.centrifugal));
    double largest = 0.0;
    const Eigen::EigenSolver<Eigen::MatrixXd> spectrum(loop, false);
    for (const std::complex<double>& value : spectrum.eigenvalues()) {
        if (std::abs(value.imag()) <= 1e-9 * std::abs(value)) {
            largest = std::max(largest, value.real());
        }
    }
    return largest;
}

} // namespace searle::solvers::stability
