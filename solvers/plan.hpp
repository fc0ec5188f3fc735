#pragma once

#include "solvers/scene.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace searle::solvers {

/// One thing that the plan leaves out or brings in, with the number that decided.
struct PlanItem {
    std::string what;   ///< "inertia", "ends", "Taylor vortices", "mesh", ...
    bool solved{};      ///< false: skipped
    std::string reason; ///< a full sentence that holds the number
};

/// Onset of Taylor vortices in the annulus with a turning bob or rotor inside and the cup at rest,
/// with Re = R_bob omega d / nu, nu that of the apparent viscosity at the bob's wall.
struct TaylorOnset {
    /// Of this fluid in the flow of the row with the largest Re / Re_critical. Where no row needs
    /// the linear problem (basis says so) that of a Newtonian fluid that fills the gap.
    double critical_reynolds{};
    /// Re of that row; where critical_reynolds is a Newtonian fluid's, with the viscosity of
    /// `basis`.
    double reynolds{};
    /// Axial wave number times gap at the onset.
    double wave_number{};
    /// Largest Re / Re_critical of the rows; where the gap is partly sheared, of the sheared layer.
    double largest_ratio{};
    double relative_error{}; ///< numerical, of the onset (critical_speed where there is one)
    /// Speed of the bob or rotor at the onset, rad/s, also beyond the rows' speeds; absent where
    /// none was found or looked for.
    std::optional<double> critical_speed;
    /// The conversion's shear rate at critical_speed, 1/s.
    std::optional<double> onset_shear_rate;
    std::string basis; ///< what the numbers rest on, a full sentence
};

/// How much more than the plan's estimate of an effect is claimed as error where it is left out.
inline constexpr double left_out_margin = 3.0;

/// What holds at one row of the result.
struct RowForecast {
    /// s; for a steady series the estimated time at which an instrument that goes through the
    /// series from rest is steady to the asked accuracy at this row.
    double time{};
    double speed{};
    double shear_rate{};
    double steady_stress{}; ///< the conversion's stress without inertia, Pa, sign of the speed
    std::string regime;     ///< see solvers/regime.hpp
    double taylor_ratio{};  ///< Re / Re_critical; 0 for the box
    /// Estimated part of the stress that is inertia: |inertial| / (|steady| + |inertial|), 0 ... 1.
    double lag_share{};
    /// The same, no less than that of the slowest part of the fluid: of a bob, what stands above
    /// and below it.
    double largest_lag_share{};
    /// Estimated part of the torque that is secondary flow at a bob's ends, 0 ... 1.
    double end_flow_share{};
    double end_reynolds{}; ///< omega R^2 / nu at a bob with ends, nu at its wall; 0 without ends
};

struct Plan {
    std::string model; ///< "radial steady", "radial transient", "axisymmetric", ...
    std::string model_reason;
    bool transient{};
    /// The flow in r and z around a DIN bob's ends is solved for, too.
    bool secondary_flow{};
    /// Taylor vortices in the gap outside the rotor are solved for, too.
    bool vortices{};
    bool can_be_solved =
        true; ///< false: nothing in this program solves it yet; model_reason says why
    std::vector<PlanItem> items;
    std::optional<TaylorOnset> taylor; ///< absent for the box
    std::vector<RowForecast> rows;
    std::vector<std::string> warnings;
    double expected_seconds{}; ///< of one thread; right within a factor of about five
    long expected_unknowns{};
};

/// Plans a scene without solving its time dependence. Cost: milliseconds (a steady solve per row,
/// or for more than SteadyCurve::direct_limit rows a few hundred in all; docs/plan.md).
[[nodiscard]] Plan make_plan(const Scene& scene);

/// Time after which the stress is steady to `accuracy` (relative) when the speed jumps between two
/// steady values, s, >= 0; estimated with the inertia and the slowest decay of the linearised flow
/// at the two speeds. After a jump to rest "relative" means: to the stress before.
[[nodiscard]] double settling_time(const geometry::Instrument& instrument, const Fluid& fluid,
                                   double from_speed, double to_speed, double accuracy);

/// For a steady series that starts from rest: the times at which each row's stress is steady, s,
/// increasing; the sums of settling_time from row to row. Fast for any number of rows.
[[nodiscard]] std::vector<double> settling_times(const geometry::Instrument& instrument,
                                                 const Fluid& fluid, std::span<const double> speeds,
                                                 double accuracy);

} // namespace searle::solvers
