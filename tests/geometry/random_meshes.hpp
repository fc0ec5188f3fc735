#pragma once

#include "geometry/mesh_build.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace searle::geometry::testing {

/// Draws laboratory-like instruments of all four types, and coarse settings.
class Dice {
public:
    explicit Dice(unsigned seed) : engine_{seed} {}
    double between(double low, double high) {
        return low * std::pow(high / low, std::uniform_real_distribution{0.0, 1.0}(engine_));
    }
    int whole(int low, int high) { return std::uniform_int_distribution{low, high}(engine_); }

    MeshSubject subject() {
        const double radius = between(1e-3, 50e-3);
        switch (whole(0, 3)) {
        case 0:
            return ConcentricCylinders{radius, radius * between(1.005, 3.0),
                                       radius * between(0.1, 10)};
        case 1: {
            const double inside = radius * between(1.005, 1.5);
            const double outside = inside * between(1.005, 1.3);
            return DoubleGap{{radius, inside, outside, outside * between(1.005, 1.5)},
                             radius * between(0.1, 5)};
        }
        case 2: {
            DinBob bob{.bob_radius = radius, .cup_radius = radius * between(1.01, 3.0)};
            bob.cone_angle = between(20, 180) * std::numbers::pi / 180.0;
            bob.bottom_ratio = bob.cone_height() / radius + between(0.05, 2.0);
            bob.length_ratio = between(0.2, 6.0);
            bob.top_ratio = whole(0, 4) == 0 ? 0.0 : between(0.05, 2.0);
            bob.shaft_ratio = between(0.05, 0.95);
            return bob;
        }
        default:
            return Box{between(1e-5, 1e-2), between(1e-3, 1e-1), between(1e-3, 1e-1)};
        }
    }
    MeshSettings settings() {
        MeshSettings settings;
        settings.cells_across_gap = whole(1, 6);
        settings.extent = static_cast<MeshExtent>(whole(0, 3));
        settings.order = whole(1, 2);
        if (settings.extent == MeshExtent::wedge)
            settings.wedge_angle = between(0.5, 10) * std::numbers::pi / 180.0;
        if (settings.extent == MeshExtent::sector)
            settings.wedge_angle = between(20, 350) * std::numbers::pi / 180.0;
        if (settings.extent == MeshExtent::sector || settings.extent == MeshExtent::full)
            settings.angular_cells = whole(4, 12);
        return settings;
    }

private:
    std::mt19937 engine_;
};

/// A way to spoil a request, and a word of the message that names the cause.
struct Spoiled {
    std::function<void(MeshSubject&, MeshSettings&, Dice&)> how;
    const char* word;
};

/// Requests that no mesh answers.
inline std::vector<Spoiled> ways_to_spoil() {
    const DinBob iso{.bob_radius = 14e-3, .cup_radius = 15.2e-3};
    return {
        {[](MeshSubject&, MeshSettings& s, Dice& d) {
             s.wedge_angle = -d.between(1e-3, 1.0);
             s.extent.reset();
         },
         "wedge_angle"},
        {[](MeshSubject&, MeshSettings& s, Dice& d) {
             s.wedge_angle = d.between(6.5, 60);
             s.extent.reset();
         },
         "wedge_angle"},
        {[](MeshSubject&, MeshSettings& s, Dice& d) { s = {.cell_size = d.between(0.2, 1.0)}; },
         "cell_size"},
        {[](MeshSubject&, MeshSettings& s, Dice& d) { s = {.first_cell = d.between(0.2, 1.0)}; },
         "first_cell"},
        {[](MeshSubject&, MeshSettings& s, Dice&) {
             s = {.cells_across_gap = 100000, .axial_cells = 1000000};
         },
         "most_cells"},
        {[](MeshSubject&, MeshSettings& s, Dice& d) { s = {.slice_height = d.between(2, 10)}; },
         "slice_height"},
        {[iso](MeshSubject& m, MeshSettings&, Dice& d) {
             DinBob b = iso;
             b.shaft_ratio = d.between(1.0, 3.0);
             m = b;
         },
         "shaft"},
        {[iso](MeshSubject& m, MeshSettings&, Dice& d) {
             DinBob b = iso;
             b.bottom_ratio = d.between(0.1, 0.5);
             m = b;
         },
         "cup_floor"},
        {[](MeshSubject& m, MeshSettings&, Dice& d) {
             m = ConcentricCylinders{0.02, 0.02 / d.between(1.01, 2), 0.1};
         },
         "clockwise"},
        {[](MeshSubject& m, MeshSettings&, Dice& d) {
             const double z = d.between(0.1, 1);
             m = Profile{{{0, -z}, {1, 0}, {1, 2}}, {{0, -0.5 * z}, {2, -2 * z}, {2, 2}}};
         },
         "edge 1 of the"}};
}

} // namespace searle::geometry::testing
