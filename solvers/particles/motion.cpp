#include "solvers/particles/motion.hpp"

#include "laws/exponential.hpp"
#include "solvers/particles/random_numbers.hpp"

#include <algorithm>
#include <cmath>

namespace searle::solvers::particles {
namespace {

// In the loops below `if (parallel : ...)` leaves out the threads alone: a plain `if` would make
// the loop scalar as well where there is one thread (OpenMP 5.0, 2.9.3.1).

/// Moment of inertia of a sphere over m r^2.
constexpr double inertia_factor = 0.4;

/// The displacements and velocities that random forces add within a step.
void add_thermal_motion(ParticleStore& p, Surroundings& s, const Brownian& brownian, double step,
                        double& largest) {
    const std::uint64_t key = mixed(brownian.key) ^ mixed(brownian.step + 0x5851f42dULL);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double tau = p.mass[i] / s.drag[i];
        const double ratio = step / tau;
        const double lost = -std::expm1(-ratio);
        const double kept = 1.0 - lost;
        const double thermal = brownian.thermal_energy / p.mass[i];
        const double velocity_variance = thermal * lost * (1.0 + kept);
        const double covariance = thermal * tau * lost * lost;
        // 2 r - 3 + 4 e^-r - e^-2r cancels for short steps: its series there.
        const double bracket = ratio < 1e-2 ? ratio * ratio * ratio * (2.0 / 3.0 - 0.5 * ratio)
                                            : 2.0 * ratio - 3.0 + 4.0 * kept - kept * kept;
        const double place_variance = thermal * tau * tau * bracket;
        const double velocity_size = std::sqrt(velocity_variance);
        const double along = covariance / velocity_size;
        const double beside = std::sqrt(std::max(place_variance - along * along, 0.0));
        double* place[3] = {&p.x[i], &p.y[i], &p.z[i]};
        double* velocity[3] = {&p.vx[i], &p.vy[i], &p.vz[i]};
        const auto number = static_cast<std::uint64_t>(p.id[i]) * 16;
        double squared = 0.0;
        for (std::uint64_t c = 0; c < 3; ++c) {
            const double first = normal(key, number + 2 * c);
            const double second = normal(key, number + 2 * c + 1);
            const double moved = along * first + beside * second;
            *velocity[c] += velocity_size * first;
            *place[c] += moved;
            squared += moved * moved;
            if (c == 0)
                s.impulse_x[i] += p.mass[i] * velocity_size * first;
        }
        largest = std::max(largest, std::sqrt(squared));
        if (s.rotational_drag[i] > 0.0) {
            const double inertia = inertia_factor * p.mass[i] * p.radius[i] * p.radius[i];
            const double turned = -std::expm1(-2.0 * step * s.rotational_drag[i] / inertia);
            const double spin = std::sqrt(brownian.thermal_energy / inertia * turned);
            p.wx[i] += spin * normal(key, number + 6);
            p.wy[i] += spin * normal(key, number + 7);
            p.wz[i] += spin * normal(key, number + 8);
        }
    }
}

void turn_with_exact_drag(ParticleStore& p, const Surroundings& s, double step, int threads) {
    const auto count = static_cast<long>(p.size());
    double *wx = p.wx.data(), *wy = p.wy.data(), *wz = p.wz.data();
    const double *tx = p.tx.data(), *ty = p.ty.data(), *tz = p.tz.data();
    const double *mass = p.mass.data(), *radius = p.radius.data();
    const double *drag = s.rotational_drag.data(), *spin = s.spin_z.data();
#pragma omp parallel for simd schedule(static) num_threads(threads) if (parallel : threads > 1)
    for (long i = 0; i < count; ++i) {
        const double inertia = inertia_factor * mass[i] * radius[i] * radius[i];
        // Without drag (0) the limit is a kick by torque / inertia.
        const double least = 1e-12 * inertia / step;
        const double safe = drag[i] < least ? least : drag[i];
        const double kept = laws::exponential(-step * safe / inertia);
        const double goal_z = spin[i] + tz[i] / safe;
        wx[i] = tx[i] / safe + (wx[i] - tx[i] / safe) * kept;
        wy[i] = ty[i] / safe + (wy[i] - ty[i] / safe) * kept;
        wz[i] = goal_z + (wz[i] - goal_z) * kept;
    }
}

} // namespace

double move_with_exact_drag(ParticleStore& p, Surroundings& s, const Brownian& brownian,
                            double step, double mean_shear, int threads) {
    const auto count = static_cast<long>(p.size());
    double *x = p.x.data(), *y = p.y.data(), *z = p.z.data();
    double *vx = p.vx.data(), *vy = p.vy.data(), *vz = p.vz.data();
    const double *fx = p.fx.data(), *fy = p.fy.data(), *fz = p.fz.data();
    const double *mass = p.mass.data(), *drag = s.drag.data(), *flow = s.flow_x.data();
    const double* viscous = s.viscous_x.data();
    double* impulse = s.impulse_x.data();
    const double flow_z = s.flow_z;
    double largest_squared = 0.0;
#pragma omp parallel for simd schedule(static) num_threads(threads) if (parallel                   \
                                                                        : threads > 1)             \
    reduction(max                                                                                  \
              : largest_squared)
    for (long i = 0; i < count; ++i) {
        const double mobility = 1.0 / drag[i];
        const double tau = mass[i] * mobility;
        const double kept = laws::exponential(-step * drag[i] / mass[i]);
        const double reach = tau * (1.0 - kept);
        const double goal_x = flow[i] + (fx[i] + viscous[i]) * mobility;
        const double goal_y = fy[i] * mobility;
        const double goal_z = flow_z + fz[i] * mobility;
        const double dx = goal_x * step + (vx[i] - goal_x) * reach;
        const double dy = goal_y * step + (vy[i] - goal_y) * reach;
        const double dz = goal_z * step + (vz[i] - goal_z) * reach;
        const double new_vx = goal_x + (vx[i] - goal_x) * kept;
        impulse[i] += mass[i] * (new_vx - vx[i]) - fx[i] * step;
        vx[i] = new_vx;
        vy[i] = goal_y + (vy[i] - goal_y) * kept;
        vz[i] = goal_z + (vz[i] - goal_z) * kept;
        const double beside = dx - mean_shear * y[i] * step;
        x[i] += dx;
        y[i] += dy;
        z[i] += dz;
        const double squared = beside * beside + dy * dy + dz * dz;
        largest_squared = squared > largest_squared ? squared : largest_squared;
    }
    turn_with_exact_drag(p, s, step, threads);
    double largest_thermal = 0.0;
    if (brownian.thermal_energy > 0.0)
        add_thermal_motion(p, s, brownian, step, largest_thermal);
    return std::sqrt(largest_squared) + largest_thermal;
}

double kick_and_drift(ParticleStore& p, double step, double mean_shear, int threads) {
    kick(p, step, threads);
    const auto count = static_cast<long>(p.size());
    double *x = p.x.data(), *y = p.y.data(), *z = p.z.data();
    const double *vx = p.vx.data(), *vy = p.vy.data(), *vz = p.vz.data();
    double largest_squared = 0.0;
#pragma omp parallel for simd schedule(static) num_threads(threads) if (parallel                   \
                                                                        : threads > 1)             \
    reduction(max                                                                                  \
              : largest_squared)
    for (long i = 0; i < count; ++i) {
        const double beside = vx[i] - mean_shear * y[i];
        largest_squared =
            std::max(largest_squared, beside * beside + vy[i] * vy[i] + vz[i] * vz[i]);
        x[i] += step * vx[i];
        y[i] += step * vy[i];
        z[i] += step * vz[i];
    }
    return step * std::sqrt(largest_squared);
}

void kick(ParticleStore& p, double step, int threads) {
    const auto count = static_cast<long>(p.size());
    double *vx = p.vx.data(), *vy = p.vy.data(), *vz = p.vz.data();
    double *wx = p.wx.data(), *wy = p.wy.data(), *wz = p.wz.data();
    const double *fx = p.fx.data(), *fy = p.fy.data(), *fz = p.fz.data();
    const double *tx = p.tx.data(), *ty = p.ty.data(), *tz = p.tz.data();
    const double *mass = p.mass.data(), *radius = p.radius.data();
#pragma omp parallel for simd schedule(static) num_threads(threads) if (parallel : threads > 1)
    for (long i = 0; i < count; ++i) {
        const double impulse = 0.5 * step / mass[i];
        const double turn = impulse / (inertia_factor * radius[i] * radius[i]);
        vx[i] += impulse * fx[i];
        vy[i] += impulse * fy[i];
        vz[i] += impulse * fz[i];
        wx[i] += turn * tx[i];
        wy[i] += turn * ty[i];
        wz[i] += turn * tz[i];
    }
}

void add_explicit_drag(ParticleStore& p, const Surroundings& s, int threads) {
    const auto count = static_cast<long>(p.size());
    const double flow_z = s.flow_z;
#pragma omp parallel for simd schedule(static) num_threads(threads) if (parallel : threads > 1)
    for (long at = 0; at < count; ++at) {
        const auto i = static_cast<std::size_t>(at);
        const double along = s.drag[i] * (s.flow_x[i] - p.vx[i]);
        p.fx[i] += along + s.viscous_x[i];
        p.fy[i] -= s.drag[i] * p.vy[i];
        p.fz[i] += s.drag[i] * (flow_z - p.vz[i]);
        p.tx[i] -= s.rotational_drag[i] * p.wx[i];
        p.ty[i] -= s.rotational_drag[i] * p.wy[i];
        p.tz[i] += s.rotational_drag[i] * (s.spin_z[i] - p.wz[i]);
    }
}

void clear_forces(ParticleStore& p) {
    for (Column* column : {&p.fx, &p.fy, &p.fz, &p.tx, &p.ty, &p.tz})
        std::fill(column->begin(), column->end(), 0.0);
}

} // namespace searle::solvers::particles
