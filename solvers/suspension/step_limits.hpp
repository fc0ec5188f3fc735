#pragma once

#include "laws/contact/contact_law.hpp"
#include "solvers/suspension/suspension_input.hpp"

#include <optional>

namespace searle::solvers::suspension {

/// How long the steps are at an asked accuracy, against those that were measured
/// (docs/suspension.md): 1 at 2e-3.
[[nodiscard]] double step_scale(double accuracy);

/// How long the steps of particles with mass may be; docs/suspension.md has what the shares cost
/// in accuracy.
class StepLimits {
public:
    /// Of the input: particles, settings, viscosity, accuracy, gap and fastest speed.
    explicit StepLimits(const SuspensionInput& input);

    /// s, while no particles touch
    [[nodiscard]] double free() const { return free_; }
    /// s, while particles touch, the deepest by `overlap` (m): a share of the contact's relaxation.
    /// A spring that stiffens may meet twice that depth within the steps until this is asked again.
    [[nodiscard]] double touching(double overlap) const;
    /// s, beyond which steps of one length swing up: of explicit drag, and of contacts, which
    /// without colloidal forces that keep particles apart there always are.
    [[nodiscard]] double stable() const { return stable_; }
    /// s, for the first step, before the forces' change is known
    [[nodiscard]] double start() const { return start_; }
    /// Largest displacement error of a step, m; infinite without colloidal forces.
    [[nodiscard]] double displacement_error() const { return displacement_error_; }

private:
    [[nodiscard]] laws::contact::ContactSpring spring_at(double overlap) const;

    std::optional<laws::contact::AnyContact> contact_;
    bool explicit_steps_;
    double contact_time_scale_{}; ///< the contact's share, with the accuracy
    double drag_{};               ///< of the smallest particle, kg/s
    double reduced_mass_{};       ///< of the lightest pair, kg
    double reduced_radius_{};     ///< of the largest particle and a wall, m
    double foreseen_overlap_{};   ///< that shear alone presses a pair to, m
    double free_{};
    double start_{};
    double stable_{};
    double displacement_error_{};
};

} // namespace searle::solvers::suspension
