#include "solvers/suspension/particle_checkpoint.hpp"

#include <fmt/format.h>

namespace searle::solvers::suspension {

void put_particles(Checkpoint& into, const particles::ParticleStore& particles,
                   const particles::ShearBox& box, const particles::NeighbourList& list,
                   const StepCounts& counts) {
    const auto columns = particles.columns();
    for (std::size_t k = 0; k < columns.size(); ++k)
        into.put(fmt::format("particle_{:02}", k), *columns[k]);
    into.put("particle_id", particles.id);
    into.put("box", std::vector<double>{box.image_offset, box.image_speed, box.shear_rate});
    into.put("list_first", list.first);
    into.put("list_second", list.second);
    into.put("list_spring_x", list.spring_x);
    into.put("list_spring_y", list.spring_y);
    into.put("list_spring_z", list.spring_z);
    into.put("list_lower_x", list.lower_x);
    into.put("list_lower_z", list.lower_z);
    into.put("list_upper_x", list.upper_x);
    into.put("list_upper_z", list.upper_z);
    into.put("list_near_lower", list.near_lower);
    into.put("list_near_upper", list.near_upper);
    into.put("list_built_x", list.built_x);
    into.put("list_built_y", list.built_y);
    into.put("list_built_z", list.built_z);
    const auto state = list.state();
    into.put("list_state", std::vector<double>{state.moved, state.strain, state.largest_distance,
                                               static_cast<double>(state.rebuilds)});
    into.put("counts", std::vector<double>{static_cast<double>(counts.steps),
                                           static_cast<double>(counts.fluid_steps),
                                           static_cast<double>(counts.rebuilds),
                                           counts.shortest_step, counts.longest_step,
                                           static_cast<double>(counts.solver_iterations)});
}

void get_particles(const Checkpoint& from, particles::ParticleStore& particles,
                   particles::ShearBox& box, particles::NeighbourList& list, StepCounts& counts) {
    const auto columns = particles.columns();
    for (std::size_t k = 0; k < columns.size(); ++k)
        from.get(fmt::format("particle_{:02}", k), *columns[k]);
    from.get("particle_id", particles.id);
    const std::vector<double>& of_box = from.column("box");
    box.image_offset = of_box.at(0);
    box.image_speed = of_box.at(1);
    box.shear_rate = of_box.at(2);
    from.get("list_first", list.first);
    from.get("list_second", list.second);
    from.get("list_spring_x", list.spring_x);
    from.get("list_spring_y", list.spring_y);
    from.get("list_spring_z", list.spring_z);
    from.get("list_lower_x", list.lower_x);
    from.get("list_lower_z", list.lower_z);
    from.get("list_upper_x", list.upper_x);
    from.get("list_upper_z", list.upper_z);
    from.get("list_near_lower", list.near_lower);
    from.get("list_near_upper", list.near_upper);
    from.get("list_built_x", list.built_x);
    from.get("list_built_y", list.built_y);
    from.get("list_built_z", list.built_z);
    const std::vector<double>& state = from.column("list_state");
    list.restore({state.at(0), state.at(1), state.at(2), static_cast<long>(state.at(3))});
    const std::vector<double>& numbers = from.column("counts");
    counts = {static_cast<long>(numbers.at(0)),
              static_cast<long>(numbers.at(1)),
              static_cast<long>(numbers.at(2)),
              numbers.at(3),
              numbers.at(4),
              static_cast<long>(numbers.at(5))};
}

} // namespace searle::solvers::suspension
