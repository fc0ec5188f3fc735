#pragma once

#include <vector>

namespace searle::solvers::stability {

/// The Taylor threshold for every gap up to a widest one: for a gap of which only a layer of
/// varying width is sheared. Chebyshev interpolation of ln(Re_c sqrt(e)) in ln(1 + e), e the
/// relative gap, relative error below 1e-6 up to e = 19: 4 points up to e = 0.1, 6 up to 0.6, else
/// 9. Making one costs 0.3 ms for a narrow gap, a few milliseconds at most.
class ThresholdCurve {
public:
    /// @param widest_relative_gap  d / R_bob, > 0
    explicit ThresholdCurve(double widest_relative_gap);

    /// Critical R_bob omega d / nu.
    /// @param relative_gap  d / R_bob, 0 < relative_gap <= the widest
    [[nodiscard]] double critical_reynolds(double relative_gap) const;

private:
    std::vector<double> nodes_;
    std::vector<double> values_;
};

} // namespace searle::solvers::stability
