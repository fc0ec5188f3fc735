#pragma once

#include "solvers/meridional/steady_secondary_flow.hpp"

#include <cmath>
#include <complex>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>

namespace searle::solvers::meridional {

/// What secondary flow does to the steady torque of one bob and fluid over a range of speeds:
/// solved at each speed, or for many speeds at Chebyshev points in ln speed, whose number is
/// doubled until the curve no longer moves.
class InertiaFactorCurve {
public:
    static constexpr std::size_t usual_most_direct = 6;

    /// @param speeds    rad/s; signs are left out, zeros are skipped
    /// @param accuracy  asked-for relative error of the torque
    /// @param most_direct  up to so many distinct speeds each is solved at
    /// Interrupted by `progress`: what was solved is kept, see has().
    InertiaFactorCurve(const geometry::DinBob& bob, const laws::flow::AnyFlowLaw& law,
                       double density, std::span<const double> speeds, double accuracy,
                       const ProgressSink& progress, std::size_t most_direct = usual_most_direct);

    /// Whether at() may be asked for this speed; true for all unless interrupted.
    [[nodiscard]] bool has(double speed) const {
        return !interrupted_ || (!interpolates_ && solved_.contains(std::abs(speed)));
    }
    [[nodiscard]] bool interrupted() const { return interrupted_; }
    /// At one of the speeds given, != 0.
    [[nodiscard]] InertiaFactor at(double speed) const;

    [[nodiscard]] std::size_t solutions() const { return solved_.size(); }
    [[nodiscard]] int levels() const { return levels_; }
    [[nodiscard]] long unknowns() const { return unknowns_; }
    [[nodiscard]] long factorisations() const { return flow_.factorisations(); }
    /// Of the flow solved for last, on its finest level; without lines when there was none.
    [[nodiscard]] axisymmetric::SectionDivision division();
    /// The velocities at a speed, > 0, or null where no flow is found. May throw Interrupted.
    [[nodiscard]] FlowLevel* flow_at(double speed, const ProgressSink& progress);
    /// Growth of the leading axisymmetric disturbance of the steady flow at a speed, 1/s (real
    /// part) and rad/s (imaginary part); nothing where it cannot be told. Solves for the flow
    /// again. May throw Interrupted.
    [[nodiscard]] std::optional<std::complex<double>>
    disturbance_rate(double speed, const ProgressSink& progress);

private:
    void solve_all(const ProgressSink& progress);
    void solve(double speed, const ProgressSink& progress);
    [[nodiscard]] InertiaFactor solve_within_bounds(double speed, const ProgressSink& progress);
    [[nodiscard]] double interpolated(double speed) const;

    std::set<double> distinct_; ///< magnitudes of the speeds, without 0
    bool interpolates_;
    double accuracy_;
    SteadySecondaryFlow flow_;
    std::map<double, InertiaFactor> solved_;
    bool interrupted_{};
    double interpolation_error_{};
    int levels_{};
    long unknowns_{};
};

} // namespace searle::solvers::meridional
