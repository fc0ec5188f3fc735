#include "solvers/meridional/flow_level.hpp"

#include "solvers/axisymmetric/field_transfer.hpp"

#include <algorithm>
#include <utility>

namespace searle::solvers::meridional {
namespace {

constexpr double grading_ratio = 0.15;
constexpr int extra_points = 2; ///< of the Gauss rule beyond the degree: convection is cubic
constexpr int most_newton_steps = 12;
constexpr int most_creeping_steps = 60;
/// Newton's method is given up when a step, in units of the rotor's speed, is larger than this ...
constexpr double largest_step = 4.0;
/// ... or when less than this of it would have to be taken.
constexpr double least_damping = 0.02;
/// Factors are kept for a further step while the change falls at least by this: a step with old
/// factors costs a fraction of one with new ones.
constexpr double kept_contraction = 0.3;
/// What the last change is expected to leave, over the tolerance.
constexpr double left_share = 0.01;

double size_of(const FlowState& change) { return change.velocity.cwiseAbs().maxCoeff(); }

} // namespace

axisymmetric::SectionLines flow_lines(const geometry::DinBob& bob,
                                      const FlowResolution& resolution) {
    axisymmetric::SectionLines lines =
        axisymmetric::graded_lines(bob, {.smallest = resolution.smallest, .ratio = grading_ratio});
    for (std::size_t which = 0; which < axisymmetric::line_families; ++which) {
        std::vector<double>& family = lines[which];
        // Vortices in the gap are as long as it is wide.
        const bool is_beside = which == static_cast<std::size_t>(axisymmetric::LineFamily::beside);
        const double longest =
            is_beside ? std::min(resolution.largest, resolution.beside * (bob.radius_ratio() - 1.0))
                      : resolution.largest;
        std::vector<double> divided;
        for (std::size_t k = 0; k + 1 < family.size(); ++k) {
            const double length = family[k + 1] - family[k];
            // Halves of halves, so that the lines of a finer level contain those of a coarser one.
            int parts = 1;
            while (length > longest * parts) {
                parts *= 2;
            }
            for (int part = 0; part < parts; ++part) {
                divided.push_back(family[k] + length * part / parts);
            }
        }
        if (!family.empty()) {
            divided.push_back(family.back());
            family = std::move(divided);
        }
    }
    return lines;
}

FlowLevel::FlowLevel(const geometry::DinBob& bob, const FlowResolution& resolution)
    : FlowLevel(flow_lines(bob, resolution),
                axisymmetric::section_of(bob, flow_lines(bob, resolution)), resolution.degree) {}

FlowLevel::FlowLevel(axisymmetric::SectionLines lines, axisymmetric::SectionMesh mesh, int degree)
    : lines_(std::move(lines)), mesh_(std::move(mesh)),
      space_(mesh_, degree, degree + extra_points), system_(space_) {
    start_from_rest();
}

void FlowLevel::start_from_rest() {
    state_ = rest(space_);
    for (int node = 0; node < space_.nodes(); ++node) {
        if ((space_.boundary(node) & axisymmetric::rotor_wall) != 0U) {
            state_.velocity(node, static_cast<Eigen::Index>(Component::rotation)) = 1.0;
        }
    }
}

bool FlowLevel::solve_creeping(const axisymmetric::EnergyDensity& law, double tolerance) {
    if (!minimiser_) {
        minimiser_ = std::make_unique<axisymmetric::EnergyMinimiser>(space_.swirl_space());
    }
    const auto spin_column = static_cast<Eigen::Index>(Component::rotation);
    Eigen::VectorXd spin = state_.velocity.col(spin_column);
    const axisymmetric::Minimised end = minimiser_->minimise(
        law, Eigen::VectorXd::Zero(spin.size()), tolerance, most_creeping_steps, spin);
    state_ = rest(space_);
    state_.velocity.col(spin_column) = spin;
    return end.converged;
}

void FlowLevel::start_from(const FlowLevel& other) {
    const axisymmetric::DividedSection from{other.lines_, other.mesh_, other.space_.swirl_space()};
    const axisymmetric::DividedSection to{lines_, mesh_, space_.swirl_space()};
    // The pressure enters the equations linearly, so the first Newton step finds it from nothing.
    FlowState state = rest(space_);
    for (std::size_t c = 0; c < components; ++c) {
        const auto column = static_cast<Eigen::Index>(c);
        state.velocity.col(column) = axisymmetric::transferred(
            from, other.state_.velocity.col(column), axisymmetric::Field::rotation, to);
        for (int node = 0; node < space_.nodes(); ++node) {
            if (space_.is_prescribed(static_cast<Component>(c), node)) {
                state.velocity(node, column) = state_.velocity(node, column);
            }
        }
    }
    state_ = std::move(state);
}

bool FlowLevel::solve_steady(const FlowMaterial& material, double tolerance,
                             const std::function<void()>& before_step) {
    const FlowState start = state_;
    double damping = 1.0;
    for (int step = 0; step < most_newton_steps; ++step) {
        if (before_step) {
            try {
                before_step();
            } catch (...) {
                state_ = start;
                throw;
            }
        }
        if (!system_.factorise(state_, material)) {
            break;
        }
        FlowState change = system_.newton_change(system_.residual(state_, material));
        if (!(size_of(change) < largest_step)) {
            break;
        }
        const double left = left_share * tolerance;
        if (size_of(change) <= left) {
            add(state_, change, 1.0);
            return true;
        }
        // Deuflhard's natural test (Newton Methods for Nonlinear Problems, 2004, section 3.3): the
        // next change by the same factors has to be smaller, whatever the equations' scaling.
        FlowState next;
        for (;;) {
            const FlowState from = state_;
            add(state_, change, damping);
            next = system_.newton_change(system_.residual(state_, material));
            const double length = change.velocity.norm();
            if (next.velocity.norm() <= (1.0 - 0.25 * damping) * length) {
                break;
            }
            state_ = from;
            const double curved = (next.velocity - (1.0 - damping) * change.velocity).norm();
            const double foreseen = 0.5 * damping * damping * length / curved;
            damping = std::clamp(foreseen, 0.1 * damping, 0.5 * damping);
            if (!(damping >= least_damping)) {
                state_ = start;
                return false;
            }
        }
        if (damping < 1.0) {
            const double curved = (next.velocity - (1.0 - damping) * change.velocity).norm();
            damping = std::min(1.0, damping * damping * change.velocity.norm() / curved);
            continue;
        }
        for (;;) {
            const double before = size_of(change);
            const double size = size_of(next);
            if (!(size < kept_contraction * before || size <= left)) {
                break;
            }
            add(state_, next, 1.0);
            if (size <= left || size * size <= left * before) {
                return true;
            }
            change = std::move(next);
            next = system_.newton_change(system_.residual(state_, material));
        }
    }
    state_ = start;
    return false;
}

double FlowLevel::steady_torque(const FlowMaterial& material) const {
    return rotor_torque(space_, system_.residual(state_, material));
}

} // namespace searle::solvers::meridional
