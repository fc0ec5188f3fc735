#pragma once

#include <cmath>

namespace searle::solvers::particles {

/// The box that holds the particles: 0 <= x < length_x (flow), 0 <= y <= length_y (gap),
/// 0 <= z < length_z (vorticity). Periodic in x and z. Across the gap either two walls, the one at
/// y = length_y moving in x, or Lees & Edwards 1972 (J. Phys. C 5, 1921): the image above moves
/// with `image_speed` and stands `image_offset` ahead.
struct ShearBox {
    double length_x{};
    double length_y{};
    double length_z{};
    bool walls = true;
    double image_offset{}; ///< m, 0 with walls
    double image_speed{};  ///< m/s, shear rate times length_y; 0 with walls
    /// Shear rate of the mean flow, 1/s: of the wall's speed over the gap, or of Lees-Edwards.
    double shear_rate{};

    [[nodiscard]] double volume() const { return length_x * length_y * length_z; }

    void set_shear_rate(double rate) {
        shear_rate = rate;
        image_speed = walls ? 0.0 : rate * length_y;
    }
    void advance(double step) {
        if (!walls) {
            image_offset += image_speed * step;
            image_offset -= length_x * std::floor(image_offset / length_x);
        }
    }
};

/// Brings the vector from one particle to another to its nearest image. `crossings` is how often it
/// crosses the box's top: the relative velocity then lacks crossings * image_speed in x.
struct NearestImage {
    double length_x, inverse_x;
    double length_y, inverse_y; ///< inverse 0 with walls
    double length_z, inverse_z;
    double offset, speed;

    explicit NearestImage(const ShearBox& box)
        : length_x(box.length_x), inverse_x(1.0 / box.length_x), length_y(box.length_y),
          inverse_y(box.walls ? 0.0 : 1.0 / box.length_y), length_z(box.length_z),
          inverse_z(1.0 / box.length_z), offset(box.image_offset), speed(box.image_speed) {}

    double operator()(double& dx, double& dy, double& dz) const {
        const double crossings = std::nearbyint(dy * inverse_y);
        dy -= crossings * length_y;
        dx -= crossings * offset;
        dx -= length_x * std::nearbyint(dx * inverse_x);
        dz -= length_z * std::nearbyint(dz * inverse_z);
        return crossings;
    }
};

} // namespace searle::solvers::particles
