#include "solvers/meridional/flow_system.hpp"

#include "solvers/meridional/element_jacobian.hpp"
#include "solvers/meridional/multifrontal_lu.hpp"
#include "solvers/meridional/point_flow.hpp"

#include <Eigen/LU>

#include <utility>

namespace searle::solvers::meridional {
namespace {

using Index = Eigen::Index;

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
/// there; the velocities on outlines and one mean pressure an element remain for all together.
struct FlowSystem::Factors {
    struct Condensed {
        Eigen::PartialPivLU<Eigen::MatrixXd> inside;
        Eigen::MatrixXd to_inside;   ///< inside^-1 (inside, outline)
        Eigen::MatrixXd from_inside; ///< (outline, inside)
    };
    std::vector<Condensed> elements;
    /// Of each element's outline, component by component, then its mean pressure; the pressure is
    /// known up to a constant: the first element's mean is zero.
    std::vector<ElementUnknowns> outlines;
    int size; ///< number of unknowns
    MultifrontalLu global;

    explicit Factors(const FlowSpace& space)
        : elements(space.elements().size()), outlines(outlines_of(space)),
          size(space.outline_unknowns() + static_cast<int>(elements.size()) - 1),
          global(outlines, size) {}

private:
    static std::vector<ElementUnknowns> outlines_of(const FlowSpace& space);
};

std::vector<ElementUnknowns> FlowSystem::Factors::outlines_of(const FlowSpace& space) {
    std::vector<ElementUnknowns> outlines;
    int mean_pressure = -1;
    for (std::size_t e = 0; e < space.elements().size(); ++e) {
        ElementUnknowns outline{.unknown = {},
                                .multiplier = mean_pressure,
                                .radius = space.elements()[e].radius.mean(),
                                .height = space.swirl_space().elements()[e].height.mean()};
        for (std::size_t c = 0; c < components; ++c) {
            for (int k = 0; k < space.outline_nodes(); ++k) {
                outline.unknown.push_back(
                    space.outline_unknown(static_cast<Component>(c),
                                          space.elements()[e].node[static_cast<std::size_t>(k)]));
            }
        }
        outline.unknown.push_back(mean_pressure);
        mean_pressure = space.outline_unknowns() + static_cast<int>(e);
        outlines.push_back(std::move(outline));
    }
    return outlines;
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
    ElementJacobian jacobian(stacked_.front().rows() / 3, locals);
    Eigen::MatrixXd inside(inner_size, inner_size);
    Eigen::MatrixXd in_out(inner_size, outer_size);
    const auto condense = [&](std::size_t e, Eigen::MatrixXd& outside) {
        const FlowSpace::Element& element = space_.elements()[e];
        const PointFlow flow(stacked_[e], local_velocity(element, at.velocity), element.radius,
                             material.law);
        const Eigen::MatrixXd& full =
            jacobian.of(stacked_[e], element.weight, flow, material.reynolds, mass_rate);
        Factors::Condensed& condensed = factors.elements[e];
        condensed.from_inside.resize(outer_size, inner_size);
        outside.setZero(outer_size, outer_size);
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
    };
    ++factorisations_;
    return factors.global.factorise(condense);
}

FlowState FlowSystem::newton_change(const FlowResidual& residual) const {
    const Factors& factors = *factors_;
    const Index outline = space_.outline_nodes();
    const Index locals = stacked_.front().cols();
    const Index inner = locals - outline;
    const Index functions = space_.pressure_values().cols();
    const Index inner_size = 3 * inner + functions - 1;
    Eigen::VectorXd load(factors.size);
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
        const std::vector<int>& unknown = factors.outlines[e].unknown;
        for (std::size_t k = 0; k < unknown.size(); ++k) {
            if (unknown[k] >= 0) {
                load[unknown[k]] -= passed[static_cast<Index>(k)];
            }
        }
    }
    const Eigen::VectorXd found = factors.global.solve(load);

    FlowState change = rest(space_);
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const std::vector<int>& unknown = factors.outlines[e].unknown;
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
