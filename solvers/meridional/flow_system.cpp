#include "solvers/meridional/flow_system.hpp"

#include "solvers/meridional/element_jacobian.hpp"
#include "solvers/meridional/point_flow.hpp"

#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <Eigen/UmfPackSupport>

#include <algorithm>

namespace searle::solvers::meridional {
namespace {

using Index = Eigen::Index;
using Sparse = Eigen::SparseMatrix<double>;

Eigen::MatrixX3d local_velocity(const FlowSpace::Element& element,
                                const Eigen::MatrixX3d& velocity) {
    Eigen::MatrixX3d local(static_cast<Index>(element.node.size()), 3);
    for (std::size_t k = 0; k < element.node.size(); ++k) {
        local.row(static_cast<Index>(k)) = velocity.row(element.node[k]);
    }
    return local;
}

} // namespace

/// An element's equations: what is inside (velocities, and pressure but for its mean) is eliminated
/// there; the velocities on outlines and one mean pressure an element make the global matrix.
struct FlowSystem::Factors {
    struct Condensed {
        Eigen::PartialPivLU<Eigen::MatrixXd> inside;
        Eigen::MatrixXd to_inside;   ///< inside^-1 (inside, outline)
        Eigen::MatrixXd from_inside; ///< (outline, inside)
    };
    std::vector<Condensed> elements;
    std::vector<std::vector<int>> unknown; ///< of each element's outline, -1 where prescribed
    std::vector<std::vector<int>> place;   ///< of the outline's entries in the matrix, -1 for none
    Sparse matrix;
    Eigen::UmfPackLU<Sparse> global;
    bool analysed{};

    explicit Factors(const FlowSpace& space);
};

FlowSystem::Factors::Factors(const FlowSpace& space) : elements(space.elements().size()) {
    const auto outline = static_cast<std::size_t>(space.outline_nodes());
    // The pressure is known up to a constant: the first element's mean is zero.
    const int size = space.outline_unknowns() + static_cast<int>(elements.size()) - 1;
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        std::vector<int> of_element;
        for (std::size_t c = 0; c < components; ++c) {
            for (std::size_t k = 0; k < outline; ++k) {
                of_element.push_back(
                    space.outline_unknown(static_cast<Component>(c), space.elements()[e].node[k]));
            }
        }
        of_element.push_back(e == 0 ? -1 : space.outline_unknowns() + static_cast<int>(e) - 1);
        for (const int column : of_element) {
            for (const int row : of_element) {
                if (row >= 0 && column >= 0) {
                    entries.emplace_back(row, column, 0.0);
                }
            }
        }
        unknown.push_back(std::move(of_element));
    }
    matrix.resize(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    for (const auto& of_element : unknown) {
        std::vector<int> places;
        for (const int column : of_element) {
            for (const int row : of_element) {
                if (row < 0 || column < 0) {
                    places.push_back(-1);
                    continue;
                }
                const int* first = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column];
                const int* last = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column + 1];
                places.push_back(
                    static_cast<int>(std::lower_bound(first, last, row) - matrix.innerIndexPtr()));
            }
        }
        place.push_back(std::move(places));
    }
}

FlowSystem::FlowSystem(const FlowSpace& space) : space_(space) {
    for (const auto& element : space.elements()) {
        const Index points = element.weight.size();
        const Index locals = element.along_r.cols();
        Eigen::MatrixXd stacked(3 * points, locals);
        stacked << element.along_r, element.along_z, space.values();
        const Eigen::MatrixXd weighted =
            element.weight.matrix().asDiagonal() * space.pressure_values();
        const Eigen::VectorXd inverse = element.radius.inverse().matrix();
        Eigen::MatrixXd divergence(2 * locals, weighted.cols());
        divergence.topRows(locals).noalias() =
            -(element.along_r + inverse.asDiagonal() * space.values()).transpose() * weighted;
        divergence.bottomRows(locals).noalias() = -element.along_z.transpose() * weighted;
        stacked_.push_back(std::move(stacked));
        divergence_.push_back(std::move(divergence));
    }
}

FlowSystem::~FlowSystem() = default;

FlowResidual FlowSystem::residual(const FlowState& state, const FlowMaterial& material) const {
    FlowResidual residual{.momentum = Eigen::MatrixX3d::Zero(space_.nodes(), 3),
                          .continuity =
                              Eigen::MatrixXd(state.pressure.rows(), state.pressure.cols())};
    for (std::size_t e = 0; e < space_.elements().size(); ++e) {
        const FlowSpace::Element& element = space_.elements()[e];
        const Eigen::MatrixX3d velocity = local_velocity(element, state.velocity);
        const Index locals = velocity.rows();
        const Index points = element.weight.size();
        const PointFlow at(stacked_[e], velocity, element.radius, material.law);
        const Eigen::ArrayXd stress = element.weight * at.viscosity;
        const Eigen::ArrayXd mass = element.weight * material.reynolds;
        const Eigen::ArrayXd& r = at.radius;
        Eigen::MatrixX3d force(3 * points, 3);
        const auto part = [&](Index slot, Component component) {
            return force.col(static_cast<Index>(component)).segment(slot * points, points).array();
        };
        part(0, Component::radial) = 2.0 * stress * at.u_r;
        part(1, Component::radial) = stress * (at.u_z + at.w_r);
        part(2, Component::radial) = 2.0 * stress * at.u / r.square() +
                                     mass * (at.u * at.u_r + at.w * at.u_z - r * at.spin.square());
        part(0, Component::axial) = stress * (at.u_z + at.w_r);
        part(1, Component::axial) = 2.0 * stress * at.w_z;
        part(2, Component::axial) = mass * (at.u * at.w_r + at.w * at.w_z);
        part(0, Component::rotation) = stress * r.square() * at.spin_r;
        part(1, Component::rotation) = stress * r.square() * at.spin_z;
        part(2, Component::rotation) =
            mass * r * (r * (at.u * at.spin_r + at.w * at.spin_z) + 2.0 * at.u * at.spin);
        Eigen::MatrixX3d local = stacked_[e].transpose() * force;
        const Eigen::VectorXd push = divergence_[e] * state.pressure.col(static_cast<Index>(e));
        local.col(0) += push.head(locals);
        local.col(1) += push.tail(locals);
        for (std::size_t k = 0; k < element.node.size(); ++k) {
            residual.momentum.row(element.node[k]) += local.row(static_cast<Index>(k));
        }
        residual.continuity.col(static_cast<Index>(e)) =
            divergence_[e].topRows(locals).transpose() * velocity.col(0) +
            divergence_[e].bottomRows(locals).transpose() * velocity.col(1);
    }
    return residual;
}

bool FlowSystem::factorise(const FlowState& at, const FlowMaterial& material, double mass_rate) {
    if (!factors_) {
        factors_ = std::make_unique<Factors>(space_);
    }
    Factors& factors = *factors_;
    const Index outline = space_.outline_nodes();
    const Index locals = stacked_.front().cols();
    const Index inner = locals - outline;
    const Index functions = space_.pressure_values().cols();
    const Index outer_size = 3 * outline + 1;
    const Index inner_size = 3 * inner + functions - 1;
    std::fill_n(factors.matrix.valuePtr(), factors.matrix.nonZeros(), 0.0);
    ElementJacobian jacobian(stacked_.front().rows() / 3, locals);
    Eigen::MatrixXd outside(outer_size, outer_size);
    Eigen::MatrixXd inside(inner_size, inner_size);
    Eigen::MatrixXd in_out(inner_size, outer_size);
    for (std::size_t e = 0; e < space_.elements().size(); ++e) {
        const FlowSpace::Element& element = space_.elements()[e];
        const PointFlow flow(stacked_[e], local_velocity(element, at.velocity), element.radius,
                             material.law);
        const Eigen::MatrixXd& full =
            jacobian.of(stacked_[e], element.weight, flow, material.reynolds, mass_rate);
        Factors::Condensed& condensed = factors.elements[e];
        condensed.from_inside.resize(outer_size, inner_size);
        outside.setZero();
        inside.setZero();
        in_out.setZero();
        condensed.from_inside.setZero();
        for (Index a = 0; a < 3; ++a) {
            for (Index b = 0; b < 3; ++b) {
                const auto block = full.block(a * locals, b * locals, locals, locals);
                outside.block(a * outline, b * outline, outline, outline) =
                    block.topLeftCorner(outline, outline);
                inside.block(a * inner, b * inner, inner, inner) =
                    block.bottomRightCorner(inner, inner);
                in_out.block(a * inner, b * outline, inner, outline) =
                    block.bottomLeftCorner(inner, outline);
                condensed.from_inside.block(a * outline, b * inner, outline, inner) =
                    block.topRightCorner(outline, inner);
            }
        }
        for (Index a = 0; a < 2; ++a) {
            const auto divergence = divergence_[e].middleRows(a * locals, locals);
            const auto mean = divergence.col(0);
            const auto rest_of = divergence.rightCols(functions - 1);
            outside.block(a * outline, 3 * outline, outline, 1) = mean.head(outline);
            outside.block(3 * outline, a * outline, 1, outline) = mean.head(outline).transpose();
            // The mean pressure does no work on what vanishes on the outline: exactly zero.
            inside.block(a * inner, 3 * inner, inner, functions - 1) = rest_of.bottomRows(inner);
            inside.block(3 * inner, a * inner, functions - 1, inner) =
                rest_of.bottomRows(inner).transpose();
            in_out.block(3 * inner, a * outline, functions - 1, outline) =
                rest_of.topRows(outline).transpose();
            condensed.from_inside.block(a * outline, 3 * inner, outline, functions - 1) =
                rest_of.topRows(outline);
        }
        condensed.inside.compute(inside);
        condensed.to_inside = condensed.inside.solve(in_out);
        outside.noalias() -= condensed.from_inside * condensed.to_inside;
        const std::vector<int>& place = factors.place[e];
        for (std::size_t k = 0; k < place.size(); ++k) {
            if (place[k] >= 0) {
                factors.matrix.valuePtr()[place[k]] += outside.data()[k];
            }
        }
    }
    ++factorisations_;
    if (!factors.analysed) {
        // The residual is known, so Newton's method does what refinement of the solve would.
        factors.global.umfpackControl()(UMFPACK_IRSTEP) = 0.0;
        // Nested dissection: half the operations of minimum degree on these sections.
        factors.global.umfpackControl()(UMFPACK_ORDERING) = UMFPACK_ORDERING_METIS;
        factors.global.analyzePattern(factors.matrix);
        factors.analysed = true;
    }
    factors.global.factorize(factors.matrix);
    return factors.global.info() == Eigen::Success;
}

FlowState FlowSystem::newton_change(const FlowResidual& residual) const {
    const Factors& factors = *factors_;
    const Index outline = space_.outline_nodes();
    const Index locals = stacked_.front().cols();
    const Index inner = locals - outline;
    const Index functions = space_.pressure_values().cols();
    const Index inner_size = 3 * inner + functions - 1;
    Eigen::VectorXd load(factors.matrix.rows());
    for (std::size_t c = 0; c < components; ++c) {
        for (int node = 0; node < space_.nodes(); ++node) {
            const int unknown = space_.outline_unknown(static_cast<Component>(c), node);
            if (unknown >= 0) {
                load[unknown] = -residual.momentum(node, static_cast<Index>(c));
            }
        }
    }
    const auto& elements = space_.elements();
    std::vector<Eigen::VectorXd> inside(elements.size());
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const Index column = static_cast<Index>(e);
        if (e > 0) {
            load[space_.outline_unknowns() + column - 1] = -residual.continuity(0, column);
        }
    }
    for (std::size_t e = 0; e < elements.size(); ++e) {
        Eigen::VectorXd own(inner_size);
        for (Index a = 0; a < 3; ++a) {
            for (Index k = 0; k < inner; ++k) {
                own[a * inner + k] =
                    -residual.momentum(elements[e].node[static_cast<std::size_t>(outline + k)], a);
            }
        }
        own.tail(functions - 1) =
            -residual.continuity.col(static_cast<Index>(e)).tail(functions - 1);
        inside[e] = factors.elements[e].inside.solve(own);
        const Eigen::VectorXd passed = factors.elements[e].from_inside * inside[e];
        const std::vector<int>& unknown = factors.unknown[e];
        for (std::size_t k = 0; k < unknown.size(); ++k) {
            if (unknown[k] >= 0) {
                load[unknown[k]] -= passed[static_cast<Index>(k)];
            }
        }
    }
    const Eigen::VectorXd found = factors.global.solve(load);

    FlowState change = rest(space_);
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const std::vector<int>& unknown = factors.unknown[e];
        Eigen::VectorXd outer = Eigen::VectorXd::Zero(static_cast<Index>(unknown.size()));
        for (std::size_t k = 0; k < unknown.size(); ++k) {
            if (unknown[k] >= 0) {
                outer[static_cast<Index>(k)] = found[unknown[k]];
            }
        }
        inside[e].noalias() -= factors.elements[e].to_inside * outer;
        for (Index a = 0; a < 3; ++a) {
            for (Index k = 0; k < locals; ++k) {
                change.velocity(elements[e].node[static_cast<std::size_t>(k)], a) =
                    k < outline ? outer[a * outline + k] : inside[e][a * inner + k - outline];
            }
        }
        auto pressure = change.pressure.col(static_cast<Index>(e));
        pressure[0] = outer[3 * outline];
        pressure.tail(functions - 1) = inside[e].tail(functions - 1);
    }
    return change;
}

Eigen::MatrixX3d FlowSystem::inertia(const Eigen::MatrixX3d& acceleration, double reynolds) const {
    Eigen::MatrixX3d force = Eigen::MatrixX3d::Zero(space_.nodes(), 3);
    for (const FlowSpace::Element& element : space_.elements()) {
        Eigen::MatrixX3d at_points = space_.values() * local_velocity(element, acceleration);
        const Eigen::ArrayXd mass = reynolds * element.weight;
        at_points.col(0).array() *= mass;
        at_points.col(1).array() *= mass;
        at_points.col(2).array() *= mass * element.radius.square();
        const Eigen::MatrixX3d local = space_.values().transpose() * at_points;
        for (std::size_t k = 0; k < element.node.size(); ++k) {
            force.row(element.node[k]) += local.row(static_cast<Index>(k));
        }
    }
    return force;
}

double rotor_torque(const FlowSpace& space, const FlowResidual& residual) {
    double torque = 0.0;
    for (int node = 0; node < space.nodes(); ++node) {
        if ((space.boundary(node) & axisymmetric::rotor_wall) != 0U) {
            torque += residual.momentum(node, static_cast<Index>(Component::rotation));
        }
    }
    return torque;
}

double unbalance(const FlowSpace& space, const FlowResidual& residual) {
    double largest = residual.continuity.cwiseAbs().maxCoeff();
    for (int node = 0; node < space.nodes(); ++node) {
        for (std::size_t c = 0; c < components; ++c) {
            if (!space.is_prescribed(static_cast<Component>(c), node)) {
                largest =
                    std::max(largest, std::abs(residual.momentum(node, static_cast<Index>(c))));
            }
        }
    }
    return largest;
}

void add(FlowState& state, const FlowState& change, double share) {
    state.velocity += share * change.velocity;
    state.pressure += share * change.pressure;
}

} // namespace searle::solvers::meridional
