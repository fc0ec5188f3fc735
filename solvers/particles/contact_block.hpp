#pragma once

#include "solvers/particles/shear_box.hpp"
#include "solvers/particles/touching_pair.hpp"

#include <cmath>

namespace searle::solvers::particles {

/// A block of pairs, between reading particles and adding to them. Both jump about in memory, and
/// two pairs may add to one particle: they go pair by pair, the law between them goes over whole
/// vector registers.
struct ContactBlock {
    /// Pairs at a time: the block stays in the fastest cache.
    static constexpr int size = 64;
    static constexpr int lanes = 8;
    using Values = double[size];

    /// The second's less the first's: place (m), velocity (m/s), radius, angular velocity (1/s).
    alignas(64) Values dx, dy, dz, vx, vy, vz, radii_apart, spin_x, spin_y, spin_z;
    /// Sums of both: angular velocity, radius, inverse mass.
    alignas(64) Values wx, wy, wz, radii, inverse_masses;
    alignas(64) Values sx, sy, sz; ///< springs, m

    alignas(64) Values fx, fy, fz;    ///< on the second, N
    alignas(64) Values tx1, ty1, tz1; ///< torque taken from the first, N m
    alignas(64) Values tx2, ty2, tz2; ///< torque added to the second
    alignas(64) Values overlap;       ///< m
};

/// The law for the first `count` pairs; also for what lies behind them up to a whole register,
/// which nobody reads. Pairs that do not touch get no force and lose their spring.
template <bool friction, bool rolling, class Law>
void act(ContactBlock& b, const Law& law, const NearestImage& nearest, double step, int count) {
    constexpr int lanes = ContactBlock::lanes;
    const int padded = (count + lanes - 1) / lanes * lanes;
#pragma omp simd
    for (int m = 0; m < padded; ++m) {
        double dx = b.dx[m];
        double dy = b.dy[m];
        double dz = b.dz[m];
        const double crossings = nearest(dx, dy, dz);
        const double r = std::sqrt(dx * dx + dy * dy + dz * dz);
        const double inverse = 1.0 / r;
        const double overlap = b.radii[m] - r;
        const double lever = 0.5 * (b.radii[m] - overlap);
        const double difference = 0.5 * b.radii_apart[m];
        const double reduced_radius =
            rolling || Law::depends_on_radii
                ? 0.25 * (b.radii[m] * b.radii[m] - b.radii_apart[m] * b.radii_apart[m]) /
                      b.radii[m]
                : 0.0;
        const Touch touch{.nx = dx * inverse,
                          .ny = dy * inverse,
                          .nz = dz * inverse,
                          .overlap = overlap,
                          .vx = b.vx[m] - crossings * nearest.speed,
                          .vy = b.vy[m],
                          .vz = b.vz[m],
                          // lever_1 w_1 + lever_2 w_2 by sum and difference of the two.
                          .turning_x = lever * b.wx[m] + difference * b.spin_x[m],
                          .turning_y = lever * b.wy[m] + difference * b.spin_y[m],
                          .turning_z = lever * b.wz[m] + difference * b.spin_z[m],
                          .spin_x = b.spin_x[m],
                          .spin_y = b.spin_y[m],
                          .spin_z = b.spin_z[m],
                          .reduced_mass = 1.0 / b.inverse_masses[m],
                          .reduced_radius = reduced_radius};
        double sx = b.sx[m];
        double sy = b.sy[m];
        double sz = b.sz[m];
        const TouchForce f = touch_force<friction, rolling>(law, touch, step, sx, sy, sz);
        const bool touches = overlap > 0.0;
        const double fx = touches ? f.normal * touch.nx + f.tx : 0.0;
        const double fy = touches ? f.normal * touch.ny + f.ty : 0.0;
        const double fz = touches ? f.normal * touch.nz + f.tz : 0.0;
        b.dx[m] = dx;
        b.dy[m] = dy;
        b.dz[m] = dz;
        b.fx[m] = fx;
        b.fy[m] = fy;
        b.fz[m] = fz;
        b.overlap[m] = overlap;
        if constexpr (friction) {
            b.sx[m] = touches ? sx : 0.0;
            b.sy[m] = touches ? sy : 0.0;
            b.sz[m] = touches ? sz : 0.0;
            const double cx = touch.ny * f.tz - touch.nz * f.ty;
            const double cy = touch.nz * f.tx - touch.nx * f.tz;
            const double cz = touch.nx * f.ty - touch.ny * f.tx;
            const double first = lever - difference;
            const double second = lever + difference;
            b.tx1[m] = touches ? first * cx + f.rx : 0.0;
            b.ty1[m] = touches ? first * cy + f.ry : 0.0;
            b.tz1[m] = touches ? first * cz + f.rz : 0.0;
            b.tx2[m] = touches ? f.rx - second * cx : 0.0;
            b.ty2[m] = touches ? f.ry - second * cy : 0.0;
            b.tz2[m] = touches ? f.rz - second * cz : 0.0;
        }
    }
}

} // namespace searle::solvers::particles
