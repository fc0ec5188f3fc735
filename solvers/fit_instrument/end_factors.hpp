#pragma once

#include "geometry/din_bob.hpp"
#include "rheometry/fit/model.hpp"
#include "solvers/fit_instrument/chebyshev_curve.hpp"
#include "solvers/fit_instrument/gap_response.hpp"
#include "solvers/progress.hpp"

#include <optional>
#include <span>
#include <vector>

namespace searle::solvers::fit_instrument {

/// c_L of a DIN bob at a list of speeds for one law, and how it changes with the law's parameters.
struct EndFactors {
    std::vector<double> values; ///< per speed
    /// d ln c_L / d parameter, speed by speed, in the search's coordinates.
    std::vector<double> slopes;
    std::vector<double> search; ///< the parameters that all this belongs to
};

/// c_L of one bob at a list of speeds for whatever law is being tried.
///
/// Its backbone is what c_L would be for a power law with the flow index that the law has at a
/// quarter or so of the rate at the bob, where the fluid at the ends is sheared: within 0.4 % of
/// c_L for Herschel-Bulkley and Casson fluids, 1 % for Bingham ones, 4 % where a viscosity falls
/// as fast as the rate grows. It costs next to nothing for any parameters, and carries the
/// derivatives. What is left, ln c_L minus the backbone, changes slowly with speed and parameters;
/// `solve` finds it from solutions of the creeping flow (docs/axisymmetric.md) at Chebyshev points
/// of ln(speed), doubled until the curve stands. Solutions run side by side on all processors.
class BobEnds {
public:
    /// @param speeds    rad/s, > 0, at least one
    /// @param accuracy  asked-for relative error of c_L
    /// May throw Interrupted, from `progress`, as may solve().
    BobEnds(const geometry::DinBob& bob, std::span<const double> speeds, double accuracy,
            ProgressSink progress);

    /// With what solve() found last; before it: the backbone alone.
    [[nodiscard]] EndFactors at(const rheometry::fit::Model& law,
                                std::span<const double> search) const;
    /// Largest change of the backbone since the last solution; infinite before the first.
    [[nodiscard]] double change_since_solution(const rheometry::fit::Model& law,
                                               std::span<const double> search) const;
    /// @param law  one with Model::for_solvers
    void solve(const rheometry::fit::Model& law, std::span<const double> search);

    /// Of c_L as solved for: the solutions' own error, and between them.
    [[nodiscard]] double relative_error() const { return relative_error_; }
    [[nodiscard]] int solutions() const { return solutions_; }
    [[nodiscard]] bool reached() const { return reached_; }

private:
    [[nodiscard]] std::vector<double> backbone(const rheometry::fit::Model& law,
                                               std::span<const double> search,
                                               const GapCurve& gap) const;
    struct Task {
        laws::flow::AnyFlowLaw law;
        double speed{};
    };
    [[nodiscard]] std::vector<double> solved(const std::vector<Task>& tasks);
    /// ln c_L minus the backbone at points of ln(speed).
    [[nodiscard]] std::vector<double> rest_at(const rheometry::fit::Model& law,
                                              std::span<const double> search,
                                              const std::vector<double>& points);

    geometry::DinBob bob_;
    double accuracy_;
    ProgressSink progress_;
    GapCurve gap_;
    std::optional<ChebyshevCurve> power_laws_; ///< ln c_L over the flow index
    std::optional<ChebyshevCurve> rest_;       ///< over ln(speed)
    std::vector<double> solved_backbone_;      ///< where `rest_` was found
    double relative_error_{};
    int solutions_ = 0;
    bool reached_ = true;
};

} // namespace searle::solvers::fit_instrument
