#include "solvers/meridional/element_jacobian.hpp"

#include <numbers>

namespace searle::solvers::meridional {
namespace {

using std::numbers::sqrt2;

enum : std::size_t { radial, axial, rotation };
enum : std::size_t { along_r, along_z, value };

/// rate x d(rate) per change of one component through one slot.
std::array<std::array<Eigen::ArrayXd, 3>, 3> rate_slopes(const PointFlow& flow) {
    const Eigen::ArrayXd& r = flow.radius;
    const Eigen::ArrayXd shear = flow.u_z + flow.w_r;
    return {{{2.0 * flow.u_r, shear, 2.0 * flow.u / r.square()},
             {shear, 2.0 * flow.w_z, {}},
             {r.square() * flow.spin_r, r.square() * flow.spin_z, {}}}};
}

} // namespace

ElementJacobian::ElementJacobian(Eigen::Index points, Eigen::Index locals)
    : points_(points), locals_(locals), weighted_(3 * points, 3 * locals),
      matrix_(3 * locals, 3 * locals) {}

ElementJacobian::Coefficients ElementJacobian::coefficients(std::size_t test, std::size_t trial,
                                                            const PointFlow& flow, double reynolds,
                                                            double mass_rate) const {
    Coefficients c;
    const Eigen::ArrayXd& r = flow.radius;
    const Eigen::ArrayXd& eta = flow.viscosity;
    const Eigen::ArrayXd mass = Eigen::ArrayXd::Constant(points_, reynolds);
    const Eigen::ArrayXd added = Eigen::ArrayXd::Constant(points_, reynolds * mass_rate);
    if (test == radial && trial == radial) {
        c[along_r][along_r] = 2.0 * eta;
        c[along_z][along_z] = eta;
        c[value][value] = 2.0 * eta / r.square() + mass * flow.u_r + added;
        c[value][along_r] = mass * flow.u;
        c[value][along_z] = mass * flow.w;
    } else if (test == radial && trial == axial) {
        c[along_z][along_r] = eta;
        c[value][value] = mass * flow.u_z;
    } else if (test == radial) {
        c[value][value] = -2.0 * mass * r * flow.spin;
    } else if (test == axial && trial == radial) {
        c[along_r][along_z] = eta;
        c[value][value] = mass * flow.w_r;
    } else if (test == axial && trial == axial) {
        c[along_r][along_r] = eta;
        c[along_z][along_z] = 2.0 * eta;
        c[value][along_r] = mass * flow.u;
        c[value][along_z] = mass * flow.w;
        c[value][value] = mass * flow.w_z + added;
    } else if (test == rotation && trial == radial) {
        c[value][value] = mass * r * (r * flow.spin_r + 2.0 * flow.spin);
    } else if (test == rotation && trial == axial) {
        c[value][value] = mass * r.square() * flow.spin_z;
    } else if (test == rotation) {
        c[along_r][along_r] = eta * r.square();
        c[along_z][along_z] = c[along_r][along_r];
        c[value][along_r] = mass * r.square() * flow.u;
        c[value][along_z] = mass * r.square() * flow.w;
        c[value][value] = r * (2.0 * mass * flow.u + r * added);
    }
    return c;
}

const Eigen::MatrixXd& ElementJacobian::of(const Eigen::MatrixXd& stacked,
                                           const Eigen::ArrayXd& weight, const PointFlow& flow,
                                           double reynolds, double mass_rate) {
    const bool stiffens = (flow.stiffening != 0.0).any();
    const auto slopes =
        stiffens ? rate_slopes(flow) : std::array<std::array<Eigen::ArrayXd, 3>, 3>{};
    Eigen::ArrayXd combined(points_);
    for (std::size_t test = 0; test < 3; ++test) {
        for (std::size_t trial = 0; trial < 3; ++trial) {
            Coefficients c = coefficients(test, trial, flow, reynolds, mass_rate);
            for (std::size_t row = 0; row < slots; ++row) {
                auto out =
                    weighted_.block(static_cast<Eigen::Index>(row) * points_,
                                    static_cast<Eigen::Index>(trial) * locals_, points_, locals_);
                bool empty = true;
                for (std::size_t slot = 0; slot < slots; ++slot) {
                    const bool bends =
                        stiffens && slopes[test][row].size() > 0 && slopes[trial][slot].size() > 0;
                    if (c[row][slot].size() == 0 && !bends) {
                        continue;
                    }
                    combined.setZero();
                    if (c[row][slot].size() > 0) {
                        combined = c[row][slot];
                    }
                    if (bends) {
                        combined += flow.stiffening * slopes[test][row] * slopes[trial][slot];
                    }
                    combined *= weight;
                    const auto part =
                        stacked.middleRows(static_cast<Eigen::Index>(slot) * points_, points_);
                    if (empty) {
                        out.noalias() = combined.matrix().asDiagonal() * part;
                        empty = false;
                    } else {
                        out.noalias() += combined.matrix().asDiagonal() * part;
                    }
                }
                if (empty) {
                    out.setZero();
                }
            }
        }
        matrix_.middleRows(static_cast<Eigen::Index>(test) * locals_, locals_).noalias() =
            stacked.transpose() * weighted_;
    }
    return matrix_;
}

} // namespace searle::solvers::meridional
