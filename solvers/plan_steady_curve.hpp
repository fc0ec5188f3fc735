#pragma once

#include "geometry/instrument.hpp"
#include "solvers/plan_inertia.hpp"
#include "solvers/scene.hpp"

#include <array>
#include <map>
#include <span>
#include <vector>

namespace searle::solvers {

/// One gap of an instrument as the plan sees it: an annulus, or the box's plane gap.
struct InstrumentGap {
    radial::AnnularGap annulus; ///< unused for the plane gap
    TurningWall wall = TurningWall::inner;
    double plane_width{};         ///< > 0 for the plane gap, else 0
    double torque_per_stress{};   ///< torque (N m) per stress at the inner wall (Pa); box: N per Pa
    double torque_per_response{}; ///< instrument's inertia per GapResponse::inertia

    [[nodiscard]] double width() const { return plane_width > 0.0 ? plane_width : annulus.width(); }
};

/// One or two gaps; the last is the one that the conversion is defined with.
[[nodiscard]] std::vector<InstrumentGap> gaps_of(const geometry::Instrument& instrument);

/// The steady flow in one gap at one speed, and how it answers to a change.
struct GapState {
    double inner_stress{}; ///< Pa, at the inner wall
    double inner_rate{};   ///< 1/s, at the inner wall
    GapResponse response{};
};

/// The steady flow of an endless instrument at one speed (magnitude).
struct SteadyState {
    double torque{};
    std::array<GapState, 2> gaps{};
    /// How the fluid below and above the rotor answers; zeros without ends. Its torque is not in
    /// `torque`.
    std::array<GapResponse, 2> chambers{};
};

/// Steady flows of one instrument and fluid at many speeds: each is solved once; beyond
/// `direct_limit` speeds they are interpolated (cubic in logarithms, relative error of the stress
/// about 1e-5, at most 1e-4 where a gap turns from partly to wholly sheared).
class SteadyCurve {
public:
    static constexpr std::size_t direct_limit = 600;

    /// @param speeds  the speeds that will be asked for; any sign, zeros are ignored
    SteadyCurve(const geometry::Instrument& instrument, const Fluid& fluid,
                std::span<const double> speeds);

    /// @param speed  any sign; magnitudes below the smallest announced one are taken as that one
    [[nodiscard]] const SteadyState& at(double speed);

    [[nodiscard]] const std::vector<InstrumentGap>& gaps() const { return gaps_; }
    /// True when no speed but zero was announced.
    [[nodiscard]] bool at_rest_only() const { return !(largest_ > 0.0); }
    [[nodiscard]] double largest_speed() const { return largest_; }
    /// Below it nothing turns; 0 without a yield stress.
    [[nodiscard]] double yield_torque() const;

private:
    [[nodiscard]] SteadyState solve(double speed) const;
    [[nodiscard]] SteadyState interpolate(double speed) const;

    geometry::Instrument instrument_;
    Fluid fluid_;
    std::vector<InstrumentGap> gaps_;
    bool linear_{}; ///< Newtonian: one solve, scaled
    double smallest_{};
    double largest_{};
    std::vector<SteadyState> nodes_; ///< logarithms of every value; empty: solve directly
    double log_spacing_{};
    SteadyState linear_state_{}; ///< at 1 rad/s
    SteadyState current_{};
    std::map<double, SteadyState> solved_;
};

} // namespace searle::solvers
