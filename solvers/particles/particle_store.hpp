#pragma once

#include "solvers/particles/aligned_vector.hpp"

#include <array>
#include <cstdint>
#include <numbers>

namespace searle::solvers::particles {

/// Spheres as a structure of arrays, SI units; x along the flow, y across the gap, z along the
/// vorticity. The order changes when the neighbour list is rebuilt; `id` names a particle for good.
struct ParticleStore {
    Column x, y, z;        ///< m
    Column vx, vy, vz;     ///< m/s
    Column wx, wy, wz;     ///< angular velocity, rad/s
    Column radius;         ///< m
    Column mass;           ///< kg
    Column fx, fy, fz;     ///< force of the present step, N
    Column tx, ty, tz;     ///< torque, N m
    AlignedVector<int> id; ///< 0 ... size - 1

    [[nodiscard]] std::size_t size() const { return x.size(); }

    /// Every column of numbers, for loops over all of them.
    [[nodiscard]] std::array<Column*, 17> columns() {
        return {&x,      &y,    &z,  &vx, &vy, &vz, &wx, &wy, &wz,
                &radius, &mass, &fx, &fy, &fz, &tx, &ty, &tz};
    }
    [[nodiscard]] std::array<const Column*, 17> columns() const {
        return {&x,      &y,    &z,  &vx, &vy, &vz, &wx, &wy, &wz,
                &radius, &mass, &fx, &fy, &fz, &tx, &ty, &tz};
    }

    void resize(std::size_t count) {
        for (Column* column : columns())
            column->resize(count, 0.0);
        const std::size_t before = id.size();
        id.resize(count);
        for (std::size_t i = before; i < count; ++i)
            id[i] = static_cast<int>(i);
    }
    /// Adds a sphere at rest. @param density kg/m^3
    void add(double at_x, double at_y, double at_z, double of_radius, double density) {
        const std::size_t i = size();
        resize(i + 1);
        x[i] = at_x;
        y[i] = at_y;
        z[i] = at_z;
        radius[i] = of_radius;
        mass[i] = density * volume(i);
    }
    [[nodiscard]] double volume(std::size_t i) const {
        return 4.0 / 3.0 * std::numbers::pi * radius[i] * radius[i] * radius[i];
    }
    [[nodiscard]] double total_volume() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < size(); ++i)
            sum += volume(i);
        return sum;
    }
    [[nodiscard]] double largest_radius() const {
        double largest = 0.0;
        for (const double r : radius)
            largest = r > largest ? r : largest;
        return largest;
    }
};

} // namespace searle::solvers::particles
