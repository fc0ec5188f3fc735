#pragma once

#include "laws/flow/flow_law.hpp"
#include "solvers/axisymmetric/energy_minimiser.hpp"

#include <Eigen/Core>
#include <vector>

namespace searle::solvers::axisymmetric {

/// A flow law in the units of one swirl flow: rates over the rotor's speed, stresses over
/// stress_scale(), energies over their product. Phi is the dissipation potential, the integral of
/// the stress over the rate, Phi* its convex conjugate, the integral of the rate over the stress.
class SwirlLaw {
public:
    /// @param speed      rad/s, > 0
    /// @param rate_scale a typical rate of shear over the speed, > 0
    SwirlLaw(const laws::flow::AnyFlowLaw& law, double speed, double rate_scale);

    [[nodiscard]] double stress_scale() const { return stress_scale_; } ///< Pa
    [[nodiscard]] double yield_stress() const;                          ///< over stress_scale()
    /// m when Phi(a x) = a^m Phi(x) for all rates, else 0.
    [[nodiscard]] double homogeneity() const;

    /// Phi at each rate >= 0. Exact for laws with a closed form, else to 1e-12.
    [[nodiscard]] Eigen::ArrayXXd potential(const Eigen::ArrayXXd& rate) const;
    /// Phi* at each stress >= 0.
    [[nodiscard]] Eigen::ArrayXXd conjugate(const Eigen::ArrayXXd& stress) const;
    /// Stress at each rate >= 0; 0 at rest, whatever the yield stress.
    [[nodiscard]] Eigen::ArrayXXd stress(const Eigen::ArrayXXd& rate) const;

    /// Phi(sqrt(rate^2 + rounding^2)): as smooth as Newton's method needs at rest. A parameter of
    /// the path to the solution only: energies are taken with potential().
    class RoundedPotential final : public EnergyDensity {
    public:
        RoundedPotential(const SwirlLaw& law, double rounding) : law_(law), rounding_(rounding) {}
        void slopes(const Eigen::ArrayXd& rate, Eigen::ArrayXd& secant,
                    Eigen::ArrayXd& tangent) const override;

    private:
        const SwirlLaw& law_;
        double rounding_;
    };

    /// Phi*(sqrt(stress^2 + rounding^2)) + softening stress^2 / 2: a little compliance where the
    /// fluid is rigid. A parameter of the path, as above.
    class SoftenedConjugate final : public EnergyDensity {
    public:
        SoftenedConjugate(const SwirlLaw& law, double softening, double rounding)
            : law_(law), softening_(softening), rounding_(rounding) {}
        void slopes(const Eigen::ArrayXd& stress, Eigen::ArrayXd& secant,
                    Eigen::ArrayXd& tangent) const override;

    private:
        const SwirlLaw& law_;
        double softening_;
        double rounding_;
    };

private:
    [[nodiscard]] double excess_potential(double rate) const;
    void tabulate();

    laws::flow::AnyFlowLaw law_;
    double speed_;
    double stress_scale_;
    std::vector<double> table_; ///< potential at the table's rates, Pa/s; laws without closed form
};

} // namespace searle::solvers::axisymmetric
