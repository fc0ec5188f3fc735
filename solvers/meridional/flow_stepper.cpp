#include "solvers/meridional/flow_stepper.hpp"

#include "solvers/radial/esdirk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace searle::solvers::meridional {
namespace {

using radial::Esdirk;

constexpr int most_iterations = 8;
/// Share of the step's tolerance that Newton's method may leave.
constexpr double newton_share = 0.05;
/// Factors are made anew when the iteration contracts less than this ...
constexpr double slow_contraction = 0.25;
/// ... or when the step they were made for differs by more than this factor.
constexpr double stale_length = 1.6;
constexpr double safety = 0.85;
constexpr double most_growth = 3.0;
constexpr double least_growth = 0.2;
/// A step is lengthened only when that pays for the new factors.
constexpr double worthwhile_growth = 1.3;
constexpr double error_order = 4.0; ///< of one step of the embedded method

/// A fluid without viscosity at rest: what remains of the derivative is the mass.
class NoViscosity final : public axisymmetric::EnergyDensity {
public:
    void slopes(const Eigen::ArrayXd& rate, Eigen::ArrayXd& secant,
                Eigen::ArrayXd& tangent) const override {
        secant.setZero(rate.size());
        tangent.setZero(rate.size());
    }
};

double largest(const Eigen::MatrixX3d& velocity) { return velocity.cwiseAbs().maxCoeff(); }

} // namespace

FlowStepper::FlowStepper(FlowSystem& system, FlowMaterial material, FlowState start,
                         StepperSettings settings)
    : system_(system), material_(material), settings_(settings), state_(std::move(start)),
      state_before_(state_), rate_(Eigen::MatrixX3d::Zero(state_.velocity.rows(), 3)),
      rate_before_(rate_) {}

void FlowStepper::turn_rotor(FlowState& state, double speed) const {
    const FlowSpace& space = system_.space();
    for (int node = 0; node < space.nodes(); ++node) {
        if ((space.boundary(node) & axisymmetric::rotor_wall) != 0U) {
            state.velocity(node, static_cast<Eigen::Index>(Component::rotation)) =
                settings_.rotor_profile.size() > 0 ? speed * settings_.rotor_profile[node] : speed;
        }
    }
}

void FlowStepper::begin(const LinearDrive& drive) {
    drive_ = drive;
    time_ = drive.start_time;
    time_before_ = time_;
    const NoViscosity inviscid;
    const bool has_mass =
        system_.factorise(rest(system_.space()), {inviscid, material_.reynolds}, 1.0);
    // A jump of the rotor moves no fluid at once: the tested momentum of the fluid stays, which
    // nodes that stay would not give, for the functions of the rotor's nodes reach into the fluid.
    FlowState jump = state_;
    turn_rotor(jump, drive.speed);
    jump.velocity -= state_.velocity;
    turn_rotor(state_, drive.speed);
    FlowResidual kick{.momentum = system_.inertia(jump.velocity, material_.reynolds),
                      .continuity =
                          Eigen::MatrixXd::Zero(state_.pressure.rows(), state_.pressure.cols())};
    if (has_mass) {
        state_.velocity += system_.newton_change(kick).velocity;
    }
    // Rate of change and pressure that momentum and continuity give for this velocity.
    FlowState rate = rest(system_.space());
    turn_rotor(rate, drive.acceleration);
    FlowResidual residual = system_.residual(state_, material_);
    residual.momentum += system_.inertia(rate.velocity, material_.reynolds);
    residual.continuity.setZero();
    if (has_mass) {
        const FlowState change = system_.newton_change(residual);
        rate_ = rate.velocity + change.velocity;
        state_.pressure += change.pressure;
    }
    state_before_ = state_;
    rate_before_ = rate_;
    factorised_length_ = 0.0;
    next_length_ = settings_.first_step;
}

void FlowStepper::refactorise(double length) {
    if (!system_.factorise(state_, material_, 1.0 / (Esdirk::diagonal * length))) {
        factorised_length_ = 0.0;
        return;
    }
    factorised_length_ = length;
    factors_are_stale_ = false;
}

FlowStepper::Outcome FlowStepper::try_step(double length, double least_scale) {
    constexpr auto stages = static_cast<std::size_t>(Esdirk::stages);
    const double mass_rate = 1.0 / (Esdirk::diagonal * length);
    const double reynolds = material_.reynolds;
    std::array<Eigen::MatrixX3d, stages> force;
    std::array<Eigen::MatrixX3d, stages> rate;
    force[0] = -system_.residual(state_, material_).momentum;
    rate[0] = rate_;
    FlowState stage = state_;
    double worst_contraction = 0.0;
    for (std::size_t i = 1; i < stages; ++i) {
        const auto& weight = Esdirk::weight[i];
        Eigen::MatrixX3d known = Eigen::MatrixX3d::Zero(state_.velocity.rows(), 3);
        Eigen::MatrixX3d drift = Eigen::MatrixX3d::Zero(state_.velocity.rows(), 3);
        for (std::size_t j = 0; j < i; ++j) {
            known += weight[j] / Esdirk::diagonal * force[j];
            drift += weight[j] / Esdirk::diagonal * rate[j];
        }
        stage.velocity = state_.velocity + length * Esdirk::diagonal * (drift + rate[i - 1]);
        turn_rotor(stage, drive_.speed_at(time_ + Esdirk::time[i] * length));
        const double scale = std::max(largest(stage.velocity), least_scale);
        const double allowed = newton_share * settings_.tolerance * scale;
        double before = 0.0;
        bool converged = false;
        for (int iteration = 0; iteration < most_iterations; ++iteration) {
            FlowResidual residual = system_.residual(stage, material_);
            residual.momentum +=
                system_.inertia(mass_rate * (stage.velocity - state_.velocity), reynolds) - known;
            const FlowState change = system_.newton_change(residual);
            ++solves_;
            add(stage, change, 1.0);
            const double size = largest(change.velocity);
            const double contraction = iteration > 0 ? size / before : 0.0;
            worst_contraction = std::max(worst_contraction, contraction);
            if (!std::isfinite(size) || contraction > 1.0) {
                break;
            }
            const double left = iteration > 0 ? size * contraction / (1.0 - contraction) : size;
            if (left <= allowed || size <= 1e-3 * allowed) {
                converged = true;
                break;
            }
            before = size;
        }
        if (!converged) {
            return Outcome::stuck;
        }
        const Eigen::MatrixX3d change = mass_rate * (stage.velocity - state_.velocity);
        force[i] = system_.inertia(change, reynolds) - known;
        rate[i] = change - drift;
    }
    Eigen::MatrixX3d error = Eigen::MatrixX3d::Zero(state_.velocity.rows(), 3);
    for (std::size_t i = 0; i < stages; ++i) {
        error += length * (Esdirk::weight[stages - 1][i] - Esdirk::embedded[i]) * rate[i];
    }
    error_ratio_ =
        largest(error) / (settings_.tolerance * std::max(largest(stage.velocity), least_scale));
    if (worst_contraction > slow_contraction) {
        factors_are_stale_ = true;
    }
    if (!(error_ratio_ <= 1.0)) {
        return Outcome::inaccurate;
    }
    state_before_ = std::move(state_);
    rate_before_ = std::move(rate_);
    state_ = std::move(stage);
    rate_ = std::move(rate[stages - 1]);
    time_before_ = time_;
    time_ += length;
    return Outcome::taken;
}

bool FlowStepper::step(double limit, double least_scale) {
    const double least = std::max(settings_.shortest_step, 1e-12 * std::abs(limit));
    for (;;) {
        if (settings_.at_each_try) {
            settings_.at_each_try();
        }
        double length = next_length_;
        const double left = limit - time_;
        const bool is_last = length >= 0.999 * left;
        if (is_last) {
            length = left;
        } else if (length > 0.5 * left) {
            length = 0.5 * left;
        }
        if (length < least && !is_last) {
            return false;
        }
        const bool are_fresh = factorised_length_ == 0.0 || factors_are_stale_ ||
                               length > stale_length * factorised_length_ ||
                               length < factorised_length_ / stale_length;
        if (are_fresh) {
            refactorise(length);
        }
        const Outcome outcome =
            factorised_length_ > 0.0 ? try_step(length, least_scale) : Outcome::stuck;
        if (outcome == Outcome::stuck) {
            ++rejected_;
            // Old factors may be the cause; fresh ones are not.
            if (are_fresh) {
                next_length_ = 0.3 * length;
            }
            factors_are_stale_ = true;
            if (next_length_ < least) {
                return false;
            }
            continue;
        }
        const double growth =
            std::clamp(safety * std::pow(std::max(error_ratio_, 1e-10), -1.0 / error_order),
                       least_growth, most_growth);
        if (outcome == Outcome::inaccurate) {
            ++rejected_;
            next_length_ = length * std::min(growth, 0.7);
            continue;
        }
        ++steps_;
        // A step cut short by the limit says nothing against the length that was planned.
        if (growth < 1.0 || growth > worthwhile_growth) {
            next_length_ = std::max(length * growth,
                                    is_last ? std::min(next_length_, length * most_growth) : 0.0);
        } else if (!is_last) {
            next_length_ = length;
        }
        if (is_last) {
            time_ = limit;
        }
        return true;
    }
}

Eigen::MatrixX3d FlowStepper::velocity_at(double time) const {
    const double length = time_ - time_before_;
    const double x = length > 0.0 ? (time - time_before_) / length : 1.0;
    const double y = 1.0 - x;
    // Cubic Hermite polynomials.
    return y * y * (1.0 + 2.0 * x) * state_before_.velocity +
           x * x * (3.0 - 2.0 * x) * state_.velocity +
           length * x * y * (y * rate_before_ - x * rate_);
}

double FlowStepper::torque_at(double time) const {
    const double length = time_ - time_before_;
    const double x = length > 0.0 ? (time - time_before_) / length : 1.0;
    const double y = 1.0 - x;
    FlowState between = state_;
    between.velocity = velocity_at(time);
    // The slopes of velocity_at.
    Eigen::MatrixX3d rate = rate_;
    if (length > 0.0) {
        rate = 6.0 * x * y / length * (state_.velocity - state_before_.velocity) +
               y * (1.0 - 3.0 * x) * rate_before_ + x * (3.0 * x - 2.0) * rate_;
    }
    FlowResidual residual = system_.residual(between, material_);
    residual.momentum += system_.inertia(rate, material_.reynolds);
    return rotor_torque(system_.space(), residual);
}

} // namespace searle::solvers::meridional
