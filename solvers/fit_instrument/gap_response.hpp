#pragma once

#include "rheometry/fit/model.hpp"
#include "solvers/radial/annular_gap.hpp"

#include <span>
#include <vector>

namespace searle::solvers::fit_instrument {

/// Steady flow in one gap at one speed: the stress at its inner wall, and its derivatives.
struct GapResponse {
    double inner_stress{};           ///< Pa
    std::vector<double> derivatives; ///< by the law's search coordinates; empty: not wanted
    double slip_derivative{};        ///< by the slip coefficient
    double inner_rate{};             ///< 1/s
    bool partly_sheared{};
};

/// The gap for many speeds and parameters. With a slip coefficient b the fluid slides along both
/// walls at b times the stress there.
///
/// Speed of the walls past each other, from the stress tau at the inner wall (docs/radial.md):
///   omega = 1/2 integral rate(q)/q dq over max(yield, tau/delta^2) ... tau
///           + b tau (1/R_inner + 1/(delta^2 R_outer)).
/// The derivative by a parameter at fixed tau is -1/2 integral rate (d stress/d parameter)/stress
/// d ln(rate), which needs the law's own derivatives only and has no singular end; at fixed speed
/// it is divided by -d omega/d tau = -(rate_inner - rate_outer)/(2 tau) - slip.
class GapCurve {
public:
    GapCurve(radial::AnnularGap gap, std::vector<double> speeds)
        : gap_(gap), speeds_(std::move(speeds)), log_rate_(speeds_.size()) {}

    [[nodiscard]] std::span<const double> speeds() const { return speeds_; }
    /// @param search  the law's parameters in the search's coordinates
    /// @param slip    m/(Pa s), >= 0
    /// No value at a speed: NaN stress.
    [[nodiscard]] GapResponse at(std::size_t index, const rheometry::fit::Model& law,
                                 std::span<const double> search, double slip,
                                 bool derivatives) const;

private:
    radial::AnnularGap gap_;
    std::vector<double> speeds_; ///< rad/s, > 0
    /// Where the last solution lay; 0: nowhere yet.
    mutable std::vector<double> log_rate_;
};

} // namespace searle::solvers::fit_instrument
