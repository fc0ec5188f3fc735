#pragma once

#include "rheometry/speed_history.hpp"
#include "solvers/particles/particle_store.hpp"
#include "solvers/particles/shear_box.hpp"
#include "solvers/suspension/checkpoint.hpp"
#include "solvers/suspension/stress_sample.hpp"

#include <functional>
#include <stdexcept>
#include <string>

namespace searle::solvers::suspension {

/// A step that cannot be taken: which particles, and why.
struct StepFailure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Speed of the upper wall (walls), or of the image above (Lees-Edwards), in m/s over time in s.
using WallSpeed = std::function<double(double)>;

/// How many steps of which size were taken.
struct StepCounts {
    long steps{};
    long fluid_steps{};
    long rebuilds{};
    double shortest_step{}; ///< s
    double longest_step{};  ///< s
    long solver_iterations{};
};

/// A suspension that moves on in time. Called once for some steps at a time.
class SuspensionMotion {
public:
    virtual ~SuspensionMotion() = default;
    /// Takes one coupling interval, shortened so that it does not pass `until`.
    /// @return the means over it
    virtual StressSample advance(const WallSpeed& speed, double until) = 0;

    /// All of its state; a motion of the same input that is restored goes on bit for bit.
    virtual void save(Checkpoint& into) const = 0;
    virtual void restore(const Checkpoint& from) = 0;

    [[nodiscard]] virtual double time() const = 0;
    [[nodiscard]] virtual const particles::ParticleStore& particles() const = 0;
    [[nodiscard]] virtual const particles::ShearBox& box() const = 0;
    [[nodiscard]] virtual StepCounts counts() const = 0;
    /// Mean velocity of the fluid at equal distances from wall to wall, m/s; empty without walls.
    [[nodiscard]] virtual std::vector<double> fluid_velocity() const = 0;
};

} // namespace searle::solvers::suspension
