#include "solvers/particles/wall_forces.hpp"

#include "solvers/particles/touching_pair.hpp"

namespace searle::solvers::particles {
namespace {

/// One wall: where it is, how it moves, and which way is out.
struct Wall {
    double y;
    double outwards; ///< +1 for the upper, -1 for the lower wall
    double speed;
};

struct OneWall {
    double x{}, y{};
};

template <class Law>
OneWall act(const Law& law, ParticleStore& p, const AlignedVector<int>& near, Column& spring_x,
            Column& spring_z, const Wall& wall, double step, WallSums& sums) {
    OneWall total;
    for (const int index : near) {
        const auto i = static_cast<std::size_t>(index);
        const double distance = wall.outwards * (wall.y - p.y[i]);
        const double overlap = p.radius[i] - distance;
        if (overlap <= 0.0) {
            spring_x[i] = spring_z[i] = 0.0;
            continue;
        }
        const Touch touch{.nx = 0.0,
                          .ny = wall.outwards,
                          .nz = 0.0,
                          .overlap = overlap,
                          .vx = wall.speed - p.vx[i],
                          .vy = -p.vy[i],
                          .vz = -p.vz[i],
                          .turning_x = distance * p.wx[i],
                          .turning_y = distance * p.wy[i],
                          .turning_z = distance * p.wz[i],
                          .spin_x = -p.wx[i],
                          .spin_y = -p.wy[i],
                          .spin_z = -p.wz[i],
                          .reduced_mass = p.mass[i],
                          .reduced_radius = p.radius[i]};
        double spring_y = 0.0;
        const TouchForce f = touch_force(law, touch, step, spring_x[i], spring_y, spring_z[i]);
        const double fy = f.normal * wall.outwards;
        p.fx[i] -= f.tx;
        p.fy[i] -= fy;
        p.fz[i] -= f.tz;
        p.tx[i] -= distance * wall.outwards * f.tz + f.rx;
        p.ty[i] -= f.ry;
        p.tz[i] += distance * wall.outwards * f.tx - f.rz;
        total.x += f.tx;
        total.y += fy;
        const double ry = wall.outwards * distance;
        sums.contact[3] += ry * f.tx;
        sums.contact[4] += ry * fy;
        sums.contact[5] += ry * f.tz;
        ++sums.contacts;
        if (overlap > sums.largest_overlap) {
            sums.largest_overlap = overlap;
            sums.deepest = p.id[i];
        }
    }
    return total;
}

} // namespace

WallSums add_wall_forces(const laws::contact::AnyContact& contact, ParticleStore& particles,
                         const ShearBox& box, NeighbourList& list, double upper_speed,
                         double step) {
    WallSums sums;
    std::visit(
        [&](const auto& law) {
            const OneWall lower = act(law, particles, list.near_lower, list.lower_x, list.lower_z,
                                      {0.0, -1.0, 0.0}, step, sums);
            const OneWall upper = act(law, particles, list.near_upper, list.upper_x, list.upper_z,
                                      {box.length_y, 1.0, upper_speed}, step, sums);
            sums.lower_x = lower.x;
            sums.lower_y = lower.y;
            sums.upper_x = upper.x;
            sums.upper_y = upper.y;
        },
        contact);
    return sums;
}

} // namespace searle::solvers::particles
