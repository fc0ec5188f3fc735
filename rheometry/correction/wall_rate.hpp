#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace searle::rheometry {

/// How far the shear reaches into the gap.
enum class GapBranch {
    sheared,        ///< the fluid moves from wall to wall
    partly_sheared, ///< next to the cup it rests: the stress there is below the yield stress
    unknown         ///< the data do not tell
};

/// sheared, partly-sheared or unknown.
[[nodiscard]] std::string_view name_of(GapBranch branch);

/// What one row of a measured curve says about the wall of the bob.
struct WallRate {
    /// True shear rate at the bob, 1/s, with the sign of the speed; NaN where the data do not give
    /// it.
    double rate{};
    /// One standard error of `rate`, 1/s: scatter of the data, and what the inversion leaves out.
    double standard_error{};
    GapBranch branch = GapBranch::unknown;
};

struct WallRates {
    std::vector<WallRate> rows; ///< in the order of the data
    /// Yield stress that the slow end of the curve extrapolates to, Pa, and its standard error; no
    /// value when there is none that stands out from the scatter.
    std::optional<double> yield_stress;
    double yield_standard_error{};
};

/// Nothing known, for as many rows.
[[nodiscard]] WallRates no_rates(std::size_t rows);

/// True shear rate at the bob of a single gap from measured speeds and stresses alone, for any
/// fluid that flows steadily and does not slip (docs/conversion.md).
///
/// The slope of the curve comes from local_slopes. Where the gap is sheared from wall to wall the
/// rate is Krieger's (power law near each point, with the change of its exponent) or, where that is
/// the more certain of the two, the exact step 2 tau domega/dtau + rate(tau_cup) with the rate
/// found before at the lower stress tau_cup. Where the fluid at the cup rests it is 2 tau
/// domega/dtau. Which holds is decided by a yield stress fitted to the slow end of the curve;
/// within two standard errors of it the branch is unknown and the rate is the mean of both, the
/// standard error covering them.
///
/// Rows at rest, or whose torque does not resist, give no rate. Fewer than 5 different speeds, or
/// speeds within a factor of 1.5, give none at all: the slope of the curve is not known then.
/// @param speeds        rad/s; ups and downs are taken as one curve
/// @param bob_stresses  Pa, as many, with the sign of the speed
/// @param delta         R_cup / R_bob, > 1
[[nodiscard]] WallRates wall_rates(std::span<const double> speeds,
                                   std::span<const double> bob_stresses, double delta);

} // namespace searle::rheometry
