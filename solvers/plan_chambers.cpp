#include "solvers/plan_chambers.hpp"

#include <cmath>
#include <numbers>

namespace searle::solvers {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double first_zero_of_bessel = 3.8317; // of J_1

/// The fluid below and above a rotor; a height of 0 where there is none.
struct Chambers {
    double rotor_radius{}, cup_radius{}, shaft_radius{};
    double below{}, above{}; ///< heights, m
};

struct ChambersOf {
    Chambers operator()(const geometry::DinBob& bob) const {
        return {.rotor_radius = bob.bob_radius,
                .cup_radius = bob.cup_radius,
                .shaft_radius = bob.shaft_ratio * bob.bob_radius,
                .below = bob.bottom_ratio * bob.bob_radius,
                .above = bob.top_ratio * bob.bob_radius};
    }
    Chambers operator()(const geometry::ConcentricCylinders& cylinders) const {
        if (!cylinders.ends) {
            return {};
        }
        return {.rotor_radius = cylinders.bob_radius,
                .cup_radius = cylinders.cup_radius,
                .shaft_radius = cylinders.shaft_radius,
                .below = cylinders.bottom_gap,
                .above = cylinders.top_gap};
    }
    /// The fluid under a thin rotor's edge is no more than its gaps hold.
    Chambers operator()(const geometry::DoubleGap& /*gaps*/) const { return {}; }
    Chambers operator()(const geometry::Box& /*box*/) const { return {}; }
};

} // namespace

std::array<GapResponse, 2> chamber_responses(const geometry::Instrument& instrument,
                                             const Fluid& fluid, double speed) {
    const Chambers chambers = std::visit(ChambersOf{}, instrument);
    const double radius = chambers.rotor_radius;
    const auto response = [&](double height, double inverse_square) -> GapResponse {
        if (!(height > 0.0)) {
            return {};
        }
        const double slope = std::visit(
            [&](const auto& law) { return double{law.stress_slope(speed * radius / height)}; },
            fluid.law);
        return {.inertia = pi * fluid.density * std::pow(radius, 4) * height / 6.0,
                .decay_time = fluid.density / (slope * inverse_square)};
    };
    const auto square = [](double value) { return value * value; };
    return {
        response(chambers.below,
                 square(pi / chambers.below) + square(first_zero_of_bessel / chambers.cup_radius)),
        response(chambers.above, square(0.5 * pi / chambers.above) +
                                     square(pi / (chambers.cup_radius - chambers.shaft_radius)))};
}

} // namespace searle::solvers
