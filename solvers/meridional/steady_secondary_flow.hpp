#pragma once

#include "geometry/din_bob.hpp"
#include "laws/flow/flow_law.hpp"
#include "solvers/meridional/flow_level.hpp"
#include "solvers/meridional/flow_material.hpp"
#include "solvers/meridional/flow_stability.hpp"
#include "solvers/progress.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace searle::solvers::meridional {

/// What secondary flow does to the torque of a bob that turns steadily.
struct InertiaFactor {
    /// Torque with (u_r, u_z) over the torque of the creeping flow of the same fluid at the same
    /// speed, >= 1 in practice; 1 without inertia.
    double factor = 1.0;
    /// Estimate, from levels of resolution; 1 where no level holds the flow, `factor` is 1 then.
    double relative_error = 1.0;
    bool reached{};  ///< as accurate as was asked
    int levels{};    ///< that were solved; 0: none
    long unknowns{}; ///< of the finest level
};

/// Solves for the steady flow around a DIN bob at one speed after another, each from the one before
/// (docs/secondary-flow.md). Newton's method on the flow with inertia; on each level also the
/// creeping flow, so that what both miss at the bob's edges cancels in the ratio. The steady flow
/// is found whether or not it is stable.
class SteadySecondaryFlow {
public:
    /// Work at one speed, in factorisations times unknowns times degree squared, to which their
    /// time is proportional: some twenty seconds, several times what flows that are found take.
    /// Past all onsets no level holds a steady flow, and each would creep on.
    static constexpr double most_work = 6e7;

    /// @param density   kg/m^3, > 0
    /// @param accuracy  asked-for relative error of the torque, > 0
    SteadySecondaryFlow(const geometry::DinBob& bob, const laws::flow::AnyFlowLaw& law,
                        double density, double accuracy);

    /// Best called with rising speeds; the speed of the last call costs nothing.
    /// @param speed  rad/s, > 0. May throw Interrupted.
    /// @param work   after which no further level is begun
    [[nodiscard]] InertiaFactor at(double speed, const ProgressSink& progress = {},
                                   double work = most_work);

    /// Of the flow that the last call found, at its speed.
    [[nodiscard]] LeadingDisturbance leading_disturbance_at(double speed,
                                                            const ProgressSink& progress = {});

    /// The flow of the last call on its finest level, or null before the first.
    [[nodiscard]] FlowLevel* finest();
    [[nodiscard]] long factorisations() const;
    [[nodiscard]] double work() const { return work_; } ///< of all calls, as most_work

private:
    struct Level {
        std::unique_ptr<FlowLevel> flow;
        std::optional<FlowState> creeping; ///< the last one solved for
    };
    [[nodiscard]] ScaledFluid fluid_at(double speed, double rounding) const;
    [[nodiscard]] ScaledFluid fluid_at(double speed, std::size_t level) const {
        return fluid_at(speed, rounding_of(level));
    }
    [[nodiscard]] double rounding_of(std::size_t level) const;
    [[nodiscard]] InertiaFactor solve_at(double speed, const ProgressSink& progress);
    /// Newton's method on a level; false where it fails or this speed's work is used up.
    [[nodiscard]] bool solve_steady(FlowLevel& flow, const FlowMaterial& material,
                                    double tolerance);
    [[nodiscard]] Level& level(std::size_t index);
    /// The state of a level goes from one speed to another in as few steps as Newton's method
    /// allows; false where it gets stuck.
    bool follow(std::size_t level, double from, double to);
    /// The level's state goes from the creeping flow at a speed to the flow there, through shares
    /// of its inertia; false where it gets stuck.
    bool follow_inertia(std::size_t level, double speed);
    /// The level's state becomes that at `speed`, from its last one or from creeping flow.
    bool reach(std::size_t level, double speed);
    /// The level's state becomes the creeping flow at `speed`.
    void creep(std::size_t level, double speed);
    /// Torque of the creeping flow; the level's state stays what it is.
    [[nodiscard]] double creeping_torque(std::size_t level, double speed);

    geometry::DinBob bob_;
    laws::flow::AnyFlowLaw law_;
    double density_;
    double accuracy_;
    std::vector<Level> levels_;
    std::size_t first_level_{};            ///< the coarsest one that holds the flow
    std::optional<double> speed_of_first_; ///< of the state on it
    std::optional<double> stuck_at_;       ///< speed of the state on a level that got no further
    std::size_t last_level_{};
    double work_left_{};                                     ///< of the call under way
    double work_{};                                          ///< of all calls
    std::optional<std::pair<double, InertiaFactor>> latest_; ///< speed and result of the last call
    std::function<void()> report_; ///< of the call under way; may throw Interrupted
};

} // namespace searle::solvers::meridional
