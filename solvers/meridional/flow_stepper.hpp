#pragma once

#include "solvers/meridional/flow_system.hpp"

#include <Eigen/Core>

#include <functional>

namespace searle::solvers::meridional {

/// How the rotor turns from some time on: speed over the reference speed, time times the reference
/// speed.
struct LinearDrive {
    double start_time{};
    double speed{};        ///< at start_time
    double acceleration{}; ///< change of `speed` per time

    [[nodiscard]] double speed_at(double time) const {
        return speed + acceleration * (time - start_time);
    }
};

/// How a stepper behaves.
struct StepperSettings {
    double tolerance = 1e-4;    ///< of the velocity's error in one step, over the largest velocity
    double first_step = 1e-3;   ///< tried after every begin(), > 0
    double shortest_step = 0.0; ///< a step that would have to be shorter is not taken
    /// Speed of each node of the rotor over the drive's, (node); empty: 1 everywhere.
    Eigen::VectorXd rotor_profile{};
    /// Called before each try of a step; may throw.
    std::function<void()> at_each_try{};
};

/// The flow in time: ESDIRK4(3)6L[2]SA (radial/esdirk.hpp) with the pressure as what keeps every
/// stage free of divergence, a step size from the embedded error, and one factorised derivative for
/// as many steps as it serves. Units of the material's reference speed.
class FlowStepper {
public:
    /// @param system, material  outlive the stepper
    FlowStepper(FlowSystem& system, FlowMaterial material, FlowState start,
                StepperSettings settings);

    /// The drive changes at the present time, where its start_time is: its speed may jump and so
    /// may its acceleration. The fluid's own velocity stays.
    void begin(const LinearDrive& drive);

    /// One step, not beyond `limit` > time().
    /// @param least_scale  of the velocity, which errors are measured against where the largest
    ///                     velocity is less: out of rest the error of a step is a fixed share of
    ///                     the little that moves, however short it is
    /// False where Newton's method or the error asks for
    /// steps that are too short; the state is then that of time().
    [[nodiscard]] bool step(double limit, double least_scale = 0.0);

    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] double last_step() const { return time_ - time_before_; }
    [[nodiscard]] const FlowState& state() const { return state_; }
    /// Velocity at a time within the last step, by cubic polynomials.
    [[nodiscard]] Eigen::MatrixX3d velocity_at(double time) const;
    /// Torque by the rotor on the fluid over 2 pi stress scale radius^3, at a time within the last
    /// step: from the velocity and its rate of change there.
    [[nodiscard]] double torque_at(double time) const;

    [[nodiscard]] long steps() const { return steps_; }
    [[nodiscard]] long rejected() const { return rejected_; }
    [[nodiscard]] long solves() const { return solves_; }

private:
    enum class Outcome { taken, inaccurate, stuck };
    [[nodiscard]] Outcome try_step(double length, double least_scale);
    void refactorise(double length);
    void turn_rotor(FlowState& state, double speed) const;

    FlowSystem& system_;
    FlowMaterial material_;
    StepperSettings settings_;
    LinearDrive drive_;
    FlowState state_;
    FlowState state_before_;
    Eigen::MatrixX3d rate_; ///< of change of the velocity
    Eigen::MatrixX3d rate_before_;
    double time_{};
    double time_before_{};
    double next_length_{};
    double error_ratio_{};       ///< of the last step tried, over what is allowed
    double factorised_length_{}; ///< 0: no factors
    bool factors_are_stale_{};
    long steps_{};
    long rejected_{};
    long solves_{};
};

} // namespace searle::solvers::meridional
