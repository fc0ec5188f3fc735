#include "solvers/stability/legendre_basis.hpp"
#include "solvers/stability/taylor_threshold.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

namespace searle::solvers::stability {
namespace {

// Origin: physics notes, section 2 (recomputed there), after Chandrasekhar 1961 and DiPrima &
// Swinney 1981; the printed digits are the tolerance.
TEST(TaylorThreshold, published_values_are_met) {
    EXPECT_NEAR(taylor_threshold(1.0 / 0.5 - 1.0).reynolds, 68.1863, 5e-5);
    EXPECT_NEAR(taylor_threshold(1.0 / 0.5 - 1.0).wave_number, 3.1625, 5e-5);
    EXPECT_NEAR(taylor_threshold(1.0 / 0.875 - 1.0).reynolds, 118.1571, 5e-5);
    EXPECT_NEAR(taylor_threshold(1.0 / 0.95 - 1.0).reynolds, 184.9856, 5e-5);
}

// Origin: an independent program: Chebyshev collocation in r (not ln r) of the pair (u, v) with 30
// digits (mpmath 1.2.1, 20 to 60 points, inverse iteration, parabola through three wave numbers).
TEST(TaylorThreshold, ten_digits_agree_with_collocation_in_thirty_digits) {
    struct Expected {
        double relative_gap;
        double reynolds;
        double wave_number;
    };
    for (const auto& [relative_gap, reynolds, wave_number] :
         std::vector<Expected>{{0.0005, 1841.70303886496, 3.12657},
                               {1.0 / 14.0, 160.50432850405, 3.12786},
                               {1.0, 68.1862683463863, 3.16248},
                               {9.0, 140.492148428144, 3.33934},
                               {19.0, 249.5435927, 3.38972}}) {
        const TaylorThreshold found = taylor_threshold(relative_gap);
        EXPECT_NEAR(found.reynolds / reynolds, 1.0, 3e-10) << relative_gap;
        EXPECT_NEAR(found.wave_number, wave_number, 1e-5) << relative_gap;
    }
}

// Origin: the narrow-gap limit with the outer wall at rest, Chandrasekhar 1961, table XXXII: the
// Taylor number of the mean rotation is 1694.95 at k d = 3.1266.
TEST(TaylorThreshold, narrow_gap_limit_is_reached_without_cancellation) {
    for (const double relative_gap : {1e-5, 1e-8, 1e-12}) {
        const TaylorThreshold found = taylor_threshold(relative_gap);
        EXPECT_NEAR(found.reynolds * found.reynolds * relative_gap, 1694.95, 0.02);
        EXPECT_NEAR(found.wave_number, 3.1266, 1e-4);
    }
}

// The error must fall by the same factor with every mode added: its logarithm falls at least
// linearly in the number of modes until rounding, which shows below 1e-11.
TEST(TaylorThreshold, error_falls_exponentially_with_the_number_of_modes) {
    for (const double relative_gap : {0.0005, 0.0714, 1.0, 5.0, 19.0}) {
        const double exact = taylor_threshold_with_modes(relative_gap, 64).reynolds;
        const auto error = [&](int modes) {
            return std::abs(taylor_threshold_with_modes(relative_gap, modes).reynolds / exact -
                            1.0);
        };
        const double four = error(4);
        const double eight = error(8);
        const double twelve = error(12);
        const double rounding = 1e-11;
        EXPECT_GT(four, 1e-6) << "the coarse resolution must have an error to lose";
        EXPECT_LT(eight, std::max(rounding, 0.03 * four)) << relative_gap;
        EXPECT_LT(twelve, std::max(rounding, 0.03 * eight)) << relative_gap;
        EXPECT_LT(error(26), 1e-10) << relative_gap;
        EXPECT_LT(error(36), 1e-11) << relative_gap;
    }
}

TEST(TaylorThreshold, resolution_in_use_gives_eight_digits_at_every_ratio) {
    for (double relative_gap = 0.0005; relative_gap < 19.5; relative_gap *= 1.9) {
        const TaylorThreshold found = taylor_threshold(relative_gap);
        const double finer = taylor_threshold_with_modes(relative_gap, 80).reynolds;
        EXPECT_NEAR(found.reynolds / finer, 1.0, 1e-9) << relative_gap;
        EXPECT_LT(found.relative_error, 1e-10) << relative_gap;
    }
}

TEST(TaylorThreshold, same_answer_from_several_threads) {
    std::vector<double> answers(8);
    std::vector<std::thread> threads;
    for (double& answer : answers) {
        threads.emplace_back([&answer] { answer = taylor_threshold(0.123456).reynolds; });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (const double answer : answers) {
        EXPECT_EQ(answer, answers.front());
    }
}

TEST(TaylorThreshold, impossible_gaps_are_refused) {
    EXPECT_THROW((void)taylor_threshold(0.0), std::invalid_argument);
    EXPECT_THROW((void)taylor_threshold(-0.1), std::invalid_argument);
    EXPECT_THROW((void)taylor_threshold(std::numeric_limits<double>::quiet_NaN()),
                 std::invalid_argument);
    EXPECT_THROW((void)taylor_threshold_with_modes(0.1, 2), std::invalid_argument);
}

// With P_l as highest derivative and orthonormal Legendre polynomials, the leading matrices are
// unity.
TEST(LegendreBasis, highest_derivatives_are_orthonormal) {
    const LegendreBasis basis = legendre_basis(20);
    const Eigen::MatrixXd unity = Eigen::MatrixXd::Identity(20, 20);
    const auto gram = [&](const Eigen::MatrixXd& f) -> Eigen::MatrixXd {
        return f.transpose() * basis.weights.asDiagonal() * f;
    };
    EXPECT_LT((gram(basis.pinned_slope) - unity).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_LT((gram(basis.clamped_curvature) - unity).cwiseAbs().maxCoeff(), 1e-13);
}

// integral f'' g = -integral f' g' and so on hold without wall terms only when the walls are right.
TEST(LegendreBasis, integration_by_parts_leaves_no_wall_terms) {
    const LegendreBasis basis = legendre_basis(12);
    const auto product = [&](const Eigen::MatrixXd& f,
                             const Eigen::MatrixXd& g) -> Eigen::MatrixXd {
        return f.transpose() * basis.weights.asDiagonal() * g;
    };
    // Any polynomial of degree 1 has no overlap with a clamped function's second derivative.
    const Eigen::VectorXd line = 3.0 * basis.nodes.array() - 0.7;
    EXPECT_LT(product(basis.clamped_curvature, line).cwiseAbs().maxCoeff(), 1e-13);
    // A constant has none with a pinned function's slope.
    const Eigen::VectorXd constant = Eigen::VectorXd::Ones(basis.nodes.size());
    EXPECT_LT(product(basis.pinned_slope, constant).cwiseAbs().maxCoeff(), 1e-13);
    // integral f'' xi^2 = 2 integral f for clamped f; integral f' xi = -integral f for pinned f.
    const Eigen::VectorXd square = basis.nodes.array().square();
    EXPECT_LT((product(basis.clamped_curvature, square) - 2.0 * product(basis.clamped, constant))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-13);
    EXPECT_LT((product(basis.pinned_slope, basis.nodes) + product(basis.pinned, constant))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-13);
}

} // namespace
} // namespace searle::solvers::stability
