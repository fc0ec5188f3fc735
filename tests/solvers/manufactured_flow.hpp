#pragma once

#include "solvers/meridional/flow_system.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

namespace searle::solvers::meridional {

/// viscosity = low + (1 - low) (1 + (rate / knee)^2)^((n - 1)/2): smooth at rest, so that nothing
/// but the elements limits the order of convergence.
class SmoothThinning final : public axisymmetric::EnergyDensity {
public:
    SmoothThinning(double low, double n, double knee = 1.0) : low_(low), n_(n), knee_(knee) {}
    [[nodiscard]] double viscosity(double rate) const {
        return low_ +
               (1.0 - low_) * std::pow(1.0 + rate * rate / (knee_ * knee_), 0.5 * (n_ - 1.0));
    }
    void slopes(const Eigen::ArrayXd& rate, Eigen::ArrayXd& secant,
                Eigen::ArrayXd& tangent) const override {
        for (Eigen::Index k = 0; k < rate.size(); ++k) {
            const double square = rate[k] * rate[k] / (knee_ * knee_);
            secant[k] = viscosity(rate[k]);
            tangent[k] = secant[k] + (1.0 - low_) * (n_ - 1.0) * square *
                                         std::pow(1.0 + square, 0.5 * (n_ - 3.0));
        }
    }

private:
    double low_;
    double n_;
    double knee_;
};

/// An exact flow without divergence, and the body force (per unit volume, over stress scale / bob
/// radius) that drives it. The force is the STRONG form of momentum in cylinder coordinates with
/// v = r Omega, whose stress is differentiated by central differences of eighth order (velocities
/// by complex steps); it shares nothing with the weak form of FlowSystem.
class ManufacturedFlow {
public:
    using Complex = std::complex<double>;
    /// (u_r, u_z, u_theta / r) at (r, z).
    using Velocity = std::function<std::array<Complex, 3>(Complex r, Complex z)>;
    using Pressure = std::function<double(double r, double z)>;

    ManufacturedFlow(Velocity velocity, Pressure pressure, const SmoothThinning& law,
                     double reynolds, double growth)
        : velocity_(std::move(velocity)), pressure_(std::move(pressure)), law_(law),
          reynolds_(reynolds), growth_(growth) {}

    [[nodiscard]] std::array<double, 3> velocity(double r, double z) const {
        const auto at = velocity_(r, z);
        return {at[0].real(), at[1].real(), at[2].real()};
    }
    [[nodiscard]] double pressure(double r, double z) const { return pressure_(r, z); }

    struct Stress {
        double rr, tt, zz, rz, rt, tz; ///< t: theta
    };
    /// Viscous stress 2 eta D.
    [[nodiscard]] Stress stress(double r, double z) const {
        const Slopes s = slopes(r, z);
        const double hoop = s.value[0] / r;
        const double spin_r = s.along_r[2] * r; // r d(v/r)/dr
        const double spin_z = s.along_z[2] * r; // dv/dz
        const double shear = s.along_z[0] + s.along_r[1];
        const double rate = std::sqrt(
            2.0 * (s.along_r[0] * s.along_r[0] + hoop * hoop + s.along_z[1] * s.along_z[1]) +
            shear * shear + spin_r * spin_r + spin_z * spin_z);
        const double eta = law_.viscosity(rate);
        return {.rr = 2.0 * eta * s.along_r[0],
                .tt = 2.0 * eta * hoop,
                .zz = 2.0 * eta * s.along_z[1],
                .rz = eta * shear,
                .rt = eta * spin_r,
                .tz = eta * spin_z};
    }
    /// Where every velocity grows as exp(growth t), at t = 0: (f_r, f_z, f_theta).
    [[nodiscard]] std::array<double, 3> force(double r, double z) const {
        const Slopes s = slopes(r, z);
        const double u = s.value[0];
        const double w = s.value[1];
        const double v = r * s.value[2];
        const double v_r = s.value[2] + r * s.along_r[2];
        const double v_z = r * s.along_z[2];
        const auto in_r = [&](auto member) {
            return slope([&](double x) { return stress(r + x, z).*member; });
        };
        const auto in_z = [&](auto member) {
            return slope([&](double x) { return stress(r, z + x).*member; });
        };
        const Stress t = stress(r, z);
        const double p_r = slope([&](double x) { return pressure_(r + x, z); });
        const double p_z = slope([&](double x) { return pressure_(r, z + x); });
        return {reynolds_ * (growth_ * u + u * s.along_r[0] + w * s.along_z[0] - v * v / r) + p_r -
                    (in_r(&Stress::rr) + in_z(&Stress::rz) + (t.rr - t.tt) / r),
                reynolds_ * (growth_ * w + u * s.along_r[1] + w * s.along_z[1]) + p_z -
                    (in_r(&Stress::rz) + in_z(&Stress::zz) + t.rz / r),
                reynolds_ * (growth_ * v + u * v_r + w * v_z + u * v / r) -
                    (in_r(&Stress::rt) + in_z(&Stress::tz) + 2.0 * t.rt / r)};
    }
    /// u_r,r + u_r / r + u_z,z.
    [[nodiscard]] double divergence(double r, double z) const {
        const Slopes s = slopes(r, z);
        return s.along_r[0] + s.value[0] / r + s.along_z[1];
    }

private:
    struct Slopes {
        std::array<double, 3> value, along_r, along_z;
    };
    [[nodiscard]] Slopes slopes(double r, double z) const {
        constexpr double tiny = 1e-30;
        const auto at = velocity_(r, z);
        const auto in_r = velocity_(Complex(r, tiny), z);
        const auto in_z = velocity_(r, Complex(z, tiny));
        Slopes s{};
        for (std::size_t c = 0; c < 3; ++c) {
            s.value[c] = at[c].real();
            s.along_r[c] = in_r[c].imag() / tiny;
            s.along_z[c] = in_z[c].imag() / tiny;
        }
        return s;
    }
    template <class Function>
    [[nodiscard]] static double slope(const Function& f) {
        constexpr double h = 4e-3;
        constexpr std::array<double, 4> weight{4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
        double sum = 0.0;
        for (int k = 1; k <= 4; ++k) {
            sum += weight[static_cast<std::size_t>(k - 1)] * (f(k * h) - f(-k * h));
        }
        return sum / h;
    }

    Velocity velocity_;
    Pressure pressure_;
    const SmoothThinning& law_;
    double reynolds_;
    double growth_;
};

/// Boundary bits of the four sides of a rectangle in (r, share of the height).
struct SidesOfPatch {
    unsigned bottom, top, left, right;
};

/// cells x cells elements between r = left ... right, with the height z_at(r, share), 0 <= share <=
/// 1.
inline axisymmetric::SectionMesh patch(double left, double right, int cells,
                                       const std::function<double(double, double)>& z_at,
                                       const SidesOfPatch& sides) {
    using axisymmetric::interior_side;
    axisymmetric::SectionMesh mesh;
    const int lines = cells + 1;
    const auto vertex = [&](int i, int j) { return j * lines + i; };
    const auto flat = [&](int i, int j) { return j * cells + i; };
    const auto upright = [&](int i, int j) { return cells * lines + i * cells + j; };
    mesh.vertex_boundary.assign(static_cast<std::size_t>(lines * lines), interior_side);
    mesh.edge_boundary.assign(static_cast<std::size_t>(2 * cells * lines), interior_side);
    const auto mark = [&](int i, int j, int edge, unsigned side) {
        mesh.vertex_boundary[static_cast<std::size_t>(vertex(i, j))] |= side;
        if (edge >= 0) {
            mesh.edge_boundary[static_cast<std::size_t>(edge)] |= side;
        }
    };
    for (int k = 0; k <= cells; ++k) {
        const bool inside = k < cells;
        mark(k, 0, inside ? flat(k, 0) : -1, sides.bottom);
        mark(k, cells, inside ? flat(k, cells) : -1, sides.top);
        mark(0, k, inside ? upright(0, k) : -1, sides.left);
        mark(cells, k, inside ? upright(cells, k) : -1, sides.right);
    }
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const double from = left + (right - left) * i / cells;
            const double to = left + (right - left) * (i + 1) / cells;
            const double low = static_cast<double>(j) / cells;
            const double high = static_cast<double>(j + 1) / cells;
            mesh.elements.push_back(
                {.left = from,
                 .right = to,
                 .bottom_left = z_at(from, low),
                 .bottom_right = z_at(to, low),
                 .top_left = z_at(from, high),
                 .top_right = z_at(to, high),
                 .vertex = {vertex(i, j), vertex(i + 1, j), vertex(i, j + 1), vertex(i + 1, j + 1)},
                 .edge = {flat(i, j), flat(i, j + 1), upright(i, j), upright(i + 1, j)},
                 .family = {0, 0},
                 .interval = {static_cast<std::size_t>(i), static_cast<std::size_t>(j)}});
        }
    }
    return mesh;
}

} // namespace searle::solvers::meridional
