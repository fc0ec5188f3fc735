#include "tests/solvers/manufactured_flow.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace searle::solvers::meridional {
namespace {

using Complex = ManufacturedFlow::Complex;
constexpr double reynolds = 25.0;
constexpr double growth = 1.7;

/// On the axis; a free surface at z = 0, where u_r, the spin and p are even and u_z is odd.
/// Stream function r^2 a sin z: u_r = -r a cos z, u_z = (2 a + r a') sin z, a = exp(-r^2/2).
std::array<Complex, 3> flow_at_the_axis(Complex r, Complex z) {
    const Complex a = std::exp(-0.5 * r * r);
    return {-r * a * std::cos(z), (2.0 - r * r) * a * std::sin(z),
            (1.0 + 0.8 * r * r) * std::cos(1.3 * z)};
}
double pressure_at_the_axis(double r, double z) { return std::cos(2.0 * z) * (1.0 - 3.0 * r * r); }

/// Between two cylinders, r = 1 and 2, and two planes of symmetry, z = 0 and -1; no flow through
/// the walls. Stream function f(r) sin(pi z), f = (r - 1)^2 (2 - r)^2 r.
std::array<Complex, 3> vortices(Complex r, Complex z) {
    constexpr double pi = std::numbers::pi;
    const Complex g = (r - 1.0) * (2.0 - r);
    const Complex slope = 2.0 * g * (3.0 - 2.0 * r) * r + g * g;
    return {-3.0 * pi * g * g * std::cos(pi * z), 3.0 * slope / r * std::sin(pi * z),
            (2.0 - r) / r + 0.7 * std::sin(2.0 * r) * std::cos(pi * z)};
}
double pressure_of_vortices(double r, double z) {
    return std::sin(2.0 * r) * std::cos(2.0 * std::numbers::pi * z);
}

struct Errors {
    double velocity;
    double pressure;
    double torque;
};

/// Solves for the flow at t = 0, when every velocity grows as exp(growth t), by Newton's method.
Errors solve(const axisymmetric::SectionMesh& mesh, int degree, const ManufacturedFlow& exact,
             const SmoothThinning& law) {
    const FlowSpace space(mesh, degree, degree + 3);
    FlowSystem system(space);
    const FlowMaterial material{.law = law, .reynolds = reynolds};
    FlowState state = rest(space);
    const auto& position = space.swirl_space().position();
    for (int node = 0; node < space.nodes(); ++node) {
        const auto at = exact.velocity(position(node, 0), position(node, 1));
        for (std::size_t c = 0; c < components; ++c) {
            if (space.is_prescribed(static_cast<Component>(c), node)) {
                state.velocity(node, static_cast<Eigen::Index>(c)) = at[c];
            }
        }
    }
    Eigen::MatrixX3d load = Eigen::MatrixX3d::Zero(space.nodes(), 3);
    const auto& swirl = space.swirl_space().elements();
    for (std::size_t e = 0; e < swirl.size(); ++e) {
        const auto& element = space.elements()[e];
        Eigen::MatrixX3d force(element.weight.size(), 3);
        for (Eigen::Index q = 0; q < force.rows(); ++q) {
            const auto f = exact.force(element.radius[q], swirl[e].height[q]);
            force(q, 0) = element.weight[q] * f[0];
            force(q, 1) = element.weight[q] * f[1];
            force(q, 2) = element.weight[q] * element.radius[q] * f[2];
        }
        const Eigen::MatrixX3d local = space.values().transpose() * force;
        for (std::size_t k = 0; k < element.node.size(); ++k) {
            load.row(element.node[k]) += local.row(static_cast<Eigen::Index>(k));
        }
    }
    const auto left_over = [&] {
        FlowResidual residual = system.residual(state, material);
        residual.momentum += system.inertia(growth * state.velocity, reynolds) - load;
        return residual;
    };
    double last = 1.0;
    for (int step = 0; step < 25 && last > 1e-12; ++step) {
        EXPECT_TRUE(system.factorise(state, material, growth));
        const FlowState change = system.newton_change(left_over());
        last = change.velocity.cwiseAbs().maxCoeff();
        add(state, change, 1.0);
    }
    EXPECT_LE(last, 1e-12) << degree;

    double velocity = 0.0;
    double volume = 0.0;
    double pressure_mean = 0.0;
    std::vector<double> pressure_off;
    std::vector<double> pressure_weight;
    for (std::size_t e = 0; e < swirl.size(); ++e) {
        const auto& element = space.elements()[e];
        Eigen::MatrixX3d local(space.values().cols(), 3);
        for (Eigen::Index k = 0; k < local.rows(); ++k) {
            local.row(k) = state.velocity.row(element.node[static_cast<std::size_t>(k)]);
        }
        const Eigen::MatrixX3d at_points = space.values() * local;
        const Eigen::VectorXd pressure =
            space.pressure_values() * state.pressure.col(static_cast<Eigen::Index>(e));
        for (Eigen::Index q = 0; q < at_points.rows(); ++q) {
            const double r = element.radius[q];
            const double z = swirl[e].height[q];
            const auto right = exact.velocity(r, z);
            velocity += element.weight[q] * (std::pow(at_points(q, 0) - right[0], 2) +
                                             std::pow(at_points(q, 1) - right[1], 2) +
                                             std::pow(r * (at_points(q, 2) - right[2]), 2));
            pressure_off.push_back(pressure[q] - exact.pressure(r, z));
            pressure_weight.push_back(element.weight[q]);
            pressure_mean += element.weight[q] * pressure_off.back();
            volume += element.weight[q];
        }
    }
    pressure_mean /= volume; // the pressure is known up to a constant
    double pressure = 0.0;
    for (std::size_t k = 0; k < pressure_off.size(); ++k) {
        pressure += pressure_weight[k] * std::pow(pressure_off[k] - pressure_mean, 2);
    }
    return {std::sqrt(velocity), std::sqrt(pressure), rotor_torque(space, left_over())};
}

using enum axisymmetric::Boundary;
constexpr std::array<int, 3> cells{3, 6, 12};

double order(const std::vector<Errors>& errors, std::size_t k, double Errors::*of) {
    return std::log2(std::abs(errors[k - 1].*of / (errors[k].*of)));
}

class ManufacturedSecondaryFlow : public testing::TestWithParam<int> {};

TEST_P(ManufacturedSecondaryFlow, errors_fall_with_the_orders_of_the_elements_up_to_the_axis) {
    const int degree = GetParam();
    const SmoothThinning law(0.2, 0.4);
    const ManufacturedFlow exact(flow_at_the_axis, pressure_at_the_axis, law, reynolds, growth);
    ASSERT_NEAR(exact.divergence(0.3, -0.4), 0.0, 1e-14);
    std::vector<Errors> errors;
    for (const int each : cells) {
        // A sloping floor, as under a cone.
        const auto height = [](double r, double share) { return (1.0 - share) * (-1.0 + 0.3 * r); };
        errors.push_back(solve(patch(0.0, 1.0, each, height,
                                     {.bottom = cup_wall,
                                      .top = free_surface,
                                      .left = symmetry_axis,
                                      .right = cup_wall}),
                               degree, exact, law));
    }
    EXPECT_NEAR(order(errors, 2, &Errors::velocity), degree + 1, 0.35);
    EXPECT_NEAR(order(errors, 2, &Errors::pressure), degree, 0.35);
}

TEST_P(ManufacturedSecondaryFlow, torque_is_twice_as_accurate_as_the_slope_at_the_wall) {
    const int degree = GetParam();
    const SmoothThinning law(0.2, 0.4, 4.0);
    const ManufacturedFlow exact(vortices, pressure_of_vortices, law, reynolds, growth);
    ASSERT_NEAR(exact.divergence(1.3, -0.4), 0.0, 1e-13);
    // By the rotor on the fluid, whose outer normal there is -r: - int r^2 tau_r_theta dz.
    const axisymmetric::LineRule rule = axisymmetric::gauss_legendre(60);
    double torque = 0.0;
    for (Eigen::Index q = 0; q < rule.node.size(); ++q) {
        torque -= 0.5 * rule.weight[q] * exact.stress(1.0, 0.5 * (rule.node[q] - 1.0)).rt;
    }
    std::vector<Errors> errors;
    for (const int each : cells) {
        const auto height = [](double r, double share) {
            return share - 1.0 + 0.4 * (r - 1.5) * share * (1.0 - share);
        };
        errors.push_back(solve(patch(1.0, 2.0, each, height,
                                     {.bottom = free_surface,
                                      .top = free_surface,
                                      .left = rotor_wall,
                                      .right = cup_wall}),
                               degree, exact, law));
        errors.back().torque -= torque;
    }
    EXPECT_NEAR(order(errors, 2, &Errors::velocity), degree + 1, 0.35);
    EXPECT_NEAR(order(errors, 2, &Errors::pressure), degree, 0.35);
    EXPECT_GT(order(errors, 2, &Errors::torque), 2 * degree - 0.5);
}

INSTANTIATE_TEST_SUITE_P(Degrees, ManufacturedSecondaryFlow, testing::Values(2, 3, 4));

} // namespace
} // namespace searle::solvers::meridional
