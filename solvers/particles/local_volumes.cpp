#include "solvers/particles/local_volumes.hpp"

#include "geometry/power_cells.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace searle::solvers::particles {
namespace {

/// Depth of the images around the box to begin with, in mean distances of particles.
constexpr double first_depth = 2.3;
constexpr double depth_growth = 1.05; ///< beyond what was found to be needed, or twice if unknown

using geometry::Sphere;

std::vector<Sphere> inside_the_box(const ParticleStore& particles, const ShearBox& box) {
    std::vector<Sphere> spheres;
    spheres.reserve(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) {
        Sphere it{particles.x[i], particles.y[i], particles.z[i], particles.radius[i]};
        if (!box.walls) {
            const double turns = std::floor(it.y / box.length_y);
            it.y -= turns * box.length_y;
            it.x -= turns * box.image_offset;
        }
        it.x -= box.length_x * std::floor(it.x / box.length_x);
        it.z -= box.length_z * std::floor(it.z / box.length_z);
        spheres.push_back(it);
    }
    return spheres;
}

/// Appends the images of the first `count` spheres that lie at most `depth` outside of the box.
void add_images(std::vector<Sphere>& spheres, std::size_t count, const ShearBox& box,
                double depth) {
    const auto layers = [depth](double length) { return static_cast<int>(depth / length) + 1; };
    const auto is_near = [depth](double at, double length) {
        return at >= -depth && at <= length + depth;
    };
    const int above = layers(box.length_y);
    const int beside = layers(box.length_z);
    for (std::size_t i = 0; i < count; ++i) {
        const Sphere own = spheres[i];
        for (int j = -above; j <= above; ++j) {
            Sphere row = own;
            row.y =
                box.walls && j % 2 != 0 ? (j + 1) * box.length_y - own.y : own.y + j * box.length_y;
            if (!is_near(row.y, box.length_y))
                continue;
            const double shift = box.walls ? 0.0 : j * box.image_offset;
            const double behind = std::ceil((-depth - own.x - shift) / box.length_x);
            for (row.x = own.x + shift + behind * box.length_x; row.x <= box.length_x + depth;
                 row.x += box.length_x)
                for (int k = -beside; k <= beside; ++k) {
                    row.z = own.z + k * box.length_z;
                    const bool is_own =
                        j == 0 && k == 0 && std::abs(row.x - own.x) < 0.5 * box.length_x;
                    if (!is_own && is_near(row.z, box.length_z))
                        spheres.push_back(row);
                }
        }
    }
}

} // namespace

std::vector<double> local_volumes(const ParticleStore& particles, const ShearBox& box) {
    const std::size_t count = particles.size();
    std::vector<Sphere> spheres = inside_the_box(particles, box);
    double depth = first_depth * std::cbrt(box.volume() / static_cast<double>(count));
    for (;;) {
        add_images(spheres, count, box, depth);
        geometry::PowerCells cells = geometry::power_cells(spheres, count);
        if (cells.reach <= depth)
            return std::move(cells.volume);
        depth = std::isfinite(cells.reach) ? depth_growth * cells.reach : 2.0 * depth;
        spheres.resize(count);
    }
}

} // namespace searle::solvers::particles
