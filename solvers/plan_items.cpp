#include "solvers/plan_items.hpp"

#include "solvers/plan_rows.hpp"
#include "solvers/plan_text.hpp"

#include <fmt/format.h>

namespace searle::solvers {
namespace {

PlanItem inertia_item(const Scene& scene, const Forecast& forecast, bool transient) {
    if (forecast.steady_series) {
        return {"inertia", false,
                fmt::format("Every row is held until the flow is steady; an instrument would need "
                            "about {:.3g} s for the series.",
                            forecast.rows.back().time)};
    }
    if (!transient) {
        const std::size_t worst = row_of_largest(
            forecast, [&](std::size_t i) { return forecast.rows[i].largest_lag_share; });
        return {
            "inertia", false,
            fmt::format("Its part of the stress is {} at the most (row {}, t = {:.4g} s), less "
                        "than a hundredth of the asked accuracy of {}: each row is a steady flow.",
                        percent(forecast.rows[worst].largest_lag_share), worst + 1,
                        forecast.rows[worst].time, percent(scene.solver.accuracy))};
    }
    const std::size_t worst =
        row_of_largest(forecast, [&](std::size_t i) { return forecast.rows[i].lag_share; });
    return {"inertia", true,
            fmt::format("It is up to {} of the stress (row {}, t = {:.4g} s), and more than the "
                        "asked accuracy of {} at {}.",
                        percent(forecast.rows[worst].lag_share), worst + 1,
                        forecast.rows[worst].time, percent(scene.solver.accuracy),
                        rows_of(rows_with_lag(scene, forecast), forecast.rows.size()))};
}

PlanItem ends_item(const Scene& scene, const Forecast& forecast, PlannedModel model) {
    const double end_factor = forecast.conversion.end_factor;
    if (is_box(scene)) {
        return {"ends", false, "The box stands for a part of an endless gap: it has no ends."};
    }
    if (has_ends(scene) && !model.radial && !is_din_bob(scene)) {
        return {"ends", true,
                "ends = true: the fluid beyond the rotor's ends is part of the section, and c_L is "
                "computed."};
    }
    if (is_din_bob(scene) && !model.radial) {
        return {
            "ends", true,
            "Cone, top and shaft carry about a tenth of the torque: c_L is 1.0887 for a Newtonian "
            "fluid in creeping flow in the standard geometry, up to 1.26 for shear-thinning and "
            "yield-stress fluids."};
    }
    if (has_ends(scene) && !is_din_bob(scene)) {
        return {"ends", false,
                fmt::format("The torque on the rotor's ends enters through c_L = {:.5g} alone.",
                            end_factor)};
    }
    if (is_din_bob(scene)) {
        return {
            "ends", false,
            fmt::format("The torque on cone, top and shaft enters through c_L = {:.5g} alone; a "
                        "Newtonian fluid in creeping flow has 1.0887 in the standard geometry, "
                        "shear-thinning and yield-stress fluids up to 1.26.",
                        end_factor)};
    }
    return {
        "ends", false,
        fmt::format("The geometry is a slice of an endless gap, {:.3g} gap widths high, and its "
                    "torque that of the wetted cylinder alone (c_L = {:.5g}).",
                    slenderness(scene.instrument), end_factor)};
}

std::string secondary_flow_decision(const Scene& scene, bool is_solved) {
    switch (scene.solver.secondary_flow) {
    case Switch::on:
        return is_solved ? "secondary_flow = true asks for it"
                         : "the radial model has no place for it";
    case Switch::off:
        return "secondary_flow = false leaves it out";
    case Switch::automatic:
        break;
    }
    if (scene.solver.model == Model::radial) {
        return "the radial model leaves it out";
    }
    return is_solved ? fmt::format("that matters at the asked {}", percent(scene.solver.accuracy))
                     : fmt::format("three times that goes to the error, small against the asked {}",
                                   percent(scene.solver.accuracy));
}

PlanItem secondary_flow_item(const Scene& scene, const Forecast& forecast, bool is_solved) {
    if (is_box(scene)) {
        return {"secondary flow", false, "Plane shear has straight streamlines."};
    }
    if (!has_ends(scene)) {
        return {
            "secondary flow", false,
            "Without ends nothing drives a flow in r and z below the onset of Taylor vortices."};
    }
    const std::size_t worst =
        row_of_largest(forecast, [&](std::size_t i) { return forecast.facts[i].end_reynolds; });
    const RowFacts& facts = forecast.facts[worst];
    return {"secondary flow", is_solved,
            fmt::format("The bob's ends drive it with Re = omega R^2 / nu = {:.4g} at the most, "
                        "worth about {} of the torque (a fit to the ISO bob's); {}.",
                        facts.end_reynolds, percent(facts.end_flow_share),
                        secondary_flow_decision(scene, is_solved))};
}

PlanItem taylor_item(const Forecast& forecast, bool is_solved) {
    if (!forecast.taylor) {
        const std::size_t worst =
            row_of_largest(forecast, [&](std::size_t i) { return forecast.facts[i].reynolds; });
        return {
            "Taylor vortices", false,
            fmt::format("Plane shear flow is linearly stable at any speed; U h / nu is {:.4g} at "
                        "the most.",
                        forecast.facts[worst].reynolds)};
    }
    const TaylorOnset& taylor = *forecast.taylor;
    const std::size_t above =
        count_rows(forecast, [&](std::size_t i) { return forecast.rows[i].taylor_ratio > 1.0; });
    return {"Taylor vortices", is_solved,
            fmt::format("Re = R omega d / nu reaches {:.4g}, the critical value is {:.6g}; largest "
                        "Re / Re_c {:.3g}, {} above the onset.",
                        taylor.reynolds, taylor.critical_reynolds, taylor.largest_ratio,
                        rows_of(above, forecast.rows.size()))};
}

PlanItem yield_item(const Scene& scene, const Forecast& forecast) {
    const double yield = laws::flow::yield_stress(scene.fluid.law);
    if (!(yield > 0.0)) {
        return {"yield surface", false,
                fmt::format("The yield stress of this {} fluid is 0 Pa.",
                            laws::flow::name_of(scene.fluid.law))};
    }
    const std::size_t partly =
        count_rows(forecast, [&](std::size_t i) { return forecast.facts[i].partly_sheared; });
    if (partly == 0) {
        return {
            "yield surface", true,
            fmt::format("Exactly, without regularisation; with tau_0 = {:.4g} Pa the steady flow "
                        "shears all of the gap at every row.",
                        yield)};
    }
    return {"yield surface", true,
            fmt::format("Exactly, without regularisation; with tau_0 = {:.4g} Pa the steady flow "
                        "leaves a part of the gap unsheared at {}.",
                        yield, rows_of(partly, forecast.rows.size()))};
}

PlanItem mesh_item(PlannedModel model) {
    if (!model.radial) {
        return {"mesh", true, "A model of more than 1 dimension needs one, graded to the edges."};
    }
    return {
        "mesh", false,
        model.transient
            ? "The flow depends on 1 coordinate: elements across the gap, chosen by the solver's "
              "error estimate, stand in place of a mesh."
            : "Steady flow across a gap is one quadrature and one root a row: 0 cells."};
}

} // namespace

std::vector<PlanItem> plan_items(const Scene& scene, const Forecast& forecast, PlannedModel model) {
    return {inertia_item(scene, forecast, model.transient),
            yield_item(scene, forecast),
            taylor_item(forecast, model.vortices),
            secondary_flow_item(scene, forecast, model.secondary_flow),
            ends_item(scene, forecast, model),
            mesh_item(model),
            {"particles", false, "The case has no particles: a fluid of 0 % solids."}};
}

} // namespace searle::solvers
