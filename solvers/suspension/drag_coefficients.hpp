#pragma once

#include "solvers/particles/motion.hpp"
#include "solvers/particles/particle_store.hpp"
#include "solvers/suspension/suspension_settings.hpp"

namespace searle::solvers::suspension {

struct DragChoice {
    Drag law = Drag::di_felice;
    CouplingModel model = CouplingModel::a;
    double viscosity{}; ///< Pa s
    double density{};   ///< of the fluid, kg/m^3
};

/// Sets surroundings.drag of every particle from its slip against the fluid at it (flow_x, flow_z)
/// and the fluid fraction there; Model B's are Model A's over the fluid fraction.
void set_drag(const DragChoice& choice, const particles::ParticleStore& particles,
              particles::Surroundings& surroundings, const particles::Column& fluid_fraction,
              int threads);

/// Sets surroundings.rotational_drag: 8 pi mu r^3.
void set_rotational_drag(double viscosity, const particles::ParticleStore& particles,
                         particles::Surroundings& surroundings);

} // namespace searle::solvers::suspension
