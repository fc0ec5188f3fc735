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
/// Newton's method is given up when a step is this many times the one before it.
constexpr double growth_allowed = 3.0;
/// ... or, in units of the rotor's speed, larger than this.
constexpr double largest_step = 4.0;

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
    double before = largest_step;
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
        const FlowState change = system_.newton_change(system_.residual(state_, material));
        const double size = change.velocity.cwiseAbs().maxCoeff();
        if (!(size < largest_step) || (step > 1 && size > growth_allowed * before)) {
            break;
        }
        add(state_, change, 1.0);
        // The next step would be about size^2 / before.
        if (size <= tolerance || (step > 0 && size < before && size * size <= tolerance * before)) {
            return true;
        }
        before = size;
    }
    state_ = start;
    return false;
}

double FlowLevel::steady_torque(const FlowMaterial& material) const {
    return rotor_torque(space_, system_.residual(state_, material));
}

} // namespace searle::solvers::meridional
