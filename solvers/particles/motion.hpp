#pragma once

#include "solvers/particles/particle_store.hpp"

#include <cstdint>

namespace searle::solvers::particles {

/// The fluid as each particle meets it.
struct Surroundings {
    Column drag;            ///< force over slip velocity, kg/s
    Column rotational_drag; ///< torque over slip in angular velocity, kg m^2/s; 0: none
    Column flow_x;          ///< fluid velocity along the flow, m/s
    Column spin_z;          ///< half the fluid's vorticity, 1/s
    double flow_z{};        ///< fluid velocity along the vorticity, m/s
    /// Further force of the fluid on each particle in x, N: d/dy(mu du/dy) on its volume.
    Column viscous_x;
    /// Sum of the fluid's impulses on each particle in x (drag and viscous_x), N s; the fluid has
    /// their opposite.
    Column impulse_x;

    [[nodiscard]] std::array<Column*, 6> columns() {
        return {&drag, &rotational_drag, &flow_x, &spin_z, &viscous_x, &impulse_x};
    }
    void resize(std::size_t count) {
        for (Column* column : columns())
            column->resize(count, 0.0);
    }
};

/// Thermal motion.
struct Brownian {
    double thermal_energy{}; ///< k T, J; 0: none
    std::uint64_t key{};     ///< of the random numbers
    std::uint64_t step{};    ///< counts the steps
};

/// One step with force and fluid velocity held: m dv/dt = F - drag (v - u) solved exactly (the same
/// for the rotation), so that no step is too long for the drag. Local error of second order in the
/// step, from the change of the force. With thermal motion the exact joint distribution of velocity
/// and displacement (Chandrasekhar 1943, Rev. Mod. Phys. 15, 1, section II).
/// Adds the drag's impulse to surroundings.impulse_x.
/// @param mean_shear of the flow that the neighbour list is deformed with, 1/s
/// @return upper bound of a particle's displacement beside the mean shear, m
double move_with_exact_drag(ParticleStore& particles, Surroundings& surroundings,
                            const Brownian& brownian, double step, double mean_shear, int threads);

/// First half of a velocity-Verlet step (Swope et al. 1982, J. Chem. Phys. 76, 637): half of the
/// forces' kick, then the move. Forces are evaluated at the new places, then kick().
/// @return as move_with_exact_drag
double kick_and_drift(ParticleStore& particles, double step, double mean_shear, int threads);
/// Second half: the other half of the kick.
void kick(ParticleStore& particles, double step, int threads);

/// Adds the fluid's forces at the present velocities to the others.
void add_explicit_drag(ParticleStore& particles, const Surroundings& surroundings, int threads);

void clear_forces(ParticleStore& particles);

} // namespace searle::solvers::particles
