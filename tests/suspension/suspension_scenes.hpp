#pragma once

#include "solvers/particles/packing.hpp"
#include "solvers/suspension/suspension_input.hpp"

namespace searle::solvers::suspension::testing {

inline constexpr double water_viscosity = 1.0016e-3;
inline constexpr double water_density = 998.2;

/// The zirconia of the paper in a cube of `side`: 1.5 um, 5700 kg/m^3.
inline SuspensionInput zirconia(double side, double volume_fraction, double shear_rate) {
    SuspensionInput input;
    input.box = {.length_x = side, .length_y = side, .length_z = side};
    input.settings.diameter = 1.5e-6;
    input.settings.density = 5700.0;
    input.settings.volume_fraction = volume_fraction;
    input.settings.hydrodynamics = Hydrodynamics::drag;
    input.settings.integrator = Integrator::implicit_drag;
    input.settings.contact.emplace();
    input.settings.contact->stiffness = 1e-2;
    input.viscosity = water_viscosity;
    input.density = water_density;
    input.accuracy = 1e-3;
    input.initial_wall_speed = shear_rate * side;
    input.fastest_wall_speed = shear_rate * side;
    return input;
}

inline ColloidSettings zirconia_colloid() {
    ColloidSettings colloid;
    colloid.hamaker = 6e-20;
    colloid.zeta_potential = 32e-3;
    colloid.debye_length = 10e-9;
    return colloid;
}

/// Elastic spheres in place of springs. @param shear_modulus Pa
inline void use_hertz(SuspensionInput& input, double shear_modulus) {
    input.settings.contact->model = ContactModel::hertz;
    input.settings.contact->stiffness.reset();
    input.settings.shear_modulus = shear_modulus;
    input.settings.poisson_ratio = 0.3;
}

/// Places the particles at random.
inline void pack(SuspensionInput& input, std::uint64_t seed = 1) {
    input.particles = particles::random_packing({.sizes = {{*input.settings.diameter, 1.0}},
                                                 .volume_fraction = input.settings.volume_fraction,
                                                 .density = input.settings.density,
                                                 .gap = input.settings.dlvo ? 30e-9 : 0.0,
                                                 .seed = seed},
                                                input.box);
}

/// With films, without walls.
inline SuspensionInput bulk(double side, double fraction, double rate) {
    SuspensionInput input = zirconia(side, fraction, rate);
    input.box.walls = false;
    input.settings.hydrodynamics = Hydrodynamics::lubrication;
    input.accuracy = 1e-2;
    return input;
}

/// With films, between walls.
inline SuspensionInput between_walls(double side, double fraction, double rate) {
    SuspensionInput input = bulk(side, fraction, rate);
    input.box.walls = true;
    input.coupling.cells = {8, 8, 8};
    return input;
}

} // namespace searle::solvers::suspension::testing
