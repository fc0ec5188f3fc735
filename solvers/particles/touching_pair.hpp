#pragma once

#include "laws/contact/contact_law.hpp"

#include <algorithm>
#include <cmath>

namespace searle::solvers::particles {

/// Two touching spheres, or a sphere and a wall, seen from the first: `normal` points to the
/// second.
struct Touch {
    double nx, ny, nz;
    double overlap;    ///< m, > 0
    double vx, vy, vz; ///< velocity of the second's centre less that of the first, m/s
    /// Sum over both of the lever (centre to contact) times the angular velocity, m/s.
    double turning_x, turning_y, turning_z;
    double spin_x, spin_y, spin_z; ///< angular velocity of the second less that of the first, 1/s
    double reduced_mass;           ///< kg
    double reduced_radius;         ///< r_1 r_2 / (r_1 + r_2), m
};

/// Force on the second and the rolling torque on it (the first has the opposite of both).
struct TouchForce {
    double normal;     ///< along the normal, N
    double tx, ty, tz; ///< tangential force, N
    double rx, ry, rz; ///< rolling torque on the second, N m
};

/// The law (Hooke, Hertz) for one contact; moves the tangential spring (sx, sy, sz) by `step`. The
/// spring is kept in the tangent plane and cut back to Coulomb's limit while the contact slides.
/// Without jumps, so that a loop over contacts becomes a vector loop.
template <bool friction, bool rolling, class Law>
TouchForce touch_force(const Law& law, const Touch& t, double step, double& sx, double& sy,
                       double& sz) {
    TouchForce out{};
    const laws::contact::ContactSpring spring = law.at(t.overlap, t.reduced_radius, t.reduced_mass);
    const double separating = t.vx * t.nx + t.vy * t.ny + t.vz * t.nz;
    out.normal = spring.normal * t.overlap - spring.damping * separating;
    if constexpr (!friction)
        return out;
    const double sliding_x = t.vx - separating * t.nx - (t.turning_y * t.nz - t.turning_z * t.ny);
    const double sliding_y = t.vy - separating * t.ny - (t.turning_z * t.nx - t.turning_x * t.nz);
    const double sliding_z = t.vz - separating * t.nz - (t.turning_x * t.ny - t.turning_y * t.nx);
    sx += sliding_x * step;
    sy += sliding_y * step;
    sz += sliding_z * step;
    const double out_of_plane = sx * t.nx + sy * t.ny + sz * t.nz;
    sx -= out_of_plane * t.nx;
    sy -= out_of_plane * t.ny;
    sz -= out_of_plane * t.nz;
    const double dashpot = 0.5 * spring.damping;
    const double stiffness = spring.tangential;
    out.tx = -stiffness * sx - dashpot * sliding_x;
    out.ty = -stiffness * sy - dashpot * sliding_y;
    out.tz = -stiffness * sz - dashpot * sliding_z;
    const double size = std::sqrt(out.tx * out.tx + out.ty * out.ty + out.tz * out.tz);
    const double limit = law.friction * std::abs(out.normal);
    const bool slides = size > limit;
    const double share = slides ? limit / size : 1.0;
    out.tx *= share;
    out.ty *= share;
    out.tz *= share;
    // Without a spring nothing is to be cut back.
    const bool cut = slides && stiffness > 0.0;
    const double softness = stiffness > 0.0 ? 1.0 / stiffness : 0.0;
    sx = cut ? -(out.tx + dashpot * sliding_x) * softness : sx;
    sy = cut ? -(out.ty + dashpot * sliding_y) * softness : sy;
    sz = cut ? -(out.tz + dashpot * sliding_z) * softness : sz;
    if constexpr (rolling) {
        // A constant torque against the rolling (Ai et al. 2011, Powder Technol. 206, 269, type A),
        // viscous below it, so that it does not jump at rest.
        const double twist = t.spin_x * t.nx + t.spin_y * t.ny + t.spin_z * t.nz;
        const double rolling_x = t.spin_x - twist * t.nx;
        const double rolling_y = t.spin_y - twist * t.ny;
        const double rolling_z = t.spin_z - twist * t.nz;
        const double speed =
            std::sqrt(rolling_x * rolling_x + rolling_y * rolling_y + rolling_z * rolling_z);
        const double viscous = dashpot * t.reduced_radius * t.reduced_radius;
        const double most = law.rolling_friction * t.reduced_radius * std::abs(out.normal);
        const double factor = speed * viscous > most ? most / speed : viscous;
        out.rx = -factor * rolling_x;
        out.ry = -factor * rolling_y;
        out.rz = -factor * rolling_z;
    }
    return out;
}

/// The same, of whatever the law has.
template <class Law>
TouchForce touch_force(const Law& law, const Touch& t, double step, double& sx, double& sy,
                       double& sz) {
    if (law.friction == 0.0)
        return touch_force<false, false>(law, t, step, sx, sy, sz);
    if (law.rolling_friction == 0.0)
        return touch_force<true, false>(law, t, step, sx, sy, sz);
    return touch_force<true, true>(law, t, step, sx, sy, sz);
}

} // namespace searle::solvers::particles
