#pragma once

#include "solvers/axisymmetric/energy_minimiser.hpp"
#include "solvers/axisymmetric/section_space.hpp"
#include "solvers/axisymmetric/swirl_law.hpp"

#include <Eigen/Core>

#include <array>
#include <limits>
#include <optional>

namespace searle::solvers::axisymmetric {

/// A rotor's speed on a stretch of time: speed + acceleration (t - start_time).
struct SwirlDrive {
    double start_time{}; ///< s
    double speed{};      ///< over the reference speed
    double acceleration{};
    [[nodiscard]] double speed_at(double time) const {
        return speed + acceleration * (time - start_time);
    }
};

/// Swirl in the section in time, without secondary flow, for any flow law:
///   rho r^2 dw/dt = (1/r) div (r^2 stress),  stress = stress(|g|) g/|g|,  g = r grad w.
/// Every implicit stage is the minimum of a convex energy,
///   Phi(|g|) + rho r^2 (w - w~)^2 / (2 theta),
/// so a yield stress needs nothing but EnergyMinimiser. Kennedy & Carpenter's ESDIRK4(3)6L[2]SA
/// (radial/esdirk.hpp) with its embedded error; a kink or jump of the drive starts with one very
/// small step of implicit Euler.
class SwirlStepper {
public:
    struct Settings {
        double tolerance{}; ///< of w in one step, over w, both in the norm of the kinetic energy
        double inertia{};   ///< rho length^2 reference speed / stress scale, s
        double rounding{};  ///< of the law at rest (SwirlLaw::RoundedPotential)
    };
    SwirlStepper(const SectionSpace& space, const SwirlLaw& law, Settings settings);

    /// w = 0 before the drive; or the steady flow at a speed. False where that is not found.
    [[nodiscard]] bool start_steadily(double speed);
    /// A new stretch of the drive; the first step of it is `first` s long.
    [[nodiscard]] bool begin(const SwirlDrive& drive, double first);
    /// One accepted step that does not pass `limit` and is not longer than `longest`; false where
    /// none can be taken. A flow that a standing rotor has brought to rest is left there: a yield
    /// stress does so in a finite time, and no step that is accurate relative to the flow gets past
    /// it.
    [[nodiscard]] bool step(double limit, double longest = std::numeric_limits<double>::infinity());

    [[nodiscard]] double time() const { return time_; }
    /// Over 2 pi length^3 stress scale, at the present time.
    [[nodiscard]] double torque();
    /// Of the steady flow at a speed, found from the present flow, which stays; nothing where it is
    /// not found.
    [[nodiscard]] std::optional<double> steady_torque(double speed);
    [[nodiscard]] const Eigen::VectorXd& rotation() const { return rotation_; }
    [[nodiscard]] long steps() const { return steps_; }
    [[nodiscard]] long solves() const { return solves_; }

private:
    [[nodiscard]] bool solve(double theta, const Eigen::VectorXd& centre, double speed,
                             Eigen::VectorXd& values);
    /// Minimises from the rounding 1 down to the law's own, `most_steps` at each before the last.
    [[nodiscard]] bool approach(double decrement, int most_steps, const InertiaTerm* inertia,
                                Eigen::VectorXd& values);
    /// Error over what is allowed; infinite where a stage was not solved.
    [[nodiscard]] double attempt(double length);
    [[nodiscard]] bool has_come_to_rest() const;
    void turn_rotor(double speed, Eigen::VectorXd& values) const;

    const SectionSpace& space_;
    const SwirlLaw& law_;
    Settings settings_;
    EnergyMinimiser minimiser_;
    Eigen::VectorXd rotor_;   ///< 1 on the rotor's nodes, 0 elsewhere
    Eigen::VectorXd no_load_; ///< 0 everywhere
    SwirlDrive drive_;
    double time_{};
    double next_length_{};
    Eigen::VectorXd rotation_;
    Eigen::VectorXd rate_; ///< dw/dt
    long steps_{};
    long solves_{};
};

} // namespace searle::solvers::axisymmetric
