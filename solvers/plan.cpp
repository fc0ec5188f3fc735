#include "solvers/plan.hpp"

#include "rheometry/schedule.hpp"
#include "solvers/openfoam/foam_plan.hpp"
#include "solvers/plan_cost.hpp"
#include "solvers/plan_forecast.hpp"
#include "solvers/plan_items.hpp"
#include "solvers/plan_rows.hpp"
#include "solvers/plan_text.hpp"
#include "solvers/suspension/suspension_plan.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace searle::solvers {
namespace {

struct Choice {
    std::string model;
    std::string reason;
    bool can_be_solved = true;
    bool is_radial = true;
};

/// Inertia may be left out only when an upper estimate of it is far below what was asked for.
bool needs_inertia(const Scene& scene, const Forecast& forecast) {
    if (forecast.steady_series) {
        return false;
    }
    constexpr double margin = 100.0;
    return std::ranges::any_of(forecast.rows, [&](const RowForecast& row) {
        return margin * row.largest_lag_share > scene.solver.accuracy;
    });
}

/// Secondary flow may be left out only when a few times its estimate is far below what was asked.
bool needs_secondary_flow(const Scene& scene, const Forecast& forecast) {
    // Around a double gap's rotor there is no solver of it: its estimate goes to the error bars.
    const bool has_bob =
        has_ends(scene) && !std::holds_alternative<geometry::DoubleGap>(scene.instrument);
    if (!has_bob || scene.solver.model == Model::radial ||
        scene.solver.secondary_flow == Switch::off) {
        return false;
    }
    return scene.solver.secondary_flow == Switch::on ||
           end_flow_matters(forecast.rows, scene.solver.accuracy);
}

/// Vortices past the onset are solved in gaps whose ends are left out; with a yield stress nothing
/// here follows what comes after it.
bool needs_vortices(const Scene& scene, const Forecast& forecast) {
    return is_endless_gap(scene) && !geometry::is_eccentric(scene.instrument) &&
           scene.solver.model != Model::radial && scene.solver.secondary_flow != Switch::off &&
           !(laws::flow::yield_stress(scene.fluid.law) > 0.0) && forecast.taylor &&
           forecast.taylor->largest_ratio > 1.0;
}

std::string why_radial(const Scene& scene) {
    struct Reason {
        std::string operator()(const geometry::ConcentricCylinders&) const {
            return "Between endless cylinders the velocity depends on the radius alone";
        }
        std::string operator()(const geometry::DoubleGap&) const {
            return "The two gaps share nothing but the rotor's speed, and between endless "
                   "cylinders the velocity depends on the radius alone";
        }
        std::string operator()(const geometry::Box&) const {
            return "Between endless plates the velocity depends on the distance from the wall "
                   "alone (the planar limit of the radial model)";
        }
        std::string operator()(const geometry::DinBob&) const {
            return "The case asks for the radial model: an endless bob, the ends through c_L alone";
        }
    };
    return std::visit(Reason{}, scene.instrument);
}

std::string why_transient(const Scene& scene, const Forecast& forecast, bool transient) {
    if (forecast.steady_series) {
        return "every row is held until steady";
    }
    double largest = 0.0;
    for (const RowForecast& row : forecast.rows) {
        largest = std::max(largest, row.largest_lag_share);
    }
    return transient
               ? fmt::format("inertia is up to {} of the stress, more than a hundredth of the "
                             "asked {}, so time is solved for",
                             percent(largest), percent(scene.solver.accuracy))
               : fmt::format("inertia stays below {} of the stress, a hundredth of the asked "
                             "{}, so each row is a steady flow",
                             percent(scene.solver.accuracy / 100.0),
                             percent(scene.solver.accuracy));
}

Choice choose(const Scene& scene, const Forecast& forecast, bool transient) {
    const Model asked = scene.solver.model;
    if (scene.solver.engine == Engine::openfoam) {
        return {"openfoam", "", true, false}; // solvers/openfoam says which program, and why
    }
    const bool has_axis = !is_box(scene);
    if (asked == Model::three_dimensional || (asked == Model::axisymmetric && !has_axis)) {
        return {asked == Model::axisymmetric ? "axisymmetric" : "3d",
                fmt::format("solver.model = \"{}\": this version has no such model of this "
                            "instrument. model = \"auto\" solves this scene with the {} model.",
                            asked == Model::axisymmetric ? "axisymmetric" : "3d",
                            has_ends(scene) ? "axisymmetric" : "radial"),
                false, false};
    }
    if (asked == Model::radial && forecast.conversion.end_factor_provisional) {
        return {
            "radial",
            "conversion.end_factor = \"computed\" needs the flow around the bob's ends, which "
            "solver.model = \"radial\" leaves out; model = \"auto\" has it, and so has a number "
            "for c_L (the default is 1.10).",
            false, false};
    }
    if (needs_vortices(scene, forecast)) {
        return {"axisymmetric",
                fmt::format("Re / Re_c reaches {:.4g}: Taylor vortices in an axially periodic cell "
                            "on top of the laminar flow in the gap; {}.",
                            forecast.taylor->largest_ratio,
                            why_transient(scene, forecast, transient)),
                true, false};
    }
    if (has_ends(scene) && asked != Model::radial) {
        return {"axisymmetric",
                fmt::format("The flow around the rotor's ends is axisymmetric: {}, in the whole "
                            "section; {}.",
                            needs_secondary_flow(scene, forecast)
                                ? "the angular velocity w(r, z) and the secondary flow u_r, u_z, p"
                                : "one unknown, the angular velocity w(r, z)",
                            why_transient(scene, forecast, transient)),
                true, false};
    }
    return {transient ? "radial transient" : "radial steady",
            fmt::format("{}{}; {}.", why_radial(scene),
                        asked == Model::axisymmetric
                            ? ": below the onset of Taylor vortices the axisymmetric model is this"
                            : "",
                        why_transient(scene, forecast, transient)),
            true, true};
}

std::vector<std::string> choice_warnings(const Scene& scene, const Choice& choice) {
    std::vector<std::string> warnings;
    if (choice.is_radial && has_ends(scene)) {
        warnings.emplace_back("The radial model is an explicit choice for this instrument: it "
                              "ignores the flow around the rotor's ends and its inertia, and takes "
                              "them as a factor c_L on the endless rotor's torque.");
    }
    if (choice.is_radial && scene.solver.secondary_flow == Switch::on) {
        warnings.emplace_back(
            "secondary_flow = true has no effect: the radial model has no flow in "
            "r and z.");
    }
    return warnings;
}

/// Rows of a rotor of any shape: speeds and rates alone.
std::vector<RowForecast> rows_without_forecast(const Scene& scene) {
    const auto conversion = rheometry::conversion_for(scene.instrument, scene.conversion);
    const auto schedule = rheometry::schedule(scene.protocol, conversion);
    std::vector<RowForecast> rows;
    const auto add = [&](double time, double speed) {
        RowForecast row;
        row.time = time;
        row.speed = speed;
        row.shear_rate = conversion.rate_per_speed * speed;
        row.regime = "not-judged";
        rows.push_back(std::move(row));
    };
    if (const auto* series = std::get_if<rheometry::SteadySpeeds>(&schedule))
        for (const double speed : series->speeds)
            add(0.0, speed);
    else {
        const auto& history = std::get<rheometry::SpeedHistory>(schedule);
        for (const double time : history.row_times)
            add(time, history.speed_at(time));
    }
    return rows;
}

/// Of a profile: no formula for a gap holds around it, so nothing can be foretold.
Plan plan_without_model() {
    Plan plan;
    plan.model = "none";
    plan.model_reason =
        "A rotor of any shape (geometry.type = \"profile\") can be meshed and "
        "converted; the flow around it is OpenFOAM's to solve: solver.engine = \"openfoam\"";
    plan.can_be_solved = false;
    return plan;
}

Plan plan_of_profile(const Scene& scene) {
    Plan plan;
    plan.rows = rows_without_forecast(scene);
    const openfoam::FoamPlan foam = openfoam::plan_foam(scene, plan);
    plan.transient = !foam.steady;
    openfoam::describe(scene, foam, plan);
    return plan;
}

} // namespace

Plan make_plan(const Scene& scene) {
    if (scene.profile) {
        return scene.solver.engine == Engine::openfoam ? plan_of_profile(scene)
                                                       : plan_without_model();
    }
    Forecast forecast = solvers::forecast(scene);
    Plan plan;
    plan.transient = needs_inertia(scene, forecast);
    Choice choice = choose(scene, forecast, plan.transient);
    plan.can_be_solved = choice.can_be_solved;
    plan.secondary_flow = choice.can_be_solved && needs_secondary_flow(scene, forecast);
    plan.vortices = choice.can_be_solved && needs_vortices(scene, forecast);
    plan.items = plan_items(scene, forecast,
                            {.radial = choice.is_radial,
                             .transient = plan.transient,
                             .secondary_flow = plan.secondary_flow,
                             .vortices = plan.vortices});
    plan.warnings = choice_warnings(scene, choice);
    for (std::string& warning : plan_warnings(scene, forecast, plan.vortices)) {
        plan.warnings.push_back(std::move(warning));
    }
    if (choice.is_radial) {
        const Cost cost = radial_cost(scene, forecast, plan.transient);
        plan.expected_seconds = cost.seconds;
        plan.expected_unknowns = cost.unknowns;
    }
    if (choice.can_be_solved && !choice.is_radial && scene.solver.engine == Engine::native) {
        const Cost cost = axisymmetric_cost(scene, forecast, plan.transient, plan.secondary_flow);
        plan.expected_seconds = cost.seconds;
        plan.expected_unknowns = cost.unknowns;
    }
    plan.model = std::move(choice.model);
    plan.model_reason = std::move(choice.reason);
    plan.taylor = std::move(forecast.taylor);
    if (scene.particles && scene.solver.engine == Engine::native)
        suspension::plan_suspension(scene, forecast, plan);
    plan.rows = std::move(forecast.rows);
    if (scene.solver.engine == Engine::openfoam)
        openfoam::describe(scene, openfoam::plan_foam(scene, plan), plan);
    return plan;
}

} // namespace searle::solvers
