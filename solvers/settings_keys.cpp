#include "solvers/settings_keys.hpp"

#include "laws/flow/flow_law_keys.hpp"

namespace searle::solvers {

casefile::Keys<Fluid> fluid_keys() {
    casefile::Keys<Fluid> keys;
    laws::flow::add_flow_law_keys(keys, &Fluid::law);
    keys.key("density", &Fluid::density)
        .measures(casefile::density)
        .above("0 kg/m^3")
        .at_most("1e6 kg/m^3")
        .required()
        .example("998.2 kg/m^3")
        .says("Mass per volume; decides inertia and the onset of vortices.");
    return keys;
}

namespace {

void declare_openfoam(casefile::Keys<SolverSettings>& keys) {
    keys.choice("application", &SolverSettings::application,
                std::vector<casefile::Named<FoamApplication>>{
                    {"icoFoam", FoamApplication::ico_foam, "in time, Newtonian"},
                    {"nonNewtonianIcoFoam", FoamApplication::non_newtonian_ico_foam,
                     "in time; Debian's is defective"},
                    {"pisoFoam", FoamApplication::piso_foam, "in time"},
                    {"pimpleFoam", FoamApplication::pimple_foam, "in time, outer corrections"},
                    {"simpleFoam", FoamApplication::simple_foam, "steady"}})
        .example("pimpleFoam")
        .or_absent_as("auto", "pimpleFoam in time, simpleFoam for steady rows")
        .not_in_new()
        .says("The OpenFOAM program that solves; for engine = \"openfoam\".");
    keys.key("processors", &SolverSettings::processors)
        .is_integer()
        .at_least("1")
        .at_most("100000")
        .example("2")
        .not_in_new()
        .says("Processes that OpenFOAM runs on; for engine = \"openfoam\".");
    keys.key("time_step", &SolverSettings::time_step)
        .measures(casefile::duration)
        .above("0 s")
        .at_most("1e6 s")
        .example("20 ms")
        .or_absent_as("auto", "a fraction of the time between rows")
        .not_in_new()
        .says("OpenFOAM's longest time step on the finest level; for engine = \"openfoam\".");
    keys.key("viscosity_cap", &SolverSettings::viscosity_cap)
        .measures(casefile::viscosity)
        .above("0 Pa.s")
        .at_most("1e12 Pa.s")
        .example("100 Pa.s")
        .or_absent_as("auto", "high enough for the accuracy")
        .not_in_new()
        .says("Largest viscosity of a fluid below its yield stress; for engine = \"openfoam\".");
}

} // namespace

casefile::Keys<SolverSettings> solver_keys() {
    casefile::Keys<SolverSettings> keys;
    keys.choice<Engine SolverSettings::*, Engine>(
            "engine", &SolverSettings::engine,
            {{"native", Engine::native, "this program"},
             {"openfoam", Engine::openfoam, "OpenFOAM, when it is installed"}})
        .example("native")
        .says("What solves the flow.");
    keys.choice<Model SolverSettings::*, Model>(
            "model", &SolverSettings::model,
            {{"auto", Model::automatic, "the cheapest model that is right"},
             {"radial", Model::radial, "an endless gap, one coordinate"},
             {"axisymmetric", Model::axisymmetric, "ends included, two coordinates"},
             {"3d", Model::three_dimensional, "everything"}})
        .example("auto")
        .says("The model; an explicit one is obeyed at any speed.");
    keys.key("accuracy", &SolverSettings::accuracy)
        .measures(casefile::fraction)
        .is_number()
        .at_least("1e-10")
        .below("1")
        .example("0.1 %")
        .says("Asked-for relative error of every shear stress.");
    keys.custom(
            "secondary_flow",
            [](SolverSettings& settings, const casefile::Value& value) {
                const bool* wanted = std::get_if<bool>(&value.is);
                settings.secondary_flow =
                    !wanted ? Switch::automatic : (*wanted ? Switch::on : Switch::off);
            },
            [](const SolverSettings& settings) -> std::optional<casefile::Value> {
                if (settings.secondary_flow == Switch::automatic)
                    return casefile::Value{std::string{"auto"}};
                return casefile::Value{settings.secondary_flow == Switch::on};
            })
        .is_boolean()
        .word("auto", "where it matters")
        .example("auto")
        .says("Flow in the (r, z) plane beside the swirl, for the axisymmetric model.");
    keys.custom(
            "vortex_wavelength",
            [](SolverSettings& settings, const casefile::Value& value) {
                casefile::Slot<std::optional<double>>::store(settings.vortex_wavelength, value);
            },
            [](const SolverSettings& settings) -> std::optional<casefile::Value> {
                return settings.vortex_wavelength ? casefile::Value{*settings.vortex_wavelength}
                                                  : casefile::Value{std::string{"auto"}};
            })
        .measures(casefile::length)
        .above("0 m")
        .at_most("10 m")
        .word("auto", "the most unstable one")
        .example("4 mm")
        .not_in_new()
        .says("Axial period of Taylor vortices (two of them) past their onset.");
    keys.key("disturbance", &SolverSettings::disturbance)
        .is_number()
        .above("0")
        .at_most("0.1")
        .example("1e-3")
        .not_in_new()
        .says("Unevenness of the rotor's speed along its axis, which Taylor vortices grow from.");
    declare_openfoam(keys);
    return keys;
}

casefile::Keys<OutputSettings> output_keys() {
    casefile::Keys<OutputSettings> keys;
    keys.key("fields", &OutputSettings::fields)
        .is_boolean()
        .example("false")
        .says("Write and draw the flow in the section (fields/, .vtu); of particles: structure "
              "(.csv).");
    keys.key("field_rows", &OutputSettings::field_rows)
        .is_integer()
        .at_least("1")
        .at_most("1000")
        .example("5")
        .not_in_new()
        .says("With fields = true: for how many rows, evenly spread, the last included.");
    keys.key("trajectory_strain", &OutputSettings::trajectory_strain)
        .is_number()
        .above("0")
        .at_most("1000")
        .example("0.1")
        .not_in_new()
        .says("Of a suspension: strain between frames (.vtp, for ParaView and OVITO); absent: no "
              "frames.");
    return keys;
}

} // namespace searle::solvers
