#pragma once

#include "laws/flow/flow_law.hpp"
#include "solvers/radial/annular_gap.hpp"
#include "solvers/stability/layer_onset.hpp"

#include <optional>
#include <vector>

namespace searle::solvers::stability {

/// The linear onset of vortices of one fluid in one gap over a range of speeds: solved at a few
/// Chebyshev points in ln(speed), their number doubled until what lies between is foretold.
class OnsetCurve {
public:
    /// @param slowest, fastest  rad/s, 0 < slowest <= fastest
    /// @param tolerance         asked relative error of the critical Reynolds number, > 0
    OnsetCurve(const radial::AnnularGap& gap, laws::flow::AnyFlowLaw law, double slowest,
               double fastest, double tolerance);

    /// LayerOnset::reynolds at a speed; below the slowest and above the fastest what it is there.
    [[nodiscard]] double critical_reynolds(double speed) const;
    /// Largest relative error of critical_reynolds: of the eigenvalues and of what lies between.
    [[nodiscard]] double relative_error() const { return relative_error_; }
    /// Eigenvalue problems (each minimised over the wave number) that it took.
    [[nodiscard]] int solved() const { return solved_; }

private:
    struct Point {
        double speed;
        double reynolds;
    };
    [[nodiscard]] double solve(double speed);

    radial::AnnularGap gap_;
    laws::flow::AnyFlowLaw law_;
    double tolerance_;
    std::vector<Point> points_;
    double relative_error_{};
    int solved_{};
};

/// The speed at which a fluid reaches its onset, and the onset there.
struct CriticalSpeed {
    double speed{};          ///< rad/s
    double relative_error{}; ///< of the speed: of the eigenvalue and of the search
    LayerOnset onset;
};

/// Solves density = critical density for the speed, to a relative 1e-6; absent when the onset is
/// not within a factor of a thousand of the guess (a fluid that thickens may have none).
/// @param density  kg/m^3, > 0
/// @param guess    rad/s, > 0
[[nodiscard]] std::optional<CriticalSpeed> critical_speed(const radial::AnnularGap& gap,
                                                          const laws::flow::AnyFlowLaw& law,
                                                          double density, double guess,
                                                          double tolerance);

} // namespace searle::solvers::stability
