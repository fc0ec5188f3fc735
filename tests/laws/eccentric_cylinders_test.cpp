#include "laws/gap/eccentric_cylinders.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>

#include <array>
#include <complex>
#include <vector>

namespace searle::laws::gap {
namespace {

constexpr double pi = std::numbers::pi;

/// Torque and force over eta omega by another way than bipolar coordinates: the stream function as
/// a sum of biharmonic functions, those that decay about the bob's axis (rotlet ln r, Stokeslet r
/// ln r cos, and r^-n, r^(2-n) times cos n theta) and those that are regular about the cup's (R^n,
/// R^(n+2) times cos n Theta), fitted to the velocities on both circles by least squares.
/// Convergence is geometric in `terms`. The bob's torque about its own axis is that of the rotlet
/// alone, its force that of the Stokeslet alone.
class Multipoles {
public:
    Multipoles(const EccentricCylinders& it, int terms) : it_(it), terms_(terms) {
        const int points = 6 * terms;
        const auto columns = static_cast<Eigen::Index>(unknowns());
        Eigen::MatrixXd rows(4 * points, columns);
        Eigen::VectorXd wanted = Eigen::VectorXd::Zero(4 * points);
        for (int at = 0; at < points; ++at) {
            const double angle = 2.0 * pi * (at + 0.5) / points;
            const std::complex<double> turn = std::polar(1.0, angle);
            place(rows, 2 * at, it.inner_radius * turn);
            wanted[2 * at] = -it.inner_radius * turn.imag();
            wanted[2 * at + 1] = it.inner_radius * turn.real();
            place(rows, 2 * (points + at), it.outer_radius * turn - it.offset);
        }
        solution_ = rows.colPivHouseholderQr().solve(wanted);
        residual_ = (rows * solution_ - wanted).lpNorm<Eigen::Infinity>();
    }

    /// Rotlet -k ln r turns with k / r, which takes 4 pi eta k.
    [[nodiscard]] double torque() const { return 4.0 * pi * solution_[0]; }
    /// Stokeslet -(f / 4 pi eta) x ln r.
    [[nodiscard]] double force() const { return 4.0 * pi * solution_[1] / it_.inner_radius; }
    [[nodiscard]] double residual() const { return residual_ / it_.inner_radius; }

private:
    [[nodiscard]] int unknowns() const { return 2 + (2 * terms_ - 1) + 2 * (terms_ + 1); }

    /// psi = Re[conj(w) f(z) + g(z)], w = z or z - centre: velocity u - i v = i (conj(w) f' + g' +
    /// conj(f)), for u = d psi / dy, v = - d psi / dx.
    void put(Eigen::MatrixXd& rows, int row, int column, std::complex<double> w,
             std::complex<double> f, std::complex<double> slope_f,
             std::complex<double> slope_g) const {
        const std::complex<double> velocity =
            std::complex<double>(0, 1) * (std::conj(w) * slope_f + slope_g + std::conj(f));
        rows(row, column) = velocity.real();
        rows(row + 1, column) = -velocity.imag();
    }

    void place(Eigen::MatrixXd& rows, int row, std::complex<double> z) const {
        const double a = it_.inner_radius;
        const double b = it_.outer_radius;
        const std::complex<double> z2 = z + it_.offset; // from the cup's axis
        put(rows, row, 0, z, 0.0, 0.0, -1.0 / z);       // -ln r
        // -(x / a) ln r = -Re[conj(z) ln z + z ln z] / (2 a)
        put(rows, row, 1, z, -0.5 * std::log(z / a) / a, -0.5 / (z * a),
            -0.5 * (std::log(z / a) + 1.0) / a);
        int column = 2;
        for (int n = 1; n <= terms_; ++n) {
            put(rows, row, column++, z, 0.0, 0.0, -double(n) * std::pow(z / a, -n - 1));
            if (n > 1) // r^(2-n) cos n theta = Re[conj(z) z^(1-n)]
                put(rows, row, column++, z, std::pow(z / a, 1 - n),
                    double(1 - n) * std::pow(z / a, -n) / a, 0.0);
        }
        for (int n = 0; n <= terms_; ++n) {
            put(rows, row, column++, z2, 0.0, 0.0,
                n == 0 ? 0.0 : double(n) * std::pow(z2 / b, n - 1));
            put(rows, row, column++, z2, std::pow(z2 / b, n + 1),
                double(n + 1) * std::pow(z2 / b, n) / b, 0.0);
        }
    }

    const EccentricCylinders& it_;
    int terms_;
    Eigen::VectorXd solution_;
    double residual_{};
};

TEST(EccentricCylinders, one_axis_gives_the_torque_of_an_annulus_and_no_force) {
    for (const double outer : {1.001, 1.0714, 2.0, 10.0}) {
        const EccentricCylinders it{1.0, outer, 0.0};
        EXPECT_NEAR(it.torque_factor() * (1.0 - 1.0 / (outer * outer)) / (4.0 * pi), 1.0, 1e-12);
        EXPECT_EQ(it.force_factor(), 0.0);
        EXPECT_NEAR(it.distance(), std::log(outer), 1e-13);
    }
}

TEST(EccentricCylinders, agrees_with_multipoles_about_both_axes) {
    struct Scene {
        EccentricCylinders it;
        int terms;
    };
    const std::array<Scene, 5> scenes{{{{1.0, 2.0, 0.3}, 30},
                                       {{1.0, 2.0, 0.8}, 60},
                                       {{1.0, 5.0, 3.0}, 60},
                                       {{14.0, 20.0, 2.0}, 40},
                                       {{14.0, 18.0, 2.0}, 60}}};
    for (const auto& [it, terms] : scenes) {
        const Multipoles sum(it, terms);
        ASSERT_LT(sum.residual(), 1e-8) << it.offset;
        EXPECT_NEAR(it.torque_factor() / sum.torque(), 1.0, 1e-7) << it.offset;
        EXPECT_NEAR(it.force_factor() / sum.force(), 1.0, 1e-7) << it.offset;
    }
}

TEST(EccentricCylinders, a_narrow_gap_tends_to_sommerfelds_bearing_in_first_order_of_the_gap) {
    for (const double part : {0.1, 0.5, 0.9}) {
        const double root = std::sqrt(1.0 - part * part);
        const double torque = 4.0 * pi * (1.0 + 2.0 * part * part) / ((2.0 + part * part) * root);
        const double force = 12.0 * pi * part / ((2.0 + part * part) * root);
        std::vector<double> off;
        for (const double gap : {1e-2, 1e-3, 1e-4, 1e-5}) {
            const EccentricCylinders it{1.0, 1.0 + gap, part * gap};
            off.push_back(it.torque_factor() * gap / torque - 1.0);
            EXPECT_NEAR(it.force_factor() * gap * gap / force, 1.0, 3.0 * gap);
        }
        EXPECT_LT(std::abs(off.front()), 0.02);
        for (std::size_t at = 1; at < off.size(); ++at)
            EXPECT_NEAR(off[at - 1] / off[at], 10.0, 0.2) << part;
    }
}

TEST(EccentricCylinders, torque_grows_as_the_square_of_a_small_offset) {
    // Sommerfeld: 1 + 2 eps^2 of the concentric torque to leading order, in a narrow gap.
    const EccentricCylinders ten{14.0, 14.01, 0.001};
    EXPECT_NEAR((ten.torque_ratio() - 1.0) / 0.01, 2.0, 0.02);
    const EccentricCylinders hundred{14.0, 14.01, 0.0001};
    EXPECT_NEAR((ten.torque_ratio() - 1.0) / (hundred.torque_ratio() - 1.0), 100.0, 1.0);
}

} // namespace
} // namespace searle::laws::gap
