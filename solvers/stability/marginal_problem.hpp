#pragma once

#include "solvers/stability/eigen_dense.hpp"

#include <array>
#include <utility>

namespace searle::solvers::stability {

/// Integrals of products: left^T diag(weight) right, the functions' values at the nodes in columns.
[[nodiscard]] inline Eigen::MatrixXd weighted_product(const Eigen::MatrixXd& left,
                                                      const Eigen::ArrayXd& weight,
                                                      const Eigen::MatrixXd& right) {
    return left.transpose() * weight.matrix().asDiagonal() * right;
}

/// The marginal problem of axisymmetric vortices, as matrices over the functions of a basis:
///   (bending_0 + b^2 bending_1 + b^4 bending_2) u = b^2 centrifugal f,
///   (swirl_0 + b^2 swirl_1) f                     = lambda transport u,
/// b the axial wave number, u the radial and f the azimuthal velocity of the disturbance. Both
/// operators on the left are symmetric positive definite.
class MarginalProblem {
public:
    struct Matrices {
        std::array<Eigen::MatrixXd, 3> bending; ///< coefficients of 1, b^2, b^4
        std::array<Eigen::MatrixXd, 2> swirl;   ///< coefficients of 1, b^2
        Eigen::MatrixXd centrifugal;
        Eigen::MatrixXd transport;
    };

    explicit MarginalProblem(Matrices matrices)
        : matrices_(std::move(matrices)),
          guess_(Eigen::VectorXd::Ones(matrices_.centrifugal.cols())) {}

    /// Largest 1 / lambda where the inverse operators have positive kernels, as they do where the
    /// angular momentum falls outwards everywhere: it is then simple, real and well apart. Power
    /// iteration from the eigenvector of the last wave number.
    [[nodiscard]] double largest_inverse(double wave_number);

    /// Largest real 1 / lambda > 0 of all eigenvalues, whatever the kernels; 0 if there is none.
    [[nodiscard]] double largest_inverse_of_all(double wave_number) const;

private:
    Matrices matrices_;
    Eigen::VectorXd guess_;
};

} // namespace searle::solvers::stability
