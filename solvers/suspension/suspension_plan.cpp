#include "solvers/suspension/suspension_plan.hpp"

#include "laws/colloid/dlvo.hpp"
#include "solvers/plan_rows.hpp"
#include "solvers/plan_text.hpp"
#include "solvers/suspension/step_limits.hpp"
#include "solvers/suspension/suspension_input.hpp"
#include "solvers/suspension/suspension_scales.hpp"
#include "solvers/suspension/suspension_warnings.hpp"
#include "solvers/unsuitable_scene.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace searle::solvers::suspension {
namespace {

constexpr double most_particles = 2e6;
constexpr double random_close_packing = 0.64;
/// Forced steps that move neighbours by more than this share of their distance are no steps.
constexpr double most_strain_in_a_step = 0.05;

std::string describe_stiffness(const ParticleSettings& settings) {
    if (settings.contact->model == ContactModel::hertz)
        return fmt::format("Hertz' elastic spheres, shear modulus {:.3g} Pa, Poisson's ratio "
                           "{:.3g}",
                           *settings.shear_modulus, *settings.poisson_ratio);
    return fmt::format("Springs of {:.3g} N/m", *settings.contact->stiffness);
}

/// Throws where the particles do not fit.
void check_sizes(const Scene& scene, const SuspensionChoice& choice) {
    const auto& box = std::get<geometry::Box>(scene.instrument);
    const Sizes sizes = sizes_of(choice.settings);
    if (choice.volume_fraction > random_close_packing)
        throw UnsuitableScene(fmt::format("particles.volume_fraction = {:.4g}: spheres at random "
                                          "fill at most {:.2f} of a box; the "
                                          "packings made here reach about 0.60",
                                          choice.volume_fraction, random_close_packing));
    if (sizes.largest > box.gap)
        throw UnsuitableScene(fmt::format(
            "particles.diameter = {:.4g} m (the largest) does not fit into geometry.gap "
            "= {:.4g} m",
            sizes.largest, box.gap));
    if (choice.count > most_particles)
        throw UnsuitableScene(fmt::format("a box of {:.3g} x {:.3g} x {:.3g} m holds {:.2g} "
                                          "particles of this size, more than the "
                                          "{:.0g} that can be run: take a smaller geometry.length, "
                                          "width and gap (the paper's box "
                                          "is a cube of 33 diameters)",
                                          box.length, box.gap, box.width, choice.count,
                                          most_particles));
    if (choice.count < 2.0)
        throw UnsuitableScene(
            fmt::format("the box holds {:.2g} particles of this size at this volume fraction; at "
                        "least 2 are needed",
                        choice.count));
    const double film =
        choice.settings.hydrodynamics == Hydrodynamics::lubrication ? 0.25 * sizes.largest : 0.0;
    const double reach = std::max(film, choice.settings.dlvo ? choice.settings.dlvo->cutoff : 0.0);
    const double needed = 2.0 * (1.15 * sizes.largest + reach);
    const bool walls = choice.settings.boundary == ParticleBoundary::walls;
    const double shortest = std::min({box.length, box.width, walls ? box.length : box.gap});
    if (shortest < needed)
        throw UnsuitableScene(fmt::format(
            "the box is periodic over {:.4g} m, less than the {:.4g} m that keep a particle from "
            "meeting two images of another (twice the largest diameter, the reach of the forces "
            "and "
            "a margin)",
            shortest, needed));
}

std::vector<PlanItem> items_for(const Scene& scene, const Forecast& forecast,
                                const SuspensionChoice& choice) {
    const ParticleSettings& settings = choice.settings;
    const auto& box = std::get<geometry::Box>(scene.instrument);
    const double viscosity = std::get<laws::flow::Newtonian>(scene.fluid.law).viscosity;
    const Sizes sizes = sizes_of(settings);
    const double radius = 0.5 * sizes.largest;
    const double fast = fastest_rate(forecast);
    const double slow = slowest_rate(forecast);
    const bool walls = settings.boundary == ParticleBoundary::walls;
    std::vector<PlanItem> items;
    items.push_back(
        {"particles", true,
         fmt::format("{:.0f} spheres, volume fraction {:.4g}, the gap {:.3g} diameters "
                     "wide, {}.",
                     choice.count, choice.volume_fraction, box.gap / sizes.largest,
                     walls ? "between two walls" : "in a Lees-Edwards box without walls")});
    items.push_back({"particle stress", settings.hydrodynamics != Hydrodynamics::drag,
                     choice.why_hydrodynamics});
    if (walls)
        items.push_back(
            {"3d fluid", false,
             fmt::format(
                 "Along the walls the scene is uniform: periodic, and sheared by plane walls. "
                 "The fluid is one profile across the gap on {} cells; {} x {} cells of each "
                 "layer are one.",
                 scene.coupling.cells[1], scene.coupling.cells[0], scene.coupling.cells[2])});
    else
        items.push_back(
            {"fluid profile", false,
             "Without walls the mean flow is uniform shear; the fluid has no equation of "
             "its own."});
    const double stokes =
        settings.density * sizes.largest * sizes.largest * fast / (18 * viscosity);
    items.push_back(
        {"Stokes number", settings.hydrodynamics != Hydrodynamics::lubrication,
         fmt::format(
             "Inertia of the particles over drag, rho d^2 rate / 18 mu: {:.2g} at {:.4g} 1/s. {}",
             stokes, fast, choice.why_integrator)});
    if (settings.hydrodynamics == Hydrodynamics::lubrication)
        items.push_back(
            {"keys of inertia", false,
             "Films act with Stokes' drag, in each step: particles.drag, coupling.model, "
             "coupling.interval, restitution and rolling_friction have no part in it."});
    const double thermal = laws::colloid::boltzmann * settings.temperature;
    const double per_rate = 6 * std::numbers::pi * viscosity * std::pow(radius, 3) / thermal;
    items.push_back({"thermal motion", settings.brownian,
                     fmt::format("Peclet number 6 pi mu a^3 rate / kT from {:.3g} to {:.3g}; "
                                 "particles.brownian = {}.",
                                 per_rate * slow, per_rate * fast, settings.brownian)});
    items.push_back(
        {"contacts", settings.contact.has_value(),
         settings.contact
             ? fmt::format("{}, restitution, friction {:.3g}; {}.", describe_stiffness(settings),
                           settings.contact->friction, walls ? "with the walls, too" : "no walls")
             : std::string("particles.contact is left out: spheres may overlap.")});
    if (settings.dlvo) {
        double attraction = 0.0;
        const laws::colloid::DlvoCurve curve = curve_of(settings, radius, attraction);
        items.push_back(
            {"colloid forces", true,
             fmt::format("Barrier {:.3g} kT, secondary minimum {:.3g} kT, largest repulsion {:.3g} "
                         "times 6 pi mu a^2 rate at {:.4g} 1/s; between particles, not with walls.",
                         curve.barrier / thermal, curve.secondary_minimum / thermal,
                         curve.largest_repulsion /
                             (6 * std::numbers::pi * viscosity * radius * radius * fast),
                         fast)});
    } else {
        items.push_back({"colloid forces", false, "particles.dlvo is left out."});
    }
    if (!forecast.rows.empty()) {
        const std::size_t worst =
            row_of_largest(forecast, [&](std::size_t i) { return forecast.rows[i].lag_share; });
        items.push_back(
            {"inertia", walls,
             walls ? fmt::format("The fluid's inertia is {} of the stress at most (row {}).",
                                 percent(forecast.rows[worst].lag_share), worst + 1)
                   : std::string("Sheared everywhere at once, the fluid has nothing "
                                 "to lag behind.")});
    }
    return items;
}

StepLimits step_limits(const Scene& scene, const SuspensionChoice& choice, double rate) {
    const Sizes sizes = sizes_of(choice.settings);
    SuspensionInput input;
    input.settings = choice.settings;
    input.box.length_y = std::get<geometry::Box>(scene.instrument).gap;
    for (const double diameter : {sizes.smallest, sizes.largest})
        input.particles.add(0.0, 0.0, 0.0, 0.5 * diameter, choice.settings.density);
    input.viscosity = std::get<laws::flow::Newtonian>(scene.fluid.law).viscosity;
    input.accuracy = scene.solver.accuracy;
    input.fastest_wall_speed = rate * input.box.length_y;
    return StepLimits(input);
}

double expected_seconds(const Scene& scene, const Forecast& forecast,
                        const SuspensionChoice& choice) {
    const auto* steps = std::get_if<rheometry::Steps>(&scene.protocol.program);
    const bool by_strain = steps != nullptr && !steps->hold;
    double strain = 0.0;
    double time = 0.0;
    for (const RowForecast& row : forecast.rows) {
        const double rate = std::abs(row.shear_rate);
        const double begin = time;
        if (by_strain && rate > 0.0)
            time += steps->hold_strain.value_or(10.0) / rate;
        else if (!by_strain)
            time = std::max(row.time, time);
        strain += rate * (time - begin);
    }
    const double rate = fastest_rate(forecast);
    if (choice.settings.hydrodynamics == Hydrodynamics::lubrication) {
        // As bench_dense_shear found; friction takes more iterations.
        const bool rubs = choice.settings.contact && choice.settings.contact->friction > 0.0;
        const double finer = std::clamp(scene.solver.accuracy / 1e-2, 0.02, 1.0);
        return strain * choice.count * (3e-4 + 3.5e-3 * choice.volume_fraction) *
               (rubs ? 2.5 : 1.0) / finer;
    }
    const StepLimits limits = step_limits(scene, choice, rate);
    // From about one contact in the box on, some pair always touches.
    const bool touch = choice.settings.contact && choice.count * choice.volume_fraction > 5.0;
    const double by_colloid =
        choice.settings.dlvo ? 6e-7 * 180.0 / rate + 2e-7 : std::numeric_limits<double>::infinity();
    const double step = choice.settings.time_step.value_or(
        std::min(touch ? limits.touching(0.0) : limits.free(), by_colloid));
    const double speed = 4e7 / (1.0 + 4.0 * choice.volume_fraction);
    return time / step * choice.count / speed;
}

/// Throws where a step that the case asks for cannot be taken.
void check_step(const Scene& scene, const Forecast& forecast, const SuspensionChoice& choice) {
    if (!choice.settings.time_step)
        return;
    const double step = *choice.settings.time_step;
    const double rate = fastest_rate(forecast);
    const double strained = most_strain_in_a_step / rate;
    if (step > strained)
        throw UnsuitableScene(fmt::format("particles.time_step = {:.3g} s: at {:.4g} 1/s the "
                                          "suspension is strained by {:.3g} within "
                                          "it; at most {:.3g} s, a strain of {}",
                                          step, rate, rate * step, strained,
                                          most_strain_in_a_step));
    if (choice.settings.hydrodynamics == Hydrodynamics::lubrication)
        return;
    const StepLimits limits = step_limits(scene, choice, rate);
    if (step > limits.stable())
        throw UnsuitableScene(fmt::format("particles.time_step = {:.3g} s: steps beyond {:.3g} s "
                                          "make contacts and drag swing up; "
                                          "\"auto\" takes up to {:.3g} s here",
                                          step, limits.stable(),
                                          std::min(limits.touching(0.0), limits.free())));
}

/// Why lubrication cannot be had for these settings; empty when it can.
std::string against_lubrication(const ParticleSettings& settings) {
    if (settings.brownian)
        return "with thermal motion (brownian = false has it)";
    if (settings.gravity)
        return "with gravity";
    return "";
}

SuspensionChoice with_automatic_level(SuspensionChoice choice, const Scene& scene,
                                      const std::string& numbers) {
    ParticleSettings& settings = choice.settings;
    const double pairs = 5.0 * settings.volume_fraction * settings.volume_fraction;
    settings.hydrodynamics = Hydrodynamics::stresslet;
    if (pairs <= scene.solver.accuracy) {
        choice.why_hydrodynamics = "Stresslets of isolated spheres are enough: " + numbers + ".";
    } else if (const std::string against = against_lubrication(settings); !against.empty()) {
        choice.why_hydrodynamics =
            "Stresslets of isolated spheres; near pairs would be needed, too (" + numbers +
            "), but this version has no lubrication " + against + ".";
    } else {
        settings.hydrodynamics = Hydrodynamics::lubrication;
        choice.why_hydrodynamics = "Stresslets and lubrication of near pairs: " + numbers + ".";
    }
    return choice;
}

} // namespace

SuspensionChoice choose(const Scene& scene) {
    SuspensionChoice choice;
    choice.settings = *scene.particles;
    ParticleSettings& settings = choice.settings;
    choice.volume_fraction = settings.volume_fraction;
    const auto& box = std::get<geometry::Box>(scene.instrument);
    choice.count = settings.volume_fraction * box.gap * box.length * box.width /
                   sizes_of(settings).mean_volume;
    const double pairs = 5.0 * settings.volume_fraction * settings.volume_fraction;
    const std::string numbers = fmt::format("5 phi^2 = {}, the asked accuracy is {}",
                                            percent(pairs), percent(scene.solver.accuracy));
    switch (settings.hydrodynamics) {
    case Hydrodynamics::automatic:
        choice = with_automatic_level(std::move(choice), scene, numbers);
        break;
    case Hydrodynamics::drag:
        choice.why_hydrodynamics =
            fmt::format("hydrodynamics = \"drag\", as in CFD-DEM: the spheres feel drag, and the "
                        "fluid does not feel that they are rigid (2.5 phi = {} of the stress).",
                        percent(2.5 * settings.volume_fraction));
        break;
    case Hydrodynamics::stresslet:
        choice.why_hydrodynamics =
            "hydrodynamics = \"stresslet\": of isolated spheres; " + numbers + ".";
        break;
    case Hydrodynamics::lubrication:
        choice.why_hydrodynamics =
            "hydrodynamics = \"lubrication\": stresslets and near pairs; " + numbers + ".";
        break;
    }
    const bool lubricated = settings.hydrodynamics == Hydrodynamics::lubrication;
    if (lubricated) {
        choice.why_integrator =
            settings.boundary == ParticleBoundary::walls
                ? "With lubrication the motion is overdamped: the particles' mass moves with the "
                  "fluid around them."
                : "With lubrication the motion is overdamped: no inertia.";
        settings.integrator = Integrator::overdamped;
    } else if (settings.integrator == Integrator::explicit_steps) {
        choice.why_integrator = "integrator = \"explicit\": velocity Verlet, as asked.";
    } else {
        choice.why_integrator =
            "The drag is integrated exactly, so that no step is too long for it.";
        settings.integrator = Integrator::implicit_drag;
    }
    return choice;
}

void plan_suspension(const Scene& scene, Forecast& forecast, Plan& plan) {
    plan.taylor.reset();
    const auto cannot = [&](std::string reason) {
        plan.model = "suspension";
        plan.model_reason = std::move(reason);
        plan.can_be_solved = false;
    };
    if (!is_box(scene))
        return cannot("Particles are simulated in a box, which stands for a part of the gap: "
                      "geometry.type = \"box\" with gap, length and width.");
    if (!is_newtonian(scene))
        return cannot("Particles are simulated in a Newtonian fluid alone: fluid.model = "
                      "\"newtonian\".");
    const SuspensionChoice choice = choose(scene);
    check_sizes(scene, choice);
    if (choice.settings.hydrodynamics == Hydrodynamics::lubrication)
        if (const std::string against = against_lubrication(choice.settings); !against.empty())
            return cannot("hydrodynamics = \"lubrication\": this version has no lubrication " +
                          against + "; \"stresslet\" and \"drag\" can do this scene.");
    const char* level = choice.settings.hydrodynamics == Hydrodynamics::drag        ? "drag"
                        : choice.settings.hydrodynamics == Hydrodynamics::stresslet ? "stresslet"
                                                                                    : "lubrication";
    plan.model = fmt::format("suspension, {}", level);
    plan.model_reason = fmt::format(
        "The case has particles: their motion is computed one by one, {}. {}",
        choice.settings.boundary != ParticleBoundary::walls ? "in uniform shear without walls"
        : choice.settings.hydrodynamics == Hydrodynamics::lubrication
            ? "together with the fluid between the walls"
            : "four-way coupled with the fluid between the walls",
        choice.why_hydrodynamics);
    check_step(scene, forecast, choice);
    plan.can_be_solved = true;
    if (choice.settings.boundary != ParticleBoundary::walls)
        // Sheared everywhere at once: nothing lags behind a wall.
        for (RowForecast& row : forecast.rows) {
            row.lag_share = 0.0;
            row.largest_lag_share = 0.0;
            row.regime = "laminar";
        }
    plan.items = items_for(scene, forecast, choice);
    plan.warnings = warnings_for(scene, forecast, choice);
    plan.expected_seconds = expected_seconds(scene, forecast, choice);
    plan.expected_unknowns = static_cast<long>(6.0 * choice.count);
}

} // namespace searle::solvers::suspension
