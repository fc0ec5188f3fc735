#pragma once

#include "geometry/mesh_settings.hpp"
#include "rheometry/schedule.hpp"
#include "solvers/plan.hpp"
#include "solvers/scene.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace searle::solvers::openfoam {

/// How a scene is given to OpenFOAM.
struct FoamPlan {
    FoamApplication application = FoamApplication::pimple_foam;
    std::string application_reason; ///< a clause that holds the reason
    bool steady{};                  ///< row after row until it stands still; else in time
    /// A protocol in time whose rows are solved as steady ones: inertia is in the error bar.
    bool quasi_steady{};
    /// Speeds of the steady rows, rad/s (m/s of a box's wall); or the drive's history in time.
    rheometry::SteadySpeeds speeds;
    rheometry::SpeedHistory history;
    /// Time that the first speed is held before the history starts, s: a ramp that follows a long
    /// hold. OpenFOAM's time is the history's plus this.
    double hold{};
    /// Dynamic, Pa s. Without use for laws of bounded viscosity.
    double viscosity_cap{};
    /// Relative error of a partly sheared row's torque that is claimed for the cap, one a row.
    std::vector<double> cap_error;
    /// Nothing but the swirl (a box: the velocity along the flow) is to be found: no pressure acts
    /// on it, and pimpleFoam corrects none.
    bool swirl_alone{};
    /// The secondary flow at a rotor's ends matters too little to be solved for, or the case
    /// leaves it out, and the program does: swirl_alone.
    bool end_flow_left_out{};
    /// The mesh is a wedge, or a box one cell long: no periodic sides that a correction late sees.
    bool one_cell_along{};
    /// Not all cells are orthogonal: around cones, and of triangles.
    bool skew_cells{};
    int outer_corrections = 3;    ///< of pimpleFoam in a time step
    int pressure_corrections = 2; ///< of pimpleFoam in each of them, where there is a pressure
    /// Relaxation factor of the velocity: of simpleFoam, and of pimpleFoam before a time step's
    /// last correction; 0: none.
    double relaxation{};
    double pressure_relaxation = 1.0; ///< the same of the pressure; 1: none
    int iterations{};                 ///< most of simpleFoam for a row
    double residual = 1e-7;           ///< of the velocity with which a row of simpleFoam ends
    /// Steady rows in one run: the iteration with which each ends. Empty: a run for each row.
    std::vector<long> row_ends;
    int levels{};         ///< most levels of refinement, >= 2
    int coarsest_cells{}; ///< across the gap, on the first level; twice that on each further
    /// Around an eccentric bob, on the first level, and twice that on each further; 0: as many on
    /// all levels, for the flow is alike in every direction.
    int coarsest_angular_cells{};
    double coarsest_step{}; ///< s, on the first level; half of that on each further
    /// Taylor vortices are to grow: cells along the axis too, and a disturbance to grow from.
    bool vortices{};
    double vortex_height{}; ///< m, one vortex: half of the wavelength
};

/// What is left, over the asked accuracy, of the start from rest when the first speed was held.
inline constexpr double hold_share = 1e-3;

/// How often a run that is not row by row writes its fields, for a restart and for a look at the
/// end.
inline constexpr double writes_in_a_run = 20.0;

/// Whether each steady row is a run of its own, ended where it stands still.
[[nodiscard]] inline bool runs_row_by_row(const FoamPlan& plan) {
    return plan.steady && plan.row_ends.empty();
}

/// What inertia may do to a row that is solved without it, over its torque.
[[nodiscard]] double left_out_inertia(const Scene& scene, const RowForecast& row);

/// OpenFOAM's time, an iteration's number, with which a steady row ends.
[[nodiscard]] inline double end_of_row(const FoamPlan& plan, std::size_t row) {
    return plan.row_ends.empty()
               ? static_cast<double>(plan.iterations) * static_cast<double>(row + 1)
               : static_cast<double>(plan.row_ends[row]);
}

/// The same with which it starts: that with which the row before ends.
[[nodiscard]] inline double start_of_row(const FoamPlan& plan, std::size_t row) {
    return row == 0 ? 0.0 : end_of_row(plan, row - 1);
}

/// The name of the program.
[[nodiscard]] std::string_view name_of(FoamApplication application);

/// @param plan  of the same scene: rows, regimes, vortices
/// Throws UnsuitableScene where OpenFOAM cannot do what the case asks for.
[[nodiscard]] FoamPlan plan_foam(const Scene& scene, const Plan& plan);

/// What is meshed on a level, 0 the coarsest. The case's own [mesh] has precedence; its cells are
/// those of the finest level.
[[nodiscard]] geometry::MeshSettings mesh_settings(const Scene& scene, const FoamPlan& plan,
                                                   int level);

/// The plan's words and cost for this engine, put into `plan`.
void describe(const Scene& scene, const FoamPlan& foam, Plan& plan);

} // namespace searle::solvers::openfoam
