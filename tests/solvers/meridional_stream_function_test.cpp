#include "solvers/meridional/stream_function.hpp"
#include "solvers/meridional/vortex_cell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace searle::solvers::meridional {
namespace {

constexpr double gap = 0.5;
constexpr double height = 0.6;

/// Vanishes on the outline of the cell 1 ... 1 + gap, 0 ... height.
double exact(double r, double z) {
    const double across = (r - 1.0) * (1.0 + gap - r);
    return across * across * std::sin(std::numbers::pi * z / height);
}

double largest_error(int degree) {
    const auto level =
        cell_level({.gap = gap, .height = height}, {.degree = degree, .columns = 2, .rows = 2});
    const FlowSpace& space = level->space();
    FlowState state = rest(space);
    const auto& position = space.swirl_space().position();
    for (int node = 0; node < space.nodes(); ++node) {
        const double r = position(node, 0);
        const double z = position(node, 1);
        const double across = (r - 1.0) * (1.0 + gap - r);
        const double wave = std::numbers::pi / height;
        // u = -psi_z / r, w = psi_r / r by hand.
        state.velocity(node, 0) = -across * across * wave * std::cos(wave * z) / r;
        state.velocity(node, 1) = 2.0 * across * (2.0 + gap - 2.0 * r) * std::sin(wave * z) / r;
    }
    const Eigen::VectorXd found = stream_function(space, state.velocity);
    double largest = 0.0;
    for (int node = 0; node < space.nodes(); ++node) {
        largest =
            std::max(largest, std::abs(found[node] - exact(position(node, 0), position(node, 1))));
    }
    return largest;
}

/// The function is of order 4e-3; spectral convergence with the degree.
TEST(StreamFunction, is_the_one_whose_curl_is_the_velocity) {
    const double coarse = largest_error(4);
    const double middle = largest_error(6);
    const double fine = largest_error(8);
    EXPECT_LT(middle, 0.1 * coarse);
    EXPECT_LT(fine, 0.1 * middle);
    EXPECT_LT(fine, 1e-8);
}

} // namespace
} // namespace searle::solvers::meridional
