#include "solvers/openfoam/foam_plan.hpp"

#include "geometry/eccentric_annulus.hpp"
#include "geometry/mesh_choices.hpp"
#include "laws/flow/flow_law.hpp"
#include "rheometry/conversion/conversion.hpp"
#include "solvers/openfoam/convergence_plan.hpp"
#include "solvers/openfoam/installation.hpp"
#include "solvers/openfoam/viscosity_cap.hpp"
#include "solvers/plan_rows.hpp"
#include "solvers/unsuitable_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace searle::solvers::openfoam {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Of a profile the instrument is but what its torques are converted with.
bool is_endless(const Scene& scene) {
    return !scene.profile && !geometry::has_ends(scene.instrument);
}

/// The single gap whose bob is off the cup's axis; null for everything else.
const geometry::ConcentricCylinders* eccentric_gap(const Scene& scene) {
    return geometry::is_eccentric(scene.instrument)
               ? &std::get<geometry::ConcentricCylinders>(scene.instrument)
               : nullptr;
}

/// Whether the flow is the same at every height: without ends, vortices and offset.
bool is_slice(const Scene& scene, bool has_vortices) {
    return is_endless(scene) && !has_vortices && eccentric_gap(scene) == nullptr;
}

/// Whether a protocol in time is solved as steady rows: in a section, where steps far beyond the
/// cells' diffusion times are dear and may diverge, and where what inertia may do takes no more
/// than half of the accuracy.
bool is_quasi_steady(const Scene& scene, const Plan& plan) {
    if (scene.profile || plan.vortices || is_slice(scene, plan.vortices))
        return false;
    return std::ranges::all_of(plan.rows, [&scene](const RowForecast& row) {
        return row.speed != 0.0 && left_out_inertia(scene, row) <= 0.5 * scene.solver.accuracy;
    });
}

void choose_application(const Scene& scene, const Plan& plan, FoamPlan& foam) {
    const bool is_series = std::holds_alternative<rheometry::SteadySpeeds>(rheometry::schedule(
        scene.protocol, rheometry::conversion_for(scene.instrument, scene.conversion)));
    const bool wants_time = !is_series || plan.vortices;
    if (!scene.solver.application) {
        foam.quasi_steady = wants_time && is_quasi_steady(scene, plan);
        foam.steady = !wants_time || foam.quasi_steady;
        foam.application =
            foam.steady ? FoamApplication::simple_foam : FoamApplication::pimple_foam;
        foam.application_reason =
            foam.quasi_steady ? "inertia takes less than half of the asked accuracy (the error bar "
                                "has it), so each row is a steady flow"
            : foam.steady     ? "every row is held until steady"
                              : "the protocol is in time, with outer corrections in each step";
        return;
    }
    foam.application = *scene.solver.application;
    foam.steady = foam.application == FoamApplication::simple_foam ||
                  (foam.application == FoamApplication::pimple_foam && !wants_time);
    foam.application_reason = "the case asks for it";
    if (foam.steady && !is_series)
        throw UnsuitableScene("solver.application = \"simpleFoam\" solves steady rows; this "
                              "protocol is in time: pimpleFoam, or steps with hold = \"steady\"");
    if (!foam.steady && is_series)
        throw UnsuitableScene(
            fmt::format("solver.application = \"{}\" solves in time; steps with hold = \"steady\" "
                        "have none: simpleFoam, or a hold in seconds",
                        name_of(foam.application)));
    if (foam.application == FoamApplication::ico_foam && !is_newtonian(scene))
        throw UnsuitableScene("solver.application = \"icoFoam\" is for Newtonian fluids; "
                              "pimpleFoam has the other laws");
}

/// The largest step that meets all rows and corners, a whole fraction of the shortest stretch
/// between them; where there is none (uneven rows) an eighth of that stretch.
double common_step(const rheometry::SpeedHistory& history) {
    std::vector<double> events = history.row_times;
    for (const rheometry::SpeedHistory::Piece& piece : history.pieces)
        events.push_back(piece.end_time);
    std::ranges::sort(events);
    double shortest = history.duration();
    double before = 0.0;
    for (const double time : events) {
        if (time - before > 1e-9 * history.duration())
            shortest = std::min(shortest, time - before);
        before = time;
    }
    for (int parts = 1; parts <= 64; ++parts) {
        const double step = shortest / parts;
        if (std::ranges::all_of(events, [step](double time) {
                return std::abs(time / step - std::round(time / step)) < 1e-6;
            }))
            return step;
    }
    return shortest / 8.0;
}

/// Whether the secondary flow at a rotor's ends is too weak to be solved for, or the case leaves it
/// out.
bool leaves_out_end_flow(const Scene& scene, const Plan& plan) {
    if (scene.profile || !geometry::has_ends(scene.instrument))
        return false;
    return scene.solver.secondary_flow == Switch::automatic
               ? !end_flow_matters(plan.rows, scene.solver.accuracy)
               : scene.solver.secondary_flow == Switch::off;
}

/// Whether the swirl alone is to be found: around a centred rotor without ends, or where the
/// secondary flow at its ends is left out; and how long a cell is. In a wedge that holds on every
/// mesh, in time in the whole turn, too, where a slice is one cell high; steady rows, and programs
/// that always correct the pressure, are iterated as a flow in two directions where there are cells
/// in two.
void find_swirl(const Scene& scene, const Plan& plan, FoamPlan& foam) {
    const geometry::MeshSettings mesh = mesh_settings(scene, foam, 0);
    const bool may_leave_out = leaves_out_end_flow(scene, plan);
    const auto cells = mesh.cells.value_or(geometry::CellStyle::hexahedra);
    const bool is_endless_mesh = is_slice(scene, foam.vortices) && !mesh.floor_clearance;
    const bool one_cell_high = mesh.axial_cells.value_or(mesh.slice_height ? 1 : 0) == 1 &&
                               cells == geometry::CellStyle::hexahedra;
    foam.one_cell_along = mesh.angular_cells.value_or(1) == 1 &&
                          cells != geometry::CellStyle::tetrahedra &&
                          (is_box(scene) || extent_of(mesh) == geometry::MeshExtent::wedge);
    foam.skew_cells =
        geometry::has_ends(scene.instrument) || cells != geometry::CellStyle::hexahedra;
    // Steady rows of a wedge, left to this plan, become pimpleFoam's (choose_time).
    const bool may_leave_pressure = foam.application == FoamApplication::pimple_foam ||
                                    (foam.one_cell_along && !scene.solver.application);
    if (!foam.one_cell_along)
        foam.swirl_alone = ((is_endless_mesh && one_cell_high) || may_leave_out) && !foam.steady &&
                           may_leave_pressure;
    else if (is_endless_mesh && !foam.skew_cells)
        foam.swirl_alone = true;
    else
        foam.swirl_alone = (is_endless_mesh || may_leave_out) && may_leave_pressure;
    foam.end_flow_left_out = may_leave_out && foam.swirl_alone;
}

void choose_time(const Scene& scene, const Plan& plan, FoamPlan& foam) {
    const auto conversion = rheometry::conversion_for(scene.instrument, scene.conversion);
    const auto schedule = rheometry::schedule(scene.protocol, conversion);
    const auto* series = std::get_if<rheometry::SteadySpeeds>(&schedule);
    if (series != nullptr || foam.quasi_steady) {
        if (series != nullptr)
            foam.speeds = *series;
        else
            for (const RowForecast& row : plan.rows)
                foam.speeds.speeds.push_back(row.speed);
        if (!plan.vortices) {
            foam.iterations =
                geometry::has_ends(scene.instrument) || geometry::is_eccentric(scene.instrument)
                    ? 20'000
                    : 10'000;
            const bool may_be_one_run =
                foam.application == FoamApplication::pimple_foam || !scene.solver.application;
            if (foam.swirl_alone && may_be_one_run) {
                foam.application = FoamApplication::pimple_foam;
                foam.application_reason = "every row is iterated until steady, on the swirl alone";
                foam.row_ends = row_ends(scene, foam);
                foam.relaxation = 0.0;
            } else if (foam.application == FoamApplication::pimple_foam) {
                throw UnsuitableScene(
                    "solver.application = \"pimpleFoam\" has steady rows of the swirl alone, in a "
                    "wedge; of this flow or mesh: simpleFoam, or a hold in seconds");
            }
            return;
        }
        throw UnsuitableScene("Taylor vortices need time to grow: OpenFOAM solves steady rows past "
                              "their onset as steps with a hold in seconds");
    }
    if (conversion.end_factor_provisional)
        throw UnsuitableScene(
            "conversion.end_factor = \"computed\" takes c_L from steady rows with "
            "solver.engine = \"openfoam\"; a protocol in time needs a number, or "
            "engine = \"native\"");
    foam.history = std::get<rheometry::SpeedHistory>(schedule);
    if (foam.history.initial_speed != 0.0)
        foam.hold = settling_time(scene.instrument, scene.fluid, 0.0, foam.history.initial_speed,
                                  hold_share * scene.solver.accuracy);
    const double step = common_step(foam.history);
    // A hundred steps at least over the whole.
    double longest = foam.history.duration() / 100.0;
    if (scene.solver.time_step) {
        longest = std::ldexp(*scene.solver.time_step, foam.levels - 1);
    } else if (foam.swirl_alone && foam.application == FoamApplication::pimple_foam) {
        constexpr double steps_to_row = 6.0; // or the first row after a start converges late
        longest = std::min(longest, step / steps_to_row);
    } else {
        longest = std::min(longest, step / 2.0);
        constexpr double largest_angle = 0.4; // that the rotor turns by in a step
        if (!is_box(scene))
            longest = std::min(longest, largest_angle / foam.history.fastest_speed());
    }
    // With which every row ends a step on all levels.
    foam.coarsest_step = step / std::ceil(step / longest * (1 - 1e-9));
    if (foam.hold > 0.0) // whole steps
        foam.hold = std::ceil(foam.hold / foam.coarsest_step) * foam.coarsest_step;
    if (foam.history.duration() / foam.coarsest_step > 1e7)
        throw UnsuitableScene(fmt::format("solver.time_step = {:.3g} s makes {:.3g} steps; at most "
                                          "1e7 are written",
                                          *scene.solver.time_step,
                                          foam.history.duration() / *scene.solver.time_step));
}

/// Around an eccentric bob the pressure varies with the direction: levels refine that way, too.
int coarsest_angular_cells(const Scene& scene, const geometry::ConcentricCylinders& gap,
                           int levels) {
    constexpr double widest = 12.0 * degree; // where the gap is wide, on the first level
    const double stretch =
        geometry::EccentricAnnulus(gap.bob_radius, gap.cup_radius, gap.offset).largest_stretch();
    const double wanted = scene.mesh.angular_cells
                              ? std::ldexp(*scene.mesh.angular_cells, 1 - levels)
                              : std::max(48.0, 2.0 * std::numbers::pi / widest * stretch);
    return std::max(4, 4 * static_cast<int>(std::ceil(std::min(wanted, 1e7) / 4.0 - 1e-9)));
}

void choose_mesh(const Scene& scene, FoamPlan& foam) {
    if (scene.mesh.cells_across_gap || scene.mesh.cell_size || scene.mesh.first_cell ||
        scene.solver.time_step) {
        foam.levels = 2; // the case's own numbers, and half of them to tell the error by
        foam.coarsest_cells = std::max(1, scene.mesh.cells_across_gap.value_or(40) / 2);
        if (const auto* gap = eccentric_gap(scene))
            foam.coarsest_angular_cells = coarsest_angular_cells(scene, *gap, foam.levels);
        return;
    }
    const auto* eccentric = eccentric_gap(scene);
    // Of a section each level costs four times the one before, in time eight times; of a wedge in
    // time, which few cells cover, twice.
    if (is_slice(scene, foam.vortices)) {
        const bool is_wedge =
            is_box(scene) || geometry::extent_of(scene.mesh) == geometry::MeshExtent::wedge;
        foam.levels = foam.steady || !is_wedge ? 4 : 6;
        foam.coarsest_cells = 20;
    } else if (foam.vortices || eccentric != nullptr) {
        foam.levels = foam.steady ? 3 : 2;
        foam.coarsest_cells = foam.vortices ? 14 : 10;
    } else {
        foam.levels = foam.steady ? 4 : 3;
        foam.coarsest_cells = 5;
    }
    if (eccentric != nullptr)
        foam.coarsest_angular_cells = coarsest_angular_cells(scene, *eccentric, foam.levels);
}

} // namespace

std::string_view name_of(FoamApplication application) {
    switch (application) {
    case FoamApplication::ico_foam:
        return "icoFoam";
    case FoamApplication::non_newtonian_ico_foam:
        return "nonNewtonianIcoFoam";
    case FoamApplication::piso_foam:
        return "pisoFoam";
    case FoamApplication::pimple_foam:
        return "pimpleFoam";
    case FoamApplication::simple_foam:
        break;
    }
    return "simpleFoam";
}

FoamPlan plan_foam(const Scene& scene, const Plan& plan) {
    if (scene.particles)
        throw UnsuitableScene("solver.engine = \"openfoam\" has no particles; engine = \"native\" "
                              "solves suspensions");
    if (scene.solver.model == Model::radial)
        throw UnsuitableScene("solver.engine = \"openfoam\" has no radial model; model = \"auto\", "
                              "or engine = \"native\"");
    if (geometry::is_eccentric(scene.instrument) && scene.solver.model == Model::axisymmetric)
        throw UnsuitableScene("solver.model = \"axisymmetric\": the flow around an eccentric bob "
                              "(geometry.offset) is not; model = \"auto\" or \"3d\"");
    if (flow_index_of(scene.fluid.law) >= 2.0)
        throw UnsuitableScene(
            "fluid.flow_index of 2 or more: OpenFOAM puts in the viscosity of the iteration "
            "before, which does not converge then; engine = \"native\" solves it");
    FoamPlan foam;
    choose_application(scene, plan, foam);
    foam.vortices = plan.vortices && plan.taylor.has_value();
    if (foam.vortices) {
        const auto* gap = std::get_if<geometry::ConcentricCylinders>(&scene.instrument);
        if (gap == nullptr)
            throw UnsuitableScene("Taylor vortices of a double gap: engine = \"native\" follows "
                                  "them; OpenFOAM is given single gaps");
        const double wavelength = scene.solver.vortex_wavelength.value_or(
            2.0 * std::numbers::pi * (gap->cup_radius - gap->bob_radius) /
            plan.taylor->wave_number);
        foam.vortex_height = 0.5 * wavelength;
    }
    choose_mesh(scene, foam);
    find_swirl(scene, plan, foam);
    choose_corrections(scene, plan, foam);
    choose_time(scene, plan, foam);
    choose_cap(scene, plan, foam);
    return foam;
}

geometry::MeshSettings mesh_settings(const Scene& scene, const FoamPlan& plan, int level) {
    geometry::MeshSettings mesh = scene.mesh;
    const int halvings = plan.levels - 1 - level;
    if (mesh.cell_size)
        *mesh.cell_size = std::ldexp(*mesh.cell_size, halvings);
    else if (mesh.first_cell)
        *mesh.first_cell = std::ldexp(*mesh.first_cell, halvings);
    else if (mesh.cells_across_gap)
        *mesh.cells_across_gap = std::max(1, *mesh.cells_across_gap >> halvings);
    else
        mesh.cells_across_gap = plan.coarsest_cells << level;
    if (mesh.axial_cells && *mesh.axial_cells > 1)
        *mesh.axial_cells = std::max(2, *mesh.axial_cells >> halvings);
    mesh.order = 1;
    if (is_box(scene)) {
        if (!mesh.angular_cells)
            mesh.angular_cells = 1;
    } else if (plan.coarsest_angular_cells > 0) {
        mesh.extent = geometry::MeshExtent::full;
        mesh.angular_cells = plan.coarsest_angular_cells << level;
    } else {
        if (!mesh.wedge_angle && !mesh.extent) {
            if (scene.solver.model == Model::three_dimensional)
                mesh.extent = geometry::MeshExtent::full;
            else
                mesh.wedge_angle = 1.0 * degree;
        }
        if (!mesh.vertices &&
            mesh.cells.value_or(geometry::CellStyle::hexahedra) != geometry::CellStyle::tetrahedra)
            mesh.vertices = geometry::VertexRadius::face;
    }
    if (plan.vortices) {
        if (!mesh.slice_height)
            mesh.slice_height = plan.vortex_height;
        if (!mesh.axial_cells)
            mesh.axial_cells = std::max(2, plan.coarsest_cells << level);
        if (!mesh.growth)
            mesh.growth = 1.0;
    } else if (is_endless(scene) && !mesh.floor_clearance) {
        // Cells of triangles are as high as wide: as few layers of them as are a gap high.
        const auto* gap = std::get_if<geometry::ConcentricCylinders>(&scene.instrument);
        if (gap != nullptr && !mesh.slice_height &&
            mesh.cells.value_or(geometry::CellStyle::hexahedra) != geometry::CellStyle::hexahedra)
            mesh.slice_height = gap->gap();
        if (!mesh.slice_height && !mesh.axial_cells)
            mesh.axial_cells = 1;
        if (!mesh.growth)
            mesh.growth = 1.0;
    }
    return mesh;
}

double left_out_inertia(const Scene& scene, const RowForecast& row) {
    // Around a bob off its axis the fluid on the wide side follows later, as the square of its
    // width.
    const auto* gap = eccentric_gap(scene);
    const double widest = gap == nullptr ? 1.0 : 1.0 + gap->offset / gap->gap();
    return left_out_margin * widest * widest * row.largest_lag_share;
}

} // namespace searle::solvers::openfoam
