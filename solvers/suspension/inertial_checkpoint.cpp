#include "solvers/suspension/inertial_motion.hpp"
#include "solvers/suspension/particle_checkpoint.hpp"

#include <fmt/format.h>

namespace searle::solvers::suspension {

void InertialMotion::save(Checkpoint& into) const {
    put_particles(into, particles_, box_, list_, counts_);
    for (std::size_t k = 0; k < companions_.size(); ++k)
        into.put(fmt::format("companion_{:02}", k), *companions_[k]);
    into.put("motion", std::vector<double>{
                           time_, last_step_, wall_contact_impulse_, surroundings_.flow_z,
                           static_cast<double>(brownian_.step), control_.step(), control_.longest(),
                           forces_known_ ? 1.0 : 0.0, change_known_ ? 1.0 : 0.0, wall_sums_.upper_x,
                           wall_sums_.lower_x});
    if (profile_) {
        const FluidProfile::State state = profile_->state();
        into.put("fluid_velocity", state.velocity);
        into.put("fluid_viscous_force", state.viscous_force);
        into.put("fluid_couple", state.couple);
        into.put("fluid_predicted", state.predicted);
        into.put("fluid_momentum", std::vector<double>{state.momentum_gained, state.wall_impulse});
    }
}

void InertialMotion::restore(const Checkpoint& from) {
    get_particles(from, particles_, box_, list_, counts_);
    for (std::size_t k = 0; k < companions_.size(); ++k)
        from.get(fmt::format("companion_{:02}", k), *companions_[k]);
    const std::vector<double>& motion = from.column("motion");
    time_ = motion.at(0);
    last_step_ = motion.at(1);
    wall_contact_impulse_ = motion.at(2);
    surroundings_.flow_z = motion.at(3);
    brownian_.step = static_cast<std::uint64_t>(motion.at(4));
    if (!input_.settings.time_step)
        control_.set_longest(motion.at(6));
    control_.restore(motion.at(5));
    forces_known_ = motion.at(7) != 0.0;
    change_known_ = motion.at(8) != 0.0;
    wall_sums_.upper_x = motion.at(9);
    wall_sums_.lower_x = motion.at(10);
    if (profile_)
        profile_->restore({from.column("fluid_velocity"), from.column("fluid_viscous_force"),
                           from.column("fluid_couple"), from.column("fluid_predicted"),
                           from.column("fluid_momentum").at(0),
                           from.column("fluid_momentum").at(1)});
}

} // namespace searle::solvers::suspension
