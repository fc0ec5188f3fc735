#pragma once

#include "solvers/axisymmetric/section_space.hpp"

#include <Eigen/Core>
#include <memory>

namespace searle::solvers::axisymmetric {

/// A convex energy density F(|g|), at many points at once.
class EnergyDensity {
public:
    virtual ~EnergyDensity() = default;
    /// @param size    |g| >= 0 at each point
    /// @param secant  F'(|g|) / |g|, > 0 and finite
    /// @param tangent F''(|g|), > 0 and finite
    virtual void slopes(const Eigen::ArrayXd& size, Eigen::ArrayXd& secant,
                        Eigen::ArrayXd& tangent) const = 0;
};

/// What a minimisation did.
struct Minimised {
    bool converged{};
    int steps{};        ///< Newton steps, one factorisation each
    double decrement{}; ///< the last step's predicted decrease of the energy, over sum of |g| F'
};

/// The part of an implicit step: factor / 2 times the integral of r^2 (field - centre)^2, for the
/// rotation alone.
struct InertiaTerm {
    double factor{}; ///< > 0
    const Eigen::VectorXd& centre;
};

/// Finds the field of a space that minimises
///   sum over the points of weight F(|g|)  -  load . values  (+ an InertiaTerm),
/// by Newton's method with a line search along exact slopes. The nodes inside an element are
/// eliminated there; the rest is one sparse Cholesky factorisation a step, whose symbolic part is
/// made once.
class EnergyMinimiser {
public:
    explicit EnergyMinimiser(const SectionSpace& space);
    ~EnergyMinimiser();
    EnergyMinimiser(const EnergyMinimiser&) = delete;
    EnergyMinimiser& operator=(const EnergyMinimiser&) = delete;

    /// @param values  start, with the prescribed values in place; the minimiser on return
    /// @param load    per node
    /// @param tolerance  the decrement to stop at
    [[nodiscard]] Minimised minimise(const EnergyDensity& density, const Eigen::VectorXd& load,
                                     double tolerance, int most_steps, Eigen::VectorXd& values,
                                     const InertiaTerm* inertia = nullptr);

    /// sum of weight F'(|g|) g . g(test) / |g|: the derivative of the energy along a test field.
    [[nodiscard]] double work_along(const EnergyDensity& density, const Eigen::VectorXd& values,
                                    const Eigen::VectorXd& test) const;
    /// The integral of r^2 one other.
    [[nodiscard]] double inertia_product(const Eigen::VectorXd& one, const Eigen::VectorXd& other);

private:
    struct Work;
    void prepare_masses();
    const SectionSpace& space_;
    std::unique_ptr<Work> work_;
};

} // namespace searle::solvers::axisymmetric
