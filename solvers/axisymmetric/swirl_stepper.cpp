#include "solvers/axisymmetric/swirl_stepper.hpp"

#include "solvers/axisymmetric/newton_flux.hpp"
#include "solvers/radial/esdirk.hpp"
#include "solvers/steps_before_stop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::solvers::axisymmetric {
namespace {

using radial::Esdirk;

constexpr int most_newton_steps = 25;
constexpr int most_steady_steps = 60;
/// What Newton's method may leave of a stage, over the tolerance of a step: its decrement goes as
/// the square of that.
constexpr double newton_share = 0.02;
constexpr double least_decrement = 1e-17;
constexpr double steady_decrement = 1e-13;
constexpr double rounding_step = 0.1; ///< of the way from a Newtonian start to the law
/// Fastest rate of a fluid at rest, over the law's rounding: no torque is left to tell.
constexpr double rest_share = 1e-8;

} // namespace

SwirlStepper::SwirlStepper(const SectionSpace& space, const SwirlLaw& law, Settings settings)
    : space_(space), law_(law), settings_(settings), minimiser_(space), rotor_(space.prescribed()),
      no_load_(Eigen::VectorXd::Zero(space.nodes())),
      rotation_(Eigen::VectorXd::Zero(space.nodes())), rate_(Eigen::VectorXd::Zero(space.nodes())) {
}

void SwirlStepper::turn_rotor(double speed, Eigen::VectorXd& values) const {
    values = (rotor_.array() != 0.0).select(speed * rotor_, values);
}

bool SwirlStepper::solve(double theta, const Eigen::VectorXd& centre, double speed,
                         Eigen::VectorXd& values) {
    turn_rotor(speed, values);
    const InertiaTerm inertia{settings_.inertia / theta, centre};
    const double decrement =
        std::max(least_decrement, std::pow(newton_share * settings_.tolerance, 2));
    const Eigen::VectorXd start = values;
    const SwirlLaw::RoundedPotential density(law_, settings_.rounding);
    const Minimised found =
        minimiser_.minimise(density, no_load_, decrement, most_newton_steps, values, &inertia);
    solves_ += found.steps;
    if (found.converged) {
        return true;
    }
    // A plug's edge far from where it was: from a rounder law.
    values = start;
    return approach(decrement, most_newton_steps, &inertia, values);
}

bool SwirlStepper::approach(double decrement, int most_steps, const InertiaTerm* inertia,
                            Eigen::VectorXd& values) {
    constexpr double on_the_way = 1e-6; // decrement
    for (double rounding = 1.0; rounding > 1.001 * settings_.rounding;
         rounding = std::max(rounding_step * rounding, settings_.rounding)) {
        const SwirlLaw::RoundedPotential rounder(law_, rounding);
        solves_ +=
            minimiser_.minimise(rounder, no_load_, on_the_way, most_steps, values, inertia).steps;
    }
    const SwirlLaw::RoundedPotential density(law_, settings_.rounding);
    const Minimised found =
        minimiser_.minimise(density, no_load_, decrement, most_steady_steps, values, inertia);
    solves_ += found.steps;
    return found.converged;
}

bool SwirlStepper::start_steadily(double speed) {
    rate_.setZero();
    rotation_.setZero();
    turn_rotor(speed, rotation_);
    return speed == 0.0 || approach(steady_decrement, most_steady_steps, nullptr, rotation_);
}

bool SwirlStepper::begin(const SwirlDrive& drive, double first) {
    drive_ = drive;
    time_ = drive.start_time;
    // A jump of the rotor moves no fluid at once: the centre keeps its old speed, whose tested
    // momentum reaches into the fluid.
    Eigen::VectorXd values = rotation_;
    const Eigen::VectorXd centre = rotation_;
    if (!solve(first, centre, drive.speed_at(time_ + first), values)) {
        return false;
    }
    rate_ = (values - centre) / first;
    rate_ = (rotor_.array() != 0.0).select(drive.acceleration * rotor_, rate_);
    rotation_ = std::move(values);
    time_ += first;
    next_length_ = first;
    ++steps_;
    return true;
}

double SwirlStepper::attempt(double length) {
    const double theta = length * Esdirk::diagonal;
    std::array<Eigen::VectorXd, Esdirk::stages> rate;
    rate[0] = rate_;
    Eigen::VectorXd values;
    for (std::size_t i = 1; i < Esdirk::stages; ++i) {
        Eigen::VectorXd centre = rotation_;
        for (std::size_t j = 0; j < i; ++j) {
            if (Esdirk::weight[i][j] != 0.0) {
                centre += length * Esdirk::weight[i][j] * rate[j];
            }
        }
        values = centre + theta * rate[i - 1];
        if (!solve(theta, centre, drive_.speed_at(time_ + Esdirk::time[i] * length), values)) {
            return std::numeric_limits<double>::infinity();
        }
        rate[i] = (values - centre) / theta;
    }
    Eigen::VectorXd error = Eigen::VectorXd::Zero(values.size());
    for (std::size_t j = 0; j < Esdirk::stages; ++j) {
        error += length * (Esdirk::weight[Esdirk::stages - 1][j] - Esdirk::embedded[j]) * rate[j];
    }
    // In the norm of the kinetic energy: momentum that a step misplaces acts on the torque later,
    // and the nodes that a yield surface passes in the step are no measure of it.
    const double moving = std::max(minimiser_.inertia_product(values, values),
                                   minimiser_.inertia_product(rotation_, rotation_));
    const double ratio =
        moving > 0.0
            ? std::sqrt(minimiser_.inertia_product(error, error) / moving) / settings_.tolerance
            : 0.0;
    if (ratio <= 1.0) {
        rotation_ = std::move(values);
        rate_ = std::move(rate[Esdirk::stages - 1]);
    }
    return ratio;
}

bool SwirlStepper::has_come_to_rest() const {
    return drive_.speed == 0.0 && drive_.acceleration == 0.0 &&
           gradients(space_, rotation_).cwiseAbs().maxCoeff() <= rest_share * settings_.rounding;
}

bool SwirlStepper::step(double limit, double longest) {
    if (has_come_to_rest()) {
        rotation_.setZero();
        rate_.setZero();
        time_ = limit;
        ++steps_;
        return true;
    }
    constexpr double shortest = 1e-10;
    const double most_left = limit - time_;
    const double stretch = limit - drive_.start_time;
    // A yield stress leaves the torque of a stop open.
    const bool stops =
        drive_.acceleration != 0.0 && law_.yield_stress() == 0.0 &&
        std::abs(drive_.speed_at(limit)) <= 1e-12 * std::abs(drive_.acceleration) * stretch;
    for (;;) {
        const double left = limit - time_;
        const double allowed = std::min(longest, next_length_);
        const double most = stops ? longest_before_stop(left, stretch, allowed) : allowed;
        // Equal steps up to the limit rather than a short one at its end.
        const double count = std::max(1.0, std::ceil(left / most * (1.0 - 1e-12)));
        const double length = left / count;
        if (length < shortest * most_left) {
            return false;
        }
        const double ratio = attempt(length);
        const double factor =
            std::isfinite(ratio) ? 0.9 * std::pow(std::max(ratio, 1e-10), -0.25) : 0.2;
        if (ratio <= 1.0) {
            ++steps_;
            time_ = count <= 1.0 ? limit : time_ + length;
            const double next = length * std::clamp(factor, 0.3, 5.0);
            next_length_ = length < 0.99 * next_length_ ? std::max(next_length_, next) : next;
            return true;
        }
        next_length_ = length * std::clamp(factor, 0.1, 0.8);
    }
}

std::optional<double> SwirlStepper::steady_torque(double speed) {
    if (speed == 0.0) {
        return 0.0;
    }
    const SwirlLaw::RoundedPotential density(law_, settings_.rounding);
    Eigen::VectorXd values = rotation_;
    turn_rotor(speed, values);
    const Minimised found =
        minimiser_.minimise(density, no_load_, steady_decrement, most_steady_steps, values);
    solves_ += found.steps;
    if (!found.converged) {
        values.setZero();
        turn_rotor(speed, values);
        if (!approach(steady_decrement, most_steady_steps, nullptr, values)) {
            return {};
        }
    }
    return minimiser_.work_along(density, values, rotor_);
}

double SwirlStepper::torque() {
    const SwirlLaw::RoundedPotential density(law_, settings_.rounding);
    return minimiser_.work_along(density, rotation_, rotor_) +
           settings_.inertia * minimiser_.inertia_product(rotor_, rate_);
}

} // namespace searle::solvers::axisymmetric
