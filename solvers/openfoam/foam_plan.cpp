#include "solvers/openfoam/foam_plan.hpp"

#include "geometry/eccentric_annulus.hpp"
#include "geometry/mesh_choices.hpp"
#include "laws/flow/flow_law.hpp"
#include "laws/gap/eccentric_cylinders.hpp"
#include "rheometry/conversion/conversion.hpp"
#include "solvers/openfoam/convergence_plan.hpp"
#include "solvers/openfoam/installation.hpp"
#include "solvers/openfoam/viscosity_cap.hpp"
#include "solvers/unsuitable_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace searle::solvers::openfoam {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

bool is_newtonian(const Scene& scene) {
    return std::holds_alternative<laws::flow::Newtonian>(scene.fluid.law);
}

bool is_box(const Scene& scene) { return std::holds_alternative<geometry::Box>(scene.instrument); }

bool is_endless(const Scene& scene) { return !geometry::has_ends(scene.instrument); }

/// The single gap whose bob is off the cup's axis; null for everything else.
const geometry::ConcentricCylinders* eccentric_gap(const Scene& scene) {
    return geometry::is_eccentric(scene.instrument)
               ? &std::get<geometry::ConcentricCylinders>(scene.instrument)
               : nullptr;
}

/// Whether a protocol in time is solved as steady rows: in a section, where steps far beyond the
/// cells' diffusion times are dear and may diverge, and where what inertia may do, with its margin,
/// takes no more than half of the accuracy.
bool is_quasi_steady(const Scene& scene, const Plan& plan) {
    if (scene.profile || plan.vortices ||
        !(geometry::has_ends(scene.instrument) || geometry::is_eccentric(scene.instrument)))
        return false;
    return std::ranges::all_of(plan.rows, [&scene](const RowForecast& row) {
        return row.speed != 0.0 && inertia_margin * row.lag_share <= 0.5 * scene.solver.accuracy;
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
                              : "the protocol is in time, and in a wedge the velocity's turn from "
                                "face to face needs outer corrections in each step";
        return;
    }
    foam.application = *scene.solver.application;
    foam.steady = foam.application == FoamApplication::simple_foam;
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

/// Whether the mesh will be one cell high around a centred rotor. In time the flow is the swirl
/// alone then, in a wedge as in the whole turn; steady rows are iterated as a flow in two
/// directions where there are cells in two.
bool finds_swirl_alone(const Scene& scene, const FoamPlan& foam) {
    const geometry::MeshSettings mesh = mesh_settings(scene, foam, 0);
    const bool one_cell_along =
        mesh.angular_cells.value_or(1) == 1 &&
        (is_box(scene) || geometry::extent_of(mesh) == geometry::MeshExtent::wedge);
    return is_endless(scene) && !foam.vortices && eccentric_gap(scene) == nullptr &&
           mesh.axial_cells == 1 && !mesh.floor_clearance &&
           mesh.cells != geometry::CellStyle::tetrahedra && (!foam.steady || one_cell_along);
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
            if (foam.swirl_alone && !scene.solver.application)
                foam.row_ends = row_ends(scene, foam.speeds.speeds);
            if (!foam.row_ends.empty()) {
                foam.application = FoamApplication::pimple_foam;
                foam.application_reason = "every row is iterated until steady, on the swirl alone";
                foam.outer_corrections = 1;
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
                                  0.1 * scene.solver.accuracy);
    const double step = common_step(foam.history);
    // A hundred steps at least over the whole; each row ends a step.
    double wanted = std::min(step / 2.0, foam.history.duration() / 100.0);
    if (foam.swirl_alone) {
        constexpr double steps_to_row = 6.0; // or the first row after a start converges late
        wanted = std::min(step / steps_to_row, foam.history.duration() / 100.0);
    } else if (!is_box(scene)) {
        constexpr double largest_angle = 0.4; // that the rotor turns by in a step
        wanted = std::min(wanted, largest_angle / foam.history.fastest_speed());
    }
    foam.coarsest_step = step / std::ceil(step / wanted * (1 - 1e-12));
    if (scene.solver.time_step) {
        foam.coarsest_step = std::ldexp(*scene.solver.time_step, foam.levels - 1);
    }
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
    const bool has_section =
        geometry::has_ends(scene.instrument) || foam.vortices || eccentric != nullptr;
    // Of a section each level costs four times the one before, in time eight times; of a slice in
    // time, which few cells cover, twice.
    foam.levels = !has_section ? (foam.steady ? 4 : 6) : foam.steady ? 3 : 2;
    foam.coarsest_cells = foam.vortices ? 12 : has_section ? 10 : 20;
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
    foam.swirl_alone = finds_swirl_alone(scene, foam);
    choose_corrections(scene, foam);
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
        if (!mesh.slice_height && !mesh.axial_cells)
            mesh.axial_cells = 1;
        if (!mesh.growth)
            mesh.growth = 1.0;
    }
    return mesh;
}

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

} // namespace

void describe(const Scene& scene, const FoamPlan& foam, Plan& plan) {
    plan.model = fmt::format("openfoam {}", name_of(foam.application));
    const bool is_plane = is_endless(scene) && !foam.vortices && !scene.mesh.extent &&
                          !scene.mesh.axial_cells && scene.mesh.wedge_angle.value_or(0.0) < 0.2;
    plan.model_reason = fmt::format(
        "OpenFOAM's {}: {}; {}; {} to {} cells across the gap{}.", name_of(foam.application),
        foam.application_reason,
        is_box(scene)                     ? "one cell along the flow and the width"
        : foam.coarsest_angular_cells > 0 ? "the whole turn, one cell high"
        : is_plane                        ? "a wedge one cell thick and one cell high"
                                          : "the mesh of searle mesh",
        mesh_settings(scene, foam, 0).cells_across_gap.value_or(0),
        mesh_settings(scene, foam, foam.levels - 1).cells_across_gap.value_or(0),
        foam.steady ? ""
                    : fmt::format(", time steps of {:.3g} to {:.3g} s", foam.coarsest_step,
                                  std::ldexp(foam.coarsest_step, 1 - foam.levels)));
    plan.items.push_back(
        {"grid error", true,
         "Levels of twice the cells and half the time step follow each other until "
         "the difference of the last two, which is claimed as error, meets the "
         "asked accuracy."});
    if (const auto* gap = eccentric_gap(scene))
        describe_offset(*gap, plan);
    if (foam.viscosity_cap > 0.0)
        plan.items.push_back(
            {"yield surface", false,
             fmt::format("OpenFOAM lets unyielded fluid creep at {:.3g} Pa s "
                         "(solver.viscosity_cap); up to {:.2g} % of the torque is claimed for it.",
                         foam.viscosity_cap,
                         100.0 * std::ranges::max(foam.cap_error.empty() ? std::vector{0.0}
                                                                         : foam.cap_error))});
    const double across = mesh_settings(scene, foam, 1).cells_across_gap.value_or(40);
    const double cells =
        across * (foam.vortices                          ? across
                  : geometry::has_ends(scene.instrument) ? 15.0 * across
                  : foam.coarsest_angular_cells > 0      ? 2.0 * foam.coarsest_angular_cells
                                                         : 1.0);
    const double steps = foam.steady ? 2000.0 * static_cast<double>(foam.speeds.speeds.size())
                                     : (foam.hold + foam.history.duration()) /
                                           (0.5 * foam.coarsest_step) * foam.outer_corrections;
    plan.expected_unknowns = std::lround(4.0 * cells);
    plan.expected_seconds = 1.3 * steps * (2e-4 + 8e-6 * cells);
}

} // namespace searle::solvers::openfoam
