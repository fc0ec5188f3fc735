#include "solvers/suspension/suspension_plan.hpp"

#include "laws/colloid/dlvo.hpp"
#include "solvers/plan_rows.hpp"
#include "solvers/plan_text.hpp"
#include "solvers/suspension/suspension_input.hpp"
#include "solvers/unsuitable_scene.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace searle::solvers::suspension {
namespace {

constexpr double most_particles = 2e6;
constexpr double random_close_packing = 0.64;

struct Sizes {
    double smallest{}, largest{}, mean_volume{};
};

Sizes sizes_of(const ParticleSettings& settings) {
    Sizes sizes{1e300, 0.0, 0.0};
    double per_volume = 0.0;
    std::vector<SizeClass> classes = settings.diameters;
    if (settings.diameter)
        classes = {{*settings.diameter, 1.0}};
    for (const SizeClass& size : classes) {
        sizes.smallest = std::min(sizes.smallest, size.diameter);
        sizes.largest = std::max(sizes.largest, size.diameter);
        per_volume += size.share * 6.0 / (std::numbers::pi * std::pow(size.diameter, 3));
    }
    // A lognormal spread by number: <d^3> = d^3 exp(9 s^2 / 2); four deviations are the largest.
    const double spread = settings.spread;
    sizes.mean_volume = std::exp(4.5 * spread * spread) / per_volume;
    sizes.largest *= std::exp(4.0 * spread);
    return sizes;
}

double fastest_rate(const Forecast& forecast) {
    double fastest = 0.0;
    for (const RowForecast& row : forecast.rows)
        fastest = std::max(fastest, std::abs(row.shear_rate));
    return fastest;
}

double slowest_rate(const Forecast& forecast) {
    double slowest = 1e300;
    for (const RowForecast& row : forecast.rows)
        if (row.shear_rate != 0.0)
            slowest = std::min(slowest, std::abs(row.shear_rate));
    return slowest;
}

laws::colloid::DlvoCurve curve_of(const ParticleSettings& settings, double radius,
                                  double& attraction) {
    return std::visit(
        [&]<class Colloid>(const Colloid& colloid) -> laws::colloid::DlvoCurve {
            if constexpr (std::is_same_v<Colloid, particles::NoColloid>) {
                return {};
            } else {
                attraction = -colloid.repulsion(0.0, radius, radius);
                return laws::colloid::dlvo_curve(colloid, radius, radius);
            }
        },
        colloid_law(settings.dlvo, settings.temperature));
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
    const double reach = choice.settings.dlvo ? choice.settings.dlvo->cutoff
                         : choice.settings.hydrodynamics == Hydrodynamics::lubrication
                             ? 0.25 * sizes.largest
                             : 0.0;
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
    const double thermal = laws::colloid::boltzmann * settings.temperature;
    const double per_rate = 6 * std::numbers::pi * viscosity * std::pow(radius, 3) / thermal;
    items.push_back({"thermal motion", settings.brownian,
                     fmt::format("Peclet number 6 pi mu a^3 rate / kT from {:.3g} to {:.3g}; "
                                 "particles.brownian = {}.",
                                 per_rate * slow, per_rate * fast, settings.brownian)});
    items.push_back({"contacts", settings.contact.has_value(),
                     settings.contact
                         ? fmt::format("Springs of {:.3g} N/m, restitution, friction {:.3g}; {}.",
                                       settings.contact->stiffness, settings.contact->friction,
                                       walls ? "with the walls, too" : "no walls")
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
            {"inertia", walls && settings.hydrodynamics != Hydrodynamics::lubrication,
             walls ? fmt::format("The fluid's inertia is up to {} of the stress (row {}).",
                                 percent(forecast.rows[worst].lag_share), worst + 1)
                   : std::string("Sheared everywhere at once, the fluid has nothing "
                                 "to lag behind.")});
    }
    return items;
}

std::vector<std::string> warnings_for(const Scene& scene, const Forecast& forecast,
                                      const SuspensionChoice& choice) {
    std::vector<std::string> warnings;
    const ParticleSettings& settings = choice.settings;
    const double viscosity = std::get<laws::flow::Newtonian>(scene.fluid.law).viscosity;
    const double radius = 0.5 * sizes_of(settings).largest;
    const double thermal = laws::colloid::boltzmann * settings.temperature;
    if (settings.hydrodynamics == Hydrodynamics::drag)
        warnings.push_back(fmt::format(
            "hydrodynamics = \"drag\" carries no particle stress: Einstein's 2.5 phi, {} of the "
            "stress here, is missing (\"stresslet\" or \"auto\" has it).",
            percent(2.5 * choice.volume_fraction)));
    if (settings.hydrodynamics == Hydrodynamics::stresslet &&
        5.0 * choice.volume_fraction * choice.volume_fraction > scene.solver.accuracy)
        warnings.push_back(fmt::format(
            "Isolated stresslets leave out the hydrodynamics of pairs, about 5 phi^2 = {} of the "
            "stress; hydrodynamics = \"lubrication\" has it.",
            percent(5.0 * choice.volume_fraction * choice.volume_fraction)));
    if (settings.dlvo) {
        double attraction = 0.0;
        const laws::colloid::DlvoCurve curve = curve_of(settings, radius, attraction);
        if (curve.barrier < thermal)
            warnings.push_back(fmt::format(
                "The double layer leaves no barrier against the attraction ({:.2g} kT): the "
                "suspension will aggregate.",
                curve.barrier / thermal));
        if (settings.contact && attraction / settings.contact->stiffness > 0.1 * radius)
            warnings.push_back(fmt::format("Pairs that pass the barrier attract each other with "
                                           "{:.2g} N, which presses springs "
                                           "of {:.2g} N/m in by {:.2g} radii: should pairs get "
                                           "there, the run stops. A stiffer "
                                           "contact or a larger minimum_separation holds them.",
                                           attraction, settings.contact->stiffness,
                                           attraction / settings.contact->stiffness / radius));
        if (settings.dlvo->cutoff < 5.0 * debye_length(*settings.dlvo, settings.temperature))
            warnings.push_back(
                "dlvo.cutoff is less than five Debye lengths: more than 0.7 % of the "
                "double layer's force at contact is cut off.");
    }
    const double peclet =
        6 * std::numbers::pi * viscosity * std::pow(radius, 3) * slowest_rate(forecast) / thermal;
    if (!settings.brownian && peclet < 10.0)
        warnings.push_back(fmt::format(
            "The Peclet number falls to {:.2g}: thermal motion, which brownian = false leaves out, "
            "matters there.",
            peclet));
    return warnings;
}

double expected_seconds(const Scene& scene, const Forecast& forecast,
                        const SuspensionChoice& choice) {
    double strain = 0.0;
    double before = 0.0;
    for (const RowForecast& row : forecast.rows) {
        strain += std::abs(row.shear_rate) * std::max(row.time - before, 0.0);
        before = row.time;
    }
    if (const auto* steps = std::get_if<rheometry::Steps>(&scene.protocol.program))
        if (!steps->hold)
            strain = steps->hold_strain.value_or(10.0) * static_cast<double>(forecast.rows.size());
    const double rate = fastest_rate(forecast);
    if (choice.settings.hydrodynamics == Hydrodynamics::lubrication)
        return strain * choice.count * (0.002 + 0.08 * choice.volume_fraction);
    const double step = choice.settings.time_step.value_or(
        std::min(2e-3 / rate, choice.settings.dlvo ? 6e-7 * 180.0 / rate + 2e-7 : 3e-7));
    const double speed = 4e7 / (1.0 + 4.0 * choice.volume_fraction);
    return strain / rate / step * choice.count / speed;
}

/// Why lubrication cannot be had for these settings; empty when it can.
std::string against_lubrication(const ParticleSettings& settings) {
    if (settings.boundary == ParticleBoundary::walls)
        return "between walls (boundary = \"lees-edwards\" has it in the bulk)";
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
        choice.why_integrator = "With lubrication the motion is overdamped: no inertia.";
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
    plan.model_reason =
        fmt::format("The case has particles: their motion is computed one by one, {}. {}",
                    choice.settings.boundary == ParticleBoundary::walls
                        ? "four-way coupled with the fluid between the walls"
                        : "in uniform shear without walls",
                    choice.why_hydrodynamics);
    plan.can_be_solved = true;
    if (choice.settings.boundary != ParticleBoundary::walls)
        // Sheared everywhere at once: nothing lags behind a wall.
        for (RowForecast& row : forecast.rows) {
            row.lag_share = 0.0;
            row.regime = "laminar";
        }
    plan.items = items_for(scene, forecast, choice);
    plan.warnings = warnings_for(scene, forecast, choice);
    plan.expected_seconds = expected_seconds(scene, forecast, choice);
    plan.expected_unknowns = static_cast<long>(6.0 * choice.count);
}

} // namespace searle::solvers::suspension
