#include "solvers/axisymmetric/creeping_swirl.hpp"
#include "solvers/axisymmetric/end_factor_curve.hpp"
#include "solvers/axisymmetric/energy_minimiser.hpp"
#include "solvers/axisymmetric/swirl_law.hpp"
#include "solvers/axisymmetric/swirl_response.hpp"
#include "solvers/radial/annular_gap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace searle::solvers::axisymmetric {
namespace {

namespace flow = laws::flow;

/// ISO 3219 proportions; lengths in bob radii, so that K = 1 and omega = 1 give tau0 / (K omega^n).
const geometry::DinBob iso_bob{.bob_radius = 1.0, .cup_radius = 1.0847};

/// Expected c_L of the standard bob: physics.md, section 3 (independent finite elements), to the
/// digits given there; bench/independent_end_factors.py computes them in yet another way.
TEST(CreepingSwirl, newtonian_end_factor_of_the_iso_bob) {
    const CreepingTorque found =
        creeping_torque(iso_bob, flow::Newtonian{1.0}, 1.0, {.accuracy = 1e-5});
    EXPECT_TRUE(found.reached);
    EXPECT_NEAR(found.end_factor, 1.08868, 5e-6);
    EXPECT_LT((found.upper - found.lower) / found.torque, 1e-5);
}

TEST(CreepingSwirl, power_law_end_factor_of_the_iso_bob) {
    const CreepingTorque found =
        creeping_torque(iso_bob, flow::PowerLaw{1.0, 0.5}, 1.0, {.accuracy = 1e-5});
    EXPECT_TRUE(found.reached);
    EXPECT_NEAR(found.end_factor, 1.1579, 5e-5);
    EXPECT_LT((found.upper - found.lower) / found.torque, 1e-5);
}

TEST(CreepingSwirl, herschel_bulkley_end_factor_lies_in_a_bracket_of_a_thousandth) {
    const CreepingTorque found = creeping_torque(iso_bob, flow::HerschelBulkley{10.0, 1.0, 0.5},
                                                 1.0, {.accuracy = 1e-3, .certified = true});
    EXPECT_TRUE(found.reached);
    EXPECT_NEAR(found.end_factor, 1.255, 5e-4);
    EXPECT_LE((found.upper - found.lower) / found.torque, 1e-3);
    EXPECT_LT(found.lower, found.torque);
    EXPECT_GT(found.upper, found.torque);
    EXPECT_LT(found.quadrature_error, 1e-4);
}

/// TRIOS' bob (14/15.2/42 mm) has 1.0893 (physics.md, section 3); near the plastic limit the shear
/// sits on the bob's walls, whose tau0 r^2 area gives c_L = (3 + cone 1/(3 sin 60 deg) + top (1 -
/// 0.3^3)/3 + shaft 0.3^2)/3.
TEST(CreepingSwirl, other_bobs_and_the_plastic_limit) {
    const CreepingTorque trios = creeping_torque(geometry::DinBob{0.014, 0.0152},
                                                 flow::Newtonian{1e-3}, 2.0, {.accuracy = 1e-5});
    EXPECT_NEAR(trios.end_factor, 1.0893, 5e-5);
    const double plastic =
        (3.0 + 1.0 / (3.0 * std::sin(std::numbers::pi / 3.0)) + (1.0 - 0.027) / 3.0 + 0.09) / 3.0;
    const CreepingTorque stiff =
        creeping_torque(iso_bob, flow::HerschelBulkley{1e4, 1.0, 1.8}, 1.0, {.accuracy = 2e-3});
    EXPECT_TRUE(stiff.reached);
    EXPECT_NEAR(stiff.end_factor, plastic, 6e-3);
    EXPECT_LT(stiff.end_factor, plastic);
}

/// The error that is claimed must hold the finest result, and the bounds must be nested.
TEST(CreepingSwirl, bounds_close_in_on_the_result_and_errors_hold) {
    for (const flow::AnyFlowLaw& law :
         {flow::AnyFlowLaw{flow::PowerLaw{1.0, 0.3}}, flow::AnyFlowLaw{flow::PowerLaw{1.0, 1.8}},
          flow::AnyFlowLaw{flow::CarreauYasuda{1.0, 0.0, 0.5, 0.4, 2.0}},
          flow::AnyFlowLaw{flow::Casson{10.0, 1.0}}, flow::AnyFlowLaw{flow::Bingham{10.0, 1.0}}}) {
        const CreepingTorque fine = creeping_torque(iso_bob, law, 1.0, {.accuracy = 1e-5});
        for (const double accuracy : {1e-2, 1e-3}) {
            const CreepingTorque coarse =
                creeping_torque(iso_bob, law, 1.0, {.accuracy = accuracy});
            EXPECT_TRUE(coarse.reached) << flow::name_of(law) << accuracy;
            EXPECT_LE(std::abs(coarse.torque - fine.torque), coarse.error + fine.error)
                << flow::name_of(law) << accuracy;
            EXPECT_LT(coarse.lower, fine.torque) << flow::name_of(law);
            EXPECT_GT(coarse.upper, fine.torque) << flow::name_of(law);
        }
    }
}

TEST(CreepingSwirl, herschel_bulkley_without_yield_stress_is_a_power_law) {
    const auto with = creeping_torque(iso_bob, flow::HerschelBulkley{0.0, 2.0, 0.5}, 3.0, {});
    const auto power = creeping_torque(iso_bob, flow::PowerLaw{2.0, 0.5}, 3.0, {});
    EXPECT_NEAR(with.torque / power.torque, 1.0, 1e-3);
}

/// Fenchel: Phi(rate) + Phi*(stress) >= rate stress, equal where the stress is the law's.
TEST(SwirlLaw, conjugate_matches_potential) {
    for (const flow::AnyFlowLaw& law :
         {flow::AnyFlowLaw{flow::Newtonian{2.0}},
          flow::AnyFlowLaw{flow::HerschelBulkley{5, 2, 0.4}},
          flow::AnyFlowLaw{flow::Casson{3.0, 0.7}},
          flow::AnyFlowLaw{flow::CarreauYasuda{3.0, 0.1, 0.2, 0.4, 1.5}},
          flow::AnyFlowLaw{flow::Cross{3.0, 0.1, 0.2, 0.4}}}) {
        const SwirlLaw scaled(law, 2.5, 12.0);
        Eigen::ArrayXXd rate(5, 1);
        rate << 1e-3, 0.1, 1.0, 12.0, 500.0;
        const Eigen::ArrayXXd stress = scaled.stress(rate);
        const Eigen::ArrayXXd both = scaled.potential(rate) + scaled.conjugate(stress);
        for (Eigen::Index k = 0; k < rate.rows(); ++k) {
            EXPECT_NEAR(both(k, 0) / (rate(k, 0) * stress(k, 0)), 1.0, 1e-8)
                << flow::name_of(law) << ' ' << rate(k, 0);
        }
        EXPECT_TRUE(
            (scaled.potential(rate) + scaled.conjugate(1.1 * stress) >= 1.1 * rate * stress - 1e-12)
                .all());
    }
}

/// Manufactured: w = cos(r) sin(z) + r^2 z with any walls' values, the load being the weak form of
/// the exact field. The energy norm of the error falls with the degree of the elements.
class ManufacturedSwirl : public testing::TestWithParam<int> {};

TEST_P(ManufacturedSwirl, error_falls_with_the_degree_as_order) {
    const int degree = GetParam();
    const SwirlLaw law(flow::PowerLaw{1.0, 0.7}, 1.0, 1.0);
    SectionLines lines{{{0.0, 0.5, 1.0},
                        {1.0, 1.5, 2.0},
                        {0.3, 0.6, 1.0},
                        {0.0, 0.5, 1.0},
                        {0.0, 1.0, 2.0, 3.0},
                        {3.0, 3.5, 4.0}}};
    geometry::DinBob bob{.bob_radius = 1.0, .cup_radius = 2.0};
    std::vector<double> errors;
    for (int cut = 0; cut < 3; ++cut) {
        const SectionMesh mesh = section_of(bob, lines);
        SectionSpace space(mesh, Field::rotation, degree, degree + 3);
        const auto exact = [](double r, double z) {
            return std::cos(r) * std::sin(z) + 3.0 * z + r * r * z;
        };
        Eigen::VectorXd values(space.nodes());
        for (Eigen::Index k = 0; k < values.size(); ++k) {
            values[k] = exact(space.position()(k, 0), space.position()(k, 1));
        }
        space.prescribe(values);
        const SwirlLaw::RoundedPotential density(law, 1e-3);
        Eigen::VectorXd load = Eigen::VectorXd::Zero(space.nodes());
        const auto slopes_at = [](double r, double z) {
            return std::array{r * (-std::sin(r) * std::sin(z) + 2.0 * r * z),
                              r * (std::cos(r) * std::cos(z) + 3.0 + r * r)};
        };
        Eigen::ArrayXd secant;
        Eigen::ArrayXd tangent;
        for (const auto& element : space.elements()) {
            const Eigen::Index points = element.weight.size();
            secant.resize(points);
            tangent.resize(points);
            Eigen::ArrayXd size(points);
            Eigen::VectorXd force(2 * points);
            for (Eigen::Index q = 0; q < points; ++q) {
                const auto g = slopes_at(element.radius[q], element.height[q]);
                size[q] = std::hypot(g[0], g[1]);
                force[q] = g[0];
                force[points + q] = g[1];
            }
            density.slopes(size, secant, tangent);
            force.head(points).array() *= element.weight * secant;
            force.tail(points).array() *= element.weight * secant;
            const Eigen::VectorXd local = element.slope.transpose() * force;
            for (Eigen::Index k = 0; k < local.size(); ++k) {
                load[element.node[static_cast<std::size_t>(k)]] += local[k];
            }
        }
        EnergyMinimiser minimiser(space);
        Eigen::VectorXd found = space.prescribed();
        EXPECT_TRUE(minimiser.minimise(density, load, 1e-22, 40, found).steps > 0);
        double square = 0.0;
        for (const auto& element : space.elements()) {
            const Eigen::Index points = element.weight.size();
            Eigen::VectorXd local(element.slope.cols());
            for (Eigen::Index k = 0; k < local.size(); ++k) {
                local[k] = found[element.node[static_cast<std::size_t>(k)]];
            }
            const Eigen::VectorXd g = element.slope * local;
            for (Eigen::Index q = 0; q < points; ++q) {
                const auto right = slopes_at(element.radius[q], element.height[q]);
                square += element.weight[q] *
                          (std::pow(g[q] - right[0], 2) + std::pow(g[points + q] - right[1], 2));
            }
        }
        errors.push_back(std::sqrt(square));
        LineMarks all;
        for (std::size_t family = 0; family < line_families; ++family) {
            all[family].assign(lines[family].size() - 1, true);
        }
        lines = refined(lines, all, 0.5);
    }
    for (std::size_t k = 1; k < errors.size(); ++k) {
        EXPECT_NEAR(std::log2(errors[k - 1] / errors[k]), degree, 0.25) << degree;
    }
}
INSTANTIATE_TEST_SUITE_P(Degrees, ManufacturedSwirl, testing::Values(2, 3, 4));

/// Ramp of water 0 -> 100 1/s in 35 s in TRIOS' bob, read with its own factors (c_L = 1.10):
/// eta_app / eta of an independent axisymmetric computation (physics.md, section 3), to the digits
/// given.
TEST(TransientSwirl, water_ramp_in_a_din_bob) {
    const double rate_per_speed = 12.187215;
    const double stress_per_torque = 16243.2702;
    rheometry::SpeedHistory history;
    history.pieces = {{0.0, 35.0, 0.0, 100.0 / rate_per_speed}};
    history.row_times = {1.0, 5.0, 35.0};
    const double viscosity = 1.0016e-3;
    const TransientSwirl swirl =
        transient_swirl(geometry::DinBob{0.014, 0.0152}, viscosity, 998.2, history, 1e-3);
    EXPECT_TRUE(swirl.reached);
    const double expected[] = {1.53, 1.117, 1.010};
    const double digits[] = {5e-3, 5e-4, 5e-4};
    for (std::size_t k = 0; k < 3; ++k) {
        const double rate = rate_per_speed * history.speed_at(history.row_times[k]);
        EXPECT_NEAR(swirl.torque[k] * stress_per_torque / (rate * viscosity), expected[k],
                    digits[k]);
    }
}

TEST(TransientSwirl, errors_hold_and_a_hold_ends_in_the_steady_torque) {
    const geometry::DinBob bob{0.014, 0.0152};
    rheometry::SpeedHistory history;
    history.pieces = {{0.0, 1.0, 5.0, 5.0}, {1.0, 2.0, 5.0, 0.0}, {2.0, 400.0, 1.0, 1.0}};
    history.row_times = {0.5, 1.0, 1.5, 2.0, 3.0, 400.0};
    const TransientSwirl coarse = transient_swirl(bob, 1e-3, 1000.0, history, 1e-2);
    const TransientSwirl fine = transient_swirl(bob, 1e-3, 1000.0, history, 1e-5);
    for (std::size_t k = 0; k < history.row_times.size(); ++k) {
        EXPECT_LE(std::abs(coarse.torque[k] - fine.torque[k]), coarse.error[k] + fine.error[k]);
    }
    const CreepingTorque steady =
        creeping_torque(bob, flow::Newtonian{1e-3}, 1.0, {.accuracy = 1e-6});
    EXPECT_NEAR(fine.torque.back() / steady.torque, 1.0, 2e-5);
}

TEST(EndFactorCurve, interpolated_values_hold_their_error) {
    const flow::AnyFlowLaw law = flow::HerschelBulkley{5.0, 0.5, 0.5};
    std::vector<double> speeds;
    for (int k = 1; k <= 30; ++k) {
        speeds.push_back(0.1 * k * k);
    }
    const geometry::DinBob bob{0.014, 0.0152};
    const ProgressSink silent;
    const EndFactorCurve curve(bob, law, speeds, 2e-3, silent);
    EXPECT_TRUE(curve.reached());
    EXPECT_LT(curve.solutions(), 30);
    for (const double speed : {0.4, 10.0}) {
        const CreepingTorque own = creeping_torque(bob, law, speed, {.accuracy = 1e-4});
        const auto value = curve.at(speed);
        EXPECT_LE(std::abs(value.end_factor / own.end_factor - 1.0), value.relative_error + 1e-4);
    }
}

TEST(EndFactorCurve, speeds_beyond_the_bound_of_work_are_less_accurate_and_say_so) {
    const flow::AnyFlowLaw law = flow::Bingham{500.0, 1.0};
    const std::vector<double> speeds{0.1, 0.2};
    const geometry::DinBob bob{0.014, 0.0152};
    const ProgressSink silent;
    // Nothing is left for the second speed.
    const EndFactorCurve curve(bob, law, speeds, 1e-6, silent, 1.0);
    EXPECT_FALSE(curve.reached());
    const auto first = curve.at(0.1);
    const auto second = curve.at(0.2);
    EXPECT_GT(second.relative_error, 1e-6);
    EXPECT_GT(second.relative_error, first.relative_error);
    const CreepingTorque own = creeping_torque(bob, law, 0.2, {.accuracy = 1e-5});
    EXPECT_LE(std::abs(second.end_factor / own.end_factor - 1.0),
              second.relative_error + own.error / own.torque);
}

} // namespace
} // namespace searle::solvers::axisymmetric
