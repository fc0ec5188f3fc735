#include "solvers/radial/gap_element.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace searle::solvers::radial {
namespace {

constexpr double length = 0.25;

GapElement::Integrals integrals(double index, double first, double last) {
    const laws::flow::PowerLaw law{.consistency = 1.0, .flow_index = index};
    const GapShape plates{.planar = true, .inner = 0.0, .outer = 1.0, .density = 1.0};
    return GapElement(plates, 0.5, 0.5 + length, rate_exponent(law))
        .integrals(law, {first, last, 0.0});
}

/// Of sign(F) |F|^p over the element with (1 - s) and s, F linear in s: closed form.
std::array<double, 2> exact(double index, double first, double last) {
    const double p = 1.0 / index;
    const double slope = last - first;
    const auto even = [&](double flux) { return std::pow(std::abs(flux), p + 1.0) / (p + 1.0); };
    const auto odd = [&](double flux) {
        return std::copysign(std::pow(std::abs(flux), p + 2.0), flux) / (p + 2.0);
    };
    const double whole = (even(last) - even(first)) / slope;
    const double weighted =
        (odd(last) - odd(first) - first * (even(last) - even(first))) / (slope * slope);
    return {length * (whole - weighted), length * weighted};
}

/// Where a flux passes zero inside of the element, at its end, or beyond it.
TEST(GapElement, a_power_of_the_flux_is_integrated_as_in_closed_form) {
    for (const double index : {1.8, 1.5, 1.2, 0.8, 0.6}) {
        for (const double first :
             {-0.7, -0.5, -0.1, -1e-3, -1e-9, 1e-9, 1e-3, 0.1, 0.5, 1.0, 1.9, 2.1, 5.0}) {
            const double last = first + 1.0;
            const auto [left, right] = exact(index, first, last);
            const auto found = integrals(index, first, last).residual;
            const double scale = length * std::pow(std::max(std::abs(first), last), 1.0 / index);
            EXPECT_NEAR(found[0], left, 1e-7 * scale) << index << ' ' << first;
            EXPECT_NEAR(found[1], right, 1e-7 * scale) << index << ' ' << first;
        }
    }
}

/// Newton's method meets no jump when a zero of the flux moves from one element into the next.
TEST(GapElement, integrals_are_continuous_where_the_flux_at_a_node_changes_its_sign) {
    for (const double index : {1.8, 1.5, 1.2, 0.8, 0.6}) {
        for (const double slope : {1.0, -0.3}) {
            const auto before = integrals(index, -1e-13, slope).residual;
            const auto after = integrals(index, 1e-13, slope).residual;
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_NEAR(before[k], after[k], 1e-11 * length) << index << ' ' << slope;
            }
        }
    }
}

} // namespace
} // namespace searle::solvers::radial
