#pragma once

#include "solvers/meridional/point_flow.hpp"

#include <array>
#include <Eigen/Core>

namespace searle::solvers::meridional {

/// Derivative of the tested momentum of one element with respect to its velocities; pressure has no
/// part in it.
class ElementJacobian {
public:
    ElementJacobian(Eigen::Index points, Eigen::Index locals);

    /// (component x local node, component x local node), components one after the other.
    /// @param mass_rate  added inertia: mass_rate x reynolds x mass
    [[nodiscard]] const Eigen::MatrixXd& of(const Eigen::MatrixXd& stacked,
                                            const Eigen::ArrayXd& weight, const PointFlow& flow,
                                            double reynolds, double mass_rate);

private:
    /// A local function enters by its slope along r, its slope along z and its value.
    static constexpr std::size_t slots = 3;
    using Coefficients = std::array<std::array<Eigen::ArrayXd, slots>, slots>;

    [[nodiscard]] Coefficients coefficients(std::size_t test, std::size_t trial,
                                            const PointFlow& flow, double reynolds,
                                            double mass_rate) const;

    Eigen::Index points_;
    Eigen::Index locals_;
    Eigen::MatrixXd weighted_;
    Eigen::MatrixXd matrix_;
};

} // namespace searle::solvers::meridional
