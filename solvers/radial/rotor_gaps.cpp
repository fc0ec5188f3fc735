#include "solvers/radial/rotor_gaps.hpp"

#include <numbers>

namespace searle::solvers::radial {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;

RotorGap outside_rotor(double rotor, double cup, double height, double density) {
    return {{.planar = false,
             .inner = rotor,
             .outer = cup,
             .outer_wall_moves = false,
             .density = density},
            -full_turn * height};
}

RotorGap inside_rotor(double post, double rotor, double height, double density) {
    return {{.planar = false,
             .inner = post,
             .outer = rotor,
             .outer_wall_moves = true,
             .density = density},
            full_turn * height};
}

struct Gaps {
    double density;

    std::vector<RotorGap> operator()(const geometry::ConcentricCylinders& cylinders) const {
        return {
            outside_rotor(cylinders.bob_radius, cylinders.cup_radius, cylinders.height, density)};
    }
    std::vector<RotorGap> operator()(const geometry::DinBob& bob) const {
        return {outside_rotor(bob.bob_radius, bob.cup_radius, bob.height(), density)};
    }
    std::vector<RotorGap> operator()(const geometry::DoubleGap& gaps) const {
        const auto& radii = gaps.radii;
        return {inside_rotor(radii[0], radii[1], gaps.height, density),
                outside_rotor(radii[2], radii[3], gaps.height, density)};
    }
    std::vector<RotorGap> operator()(const geometry::Box& box) const {
        return {{{.planar = true,
                  .inner = 0.0,
                  .outer = box.gap,
                  .outer_wall_moves = false,
                  .density = density},
                 -box.wall_area()}};
    }
};

} // namespace

std::vector<RotorGap> rotor_gaps(const geometry::Instrument& instrument, double density) {
    return std::visit(Gaps{density}, instrument);
}

} // namespace searle::solvers::radial
