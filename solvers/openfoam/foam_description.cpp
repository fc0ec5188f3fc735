#include "laws/gap/eccentric_cylinders.hpp"
#include "solvers/openfoam/foam_plan.hpp"
#include "solvers/plan_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace searle::solvers::openfoam {
namespace {

void describe_offset(const geometry::ConcentricCylinders& gap, Plan& plan) {
    const double ratio =
        laws::gap::EccentricCylinders{gap.bob_radius, gap.cup_radius, gap.offset}.torque_ratio();
    plan.items.push_back(
        {"offset", true,
         fmt::format("The bob's axis is {:.4g} mm, {:.4g} of the gap, off the cup's: a slice one "
                     "cell high of the whole turn. A Newtonian fluid in creeping flow has {:.6g} "
                     "times the torque of a centred bob (exact); forecasts of inertia, regime and "
                     "the onset of Taylor vortices are those of the centred bob.",
                     1e3 * gap.offset, gap.offset / gap.gap(), ratio)});
    plan.warnings.push_back(
        fmt::format("The conversion takes the bob as centred: by its offset of {:.4g} of the gap a "
                    "Newtonian fluid in creeping flow reads {:.4g} % too thick.",
                    gap.offset / gap.gap(), 100.0 * (ratio - 1.0)));
}

/// Says that inertia is left out, in place of what holds for the native engine.
void leave_out_inertia(const Scene& scene, Plan& plan) {
    double largest = 0.0;
    for (const RowForecast& row : plan.rows)
        largest = std::max(largest, left_out_inertia(scene, row));
    for (PlanItem& item : plan.items)
        if (item.what == "inertia")
            item = {
                "inertia", false,
                fmt::format("Each row is a steady flow; up to {:.2g} % of the stress is claimed "
                            "for the inertia that is left out.",
                            100.0 * largest)};
}

} // namespace

void describe(const Scene& scene, const FoamPlan& foam, Plan& plan) {
    plan.transient = !foam.steady;
    if (foam.quasi_steady)
        leave_out_inertia(scene, plan);
    plan.model = fmt::format("openfoam {}", name_of(foam.application));
    plan.model_reason = fmt::format(
        "OpenFOAM's {}: {}; {}; {} to {} cells across the gap{}.", name_of(foam.application),
        foam.application_reason,
        is_box(scene)                     ? "one cell along the flow and the width"
        : foam.coarsest_angular_cells > 0 ? "the whole turn, one cell high"
        : foam.end_flow_left_out          ? "the mesh of searle mesh, the swirl alone"
        : !foam.swirl_alone               ? "the mesh of searle mesh"
        : !foam.one_cell_along            ? "a sector or the whole turn, one cell high"
        : foam.skew_cells                 ? "a wedge of prisms, the swirl alone"
                                          : "a wedge one cell thick and one cell high",
        mesh_settings(scene, foam, 0).cells_across_gap.value_or(0),
        mesh_settings(scene, foam, foam.levels - 1).cells_across_gap.value_or(0),
        foam.steady ? ""
                    : fmt::format(", time steps of {:.3g} to {:.3g} s", foam.coarsest_step,
                                  std::ldexp(foam.coarsest_step, 1 - foam.levels)));
    const double finest_step = std::ldexp(foam.coarsest_step, 1 - foam.levels);
    if (scene.solver.time_step && !foam.steady && finest_step < 0.999 * *scene.solver.time_step)
        plan.warnings.push_back(fmt::format(
            "solver.time_step = {:.4g} s is shortened to {:.4g} s, so that every row ends a step.",
            *scene.solver.time_step, finest_step));
    plan.items.push_back(
        {"grid error", true,
         "Levels of twice the cells and half the time step follow each other until "
         "the difference of the last two, which is claimed as error, meets the "
         "asked accuracy."});
    if (geometry::is_eccentric(scene.instrument))
        describe_offset(std::get<geometry::ConcentricCylinders>(scene.instrument), plan);
    if (foam.viscosity_cap > 0.0)
        plan.items.push_back(
            {"yield surface", false,
             fmt::format("OpenFOAM lets unyielded fluid creep at {:.3g} Pa s "
                         "(solver.viscosity_cap); up to {:.2g} % of the torque is claimed for it.",
                         foam.viscosity_cap,
                         100.0 * std::ranges::max(foam.cap_error.empty() ? std::vector{0.0}
                                                                         : foam.cap_error))});
    const bool has_section = scene.profile || geometry::has_ends(scene.instrument);
    if (scene.solver.secondary_flow == Switch::off && has_section && !foam.end_flow_left_out)
        plan.warnings.push_back(fmt::format(
            "solver.secondary_flow = false has no effect here: {} solves for the secondary flow{}.",
            name_of(foam.application),
            scene.profile ? "" : "; pimpleFoam in a wedge leaves it out"));
    const double across = mesh_settings(scene, foam, 1).cells_across_gap.value_or(40);
    const double cells =
        across * (foam.vortices                     ? across
                  : has_section                     ? 15.0 * across
                  : foam.coarsest_angular_cells > 0 ? 2.0 * foam.coarsest_angular_cells
                  : foam.skew_cells                 ? 2.0 * across
                                                    : 1.0);
    const double rows = static_cast<double>(foam.speeds.speeds.size());
    const double steps = runs_row_by_row(foam) ? 2000.0 * rows
                         : foam.steady         ? end_of_row(foam, foam.speeds.speeds.size() - 1)
                                               : (foam.hold + foam.history.duration()) /
                                             (0.5 * foam.coarsest_step) * foam.outer_corrections;
    plan.expected_unknowns = std::lround(4.0 * cells);
    plan.expected_seconds = 1.3 * steps * (2e-4 + 8e-6 * cells);
}

} // namespace searle::solvers::openfoam
