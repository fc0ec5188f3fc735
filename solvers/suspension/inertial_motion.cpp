#include "solvers/suspension/inertial_motion.hpp"

#include "solvers/suspension/overlap_check.hpp"
#include "solvers/suspension/suspension_rows.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace searle::solvers::suspension {
namespace {

using particles::Column;
using particles::ParticleStore;

double skin_for(const SuspensionInput& input) {
    const double fraction = input.particles.total_volume() / input.box.volume();
    return (fraction < 0.2 ? 0.3 : 0.16) * input.particles.largest_radius();
}

double smallest(const Column& column) { return *std::min_element(column.begin(), column.end()); }

} // namespace

InertialMotion::InertialMotion(SuspensionInput input)
    : input_(std::move(input)), particles_(input_.particles), box_(input_.box),
      contact_(contact_law(input_.settings)),
      colloid_(colloid_law(input_.settings.dlvo, input_.settings.temperature)),
      forces_(particles::make_pair_forces(contact_, colloid_, input_.threads)),
      list_(particles::reach_of(colloid_), skin_for(input_)), drag_{input_.settings.drag,
                                                                    input_.coupling.model,
                                                                    input_.viscosity,
                                                                    input_.density},
      limits_(input_),
      control_(input_.settings.time_step.value_or(limits_.start()),
               input_.settings.time_step.value_or(limits_.free()), limits_.displacement_error()) {
    const std::size_t count = particles_.size();
    surroundings_.resize(count);
    for (Column* column : {&fluid_fraction_, &bare_x_, &before_x_, &before_y_, &before_z_})
        column->resize(count, 0.0);
    for (Column* column : surroundings_.columns())
        companions_.push_back(column);
    for (Column* column : {&fluid_fraction_, &bare_x_, &before_x_, &before_y_, &before_z_})
        companions_.push_back(column);
    const double rate = input_.initial_wall_speed / box_.length_y;
    for (std::size_t i = 0; i < count; ++i) {
        particles_.vx[i] = rate * particles_.y[i];
        particles_.wz[i] = -0.5 * rate;
    }
    if (box_.walls) {
        profile_.emplace(
            ProfileOptions{.gap = box_.length_y,
                           .wall_area = box_.length_x * box_.length_z,
                           .cells = input_.coupling.cells[1],
                           .viscosity = input_.viscosity,
                           .density = input_.density,
                           .model_a = input_.coupling.model == CouplingModel::a,
                           .stresslets = input_.settings.hydrodynamics != Hydrodynamics::drag});
        profile_->set_uniform_shear(input_.initial_wall_speed);
    }
    if (input_.settings.brownian)
        brownian_ = {.thermal_energy = laws::colloid::boltzmann * input_.settings.temperature,
                     .key = static_cast<std::uint64_t>(input_.settings.seed)};
    weight_z_ = input_.settings.gravity.value_or(0.0) * (input_.settings.density - input_.density);
    explicit_steps_ = input_.settings.integrator == Integrator::explicit_steps;
    set_rotational_drag(input_.viscosity, particles_, surroundings_);
    rebuild();
}

void InertialMotion::rebuild() {
    list_.rebuild(particles_, box_, companions_);
    ++counts_.rebuilds;
}

int InertialMotion::interval_for(double step) const {
    if (input_.coupling.interval)
        return *input_.coupling.interval;
    if (!profile_)
        return 10;
    // A fifth of the time in which momentum crosses a cell.
    const double spacing = profile_->spacing();
    const double wanted = 0.2 * spacing * spacing * input_.density / (input_.viscosity * step);
    return static_cast<int>(std::clamp(wanted, 1.0, 20.0));
}

void InertialMotion::meet_fluid(double rate) {
    if (profile_) {
        profile_->gather_fractions(particles_);
        profile_->interpolate_mixture(particles_, surroundings_, fluid_fraction_);
        profile_->interpolate_flow(particles_, surroundings_);
    } else {
        const double fraction = 1.0 - particles_.total_volume() / box_.volume();
        for (std::size_t i = 0; i < particles_.size(); ++i) {
            surroundings_.flow_x[i] = rate * particles_.y[i];
            surroundings_.spin_z[i] = -0.5 * rate;
            fluid_fraction_[i] = fraction;
        }
    }
    if (weight_z_ != 0.0) {
        // No net flux along the vorticity: what sinks pushes fluid up.
        double flux = 0.0;
        double volume = 0.0;
        for (std::size_t i = 0; i < particles_.size(); ++i) {
            flux += particles_.vz[i] * particles_.volume(i);
            volume += particles_.volume(i);
        }
        surroundings_.flow_z = -flux / (box_.volume() - volume);
    }
    set_drag(drag_, particles_, surroundings_, fluid_fraction_, input_.threads);
}

void InertialMotion::evaluate(double wall_speed, double step, bool sampling) {
    particles::clear_forces(particles_);
    pair_sums_ = forces_->evaluate(particles_, box_, list_, step, sampling);
    wall_sums_ = {};
    if (contact_ && box_.walls)
        wall_sums_ =
            particles::add_wall_forces(*contact_, particles_, box_, list_, wall_speed, step);
    if (weight_z_ != 0.0)
        for (std::size_t i = 0; i < particles_.size(); ++i)
            particles_.fz[i] -= weight_z_ * particles_.volume(i);
    bare_x_ = particles_.fx;
    check(0.0);
}

void InertialMotion::check(double moved) const {
    const double least = smallest(particles_.radius);
    check_overlaps(pair_sums_, wall_sums_, particles_, input_.settings, time_, last_step_);
    if (!(moved < least)) {
        for (std::size_t i = 0; i < particles_.size(); ++i) {
            const double size = std::abs(particles_.fx[i]) + std::abs(particles_.fy[i]) +
                                std::abs(particles_.fz[i]);
            if (!(size < 1e300) || !(last_step_ * std::abs(particles_.vy[i]) < 0.5 * least))
                throw StepFailure(fmt::format(
                    "particle {} moved by more than a radius within the step of {:.3g} s at t = "
                    "{:.6g} s; the force on it was {:.3g} N: the step is too long for the "
                    "contact's "
                    "stiffness or the colloidal forces (particles.time_step)",
                    particles_.id[i], last_step_, time_, size));
        }
        throw StepFailure(fmt::format("a particle moved by {:.3g} m within the step of {:.3g} s at "
                                      "t = {:.6g} s, more than the smallest radius",
                                      moved, last_step_, time_));
    }
}

double InertialMotion::largest_force_change() const {
    double largest = 0.0;
    const auto count = static_cast<long>(particles_.size());
    const double *fx = particles_.fx.data(), *fy = particles_.fy.data(), *fz = particles_.fz.data();
    const double *bx = before_x_.data(), *by = before_y_.data(), *bz = before_z_.data();
    const double* drag = surroundings_.drag.data();
#pragma omp simd reduction(max : largest)
    for (long i = 0; i < count; ++i) {
        const double dx = fx[i] - bx[i];
        const double dy = fy[i] - by[i];
        const double dz = fz[i] - bz[i];
        largest = std::max(largest, (dx * dx + dy * dy + dz * dz) / (drag[i] * drag[i]));
    }
    return std::sqrt(largest);
}

void InertialMotion::move(double wall_speed, double step, bool sampling) {
    last_step_ = step;
    if (explicit_steps_) {
        count_half_kick(step);
        largest_moved_ =
            particles::kick_and_drift(particles_, step, box_.shear_rate, input_.threads);
    } else {
        largest_moved_ = particles::move_with_exact_drag(particles_, surroundings_, brownian_, step,
                                                         box_.shear_rate, input_.threads);
        ++brownian_.step;
    }
    check(largest_moved_);
    box_.advance(step);
    time_ += step;
    ++counts_.steps;
    counts_.shortest_step = counts_.steps == 1 ? step : std::min(counts_.shortest_step, step);
    counts_.longest_step = std::max(counts_.longest_step, step);
    if (list_.is_stale_after(particles_, largest_moved_, box_.shear_rate * step))
        rebuild();
    if (explicit_steps_) {
        evaluate(wall_speed, step, sampling);
        particles::add_explicit_drag(particles_, surroundings_, input_.threads);
        particles::kick(particles_, step, input_.threads);
        count_half_kick(step);
    }
}

void InertialMotion::count_half_kick(double step) {
    for (std::size_t i = 0; i < particles_.size(); ++i)
        surroundings_.impulse_x[i] += 0.5 * step * (particles_.fx[i] - bare_x_[i]);
    wall_contact_impulse_ -= 0.5 * step * (wall_sums_.upper_x + wall_sums_.lower_x);
}

StressSample InertialMotion::advance(const WallSpeed& speed, double until) {
    const double start = time_;
    double step = control_.step();
    int interval = interval_for(step);
    const double intervals = std::ceil((until - start) / (step * interval) * (1.0 - 1e-9));
    if (intervals < 1.5)
        interval = std::max(1, static_cast<int>(std::ceil((until - start) / step * (1 - 1e-9))));
    if (intervals < 2.5)
        step = (until - start) / (std::max(intervals, 1.0) * interval);
    const double duration = step * interval;
    const bool ends = intervals < 1.5;
    const double end_speed = speed(std::min(start + duration, until));
    const double start_speed = speed(start + 0.5 * step);
    box_.set_shear_rate(0.5 * (start_speed + end_speed) / box_.length_y);

    meet_fluid(box_.shear_rate);
    if (!explicit_steps_ || !forces_known_) {
        evaluate(start_speed, step, true);
        if (explicit_steps_)
            particles::add_explicit_drag(particles_, surroundings_, input_.threads);
        forces_known_ = true;
    }
    if (change_known_ && input_.settings.dlvo && !input_.settings.time_step)
        control_.adapt(0.5 * last_step_ * largest_force_change());
    WallShear wall;
    if (profile_) {
        wall = profile_->advance(particles_, surroundings_, bare_x_, duration, end_speed);
        profile_->interpolate_flow(particles_, surroundings_);
        ++counts_.fluid_steps;
    }
    StressSample result{};
    double contact_impulse = 0.0;
    for (int k = 0; k < interval; ++k) {
        const double wall_speed = speed(std::min(time_ + step, until));
        if (!explicit_steps_ && k > 0)
            evaluate(wall_speed, step, false);
        if (!profile_)
            for (std::size_t i = 0; k > 0 && i < particles_.size(); ++i)
                surroundings_.flow_x[i] = box_.shear_rate * particles_.y[i];
        if (!explicit_steps_) {
            contact_impulse += step * wall_sums_.upper_x;
            wall_contact_impulse_ -= step * (wall_sums_.upper_x + wall_sums_.lower_x);
        }
        if (k == 0 && !explicit_steps_)
            result = sample(wall, duration, box_.shear_rate, end_speed);
        if (k == interval - 1) {
            before_x_ = particles_.fx;
            before_y_ = particles_.fy;
            before_z_ = particles_.fz;
            change_known_ = true;
        }
        move(wall_speed, step, k == interval - 1);
        if (explicit_steps_)
            contact_impulse += step * wall_sums_.upper_x;
    }
    if (explicit_steps_)
        result = sample(wall, duration, box_.shear_rate, end_speed);
    result.wall.contact = -contact_impulse / (duration * box_.length_x * box_.length_z);
    if (!box_.walls)
        result.wall = result.bulk;
    if (ends)
        time_ = until;
    if (!input_.settings.time_step)
        control_.set_longest(
            pair_sums_.contacts + wall_sums_.contacts > 0
                ? limits_.touching(std::max(pair_sums_.largest_overlap, wall_sums_.largest_overlap))
                : limits_.free());
    return result;
}

StressSample InertialMotion::sample(const WallShear& wall, double duration, double rate,
                                    double end_speed) const {
    const double per_volume = 1.0 / box_.volume();
    particles::Virial contact = pair_sums_.contact;
    for (std::size_t k = 0; k < contact.size(); ++k)
        contact[k] += wall_sums_.contact[k];
    const particles::Virial& colloid = pair_sums_.colloid;
    const auto diagonal = [&](std::size_t k) { return -(contact[k] + colloid[k]) * per_volume; };
    StressSample s;
    s.time = time_ + 0.5 * duration;
    s.duration = duration;
    s.shear_rate = rate;
    s.wall.fluid = wall.viscous;
    s.wall.hydrodynamic = wall.hydrodynamic();
    s.bulk.fluid = input_.viscosity * (profile_ ? end_speed / box_.length_y : rate);
    if (profile_) {
        s.bulk.hydrodynamic = profile_->mean_stresslet();
    } else if (input_.settings.hydrodynamics != Hydrodynamics::drag) {
        double couple = 0.0;
        for (std::size_t i = 0; i < particles_.size(); ++i)
            couple -= surroundings_.rotational_drag[i] * (-0.5 * rate - particles_.wz[i]);
        s.bulk.hydrodynamic =
            2.5 * particles_.total_volume() * per_volume * s.bulk.fluid + 0.5 * couple * per_volume;
    }
    s.bulk.contact = -contact[3] * per_volume;
    s.bulk.colloid = -colloid[3] * per_volume;
    s.first_normal_difference = diagonal(0) - diagonal(4);
    s.second_normal_difference = diagonal(4) - diagonal(8);
    s.particle_pressure = -(diagonal(0) + diagonal(4) + diagonal(8)) / 3.0;
    s.contact_number = static_cast<double>(2 * pair_sums_.contacts + wall_sums_.contacts) /
                       static_cast<double>(particles_.size());
    return s;
}

double InertialMotion::momentum_defect() const {
    double sum = -wall_contact_impulse_;
    for (std::size_t i = 0; i < particles_.size(); ++i)
        sum += particles_.mass[i] * particles_.vx[i] - surroundings_.impulse_x[i];
    if (profile_) {
        // What the drag gave since the last exchange beyond the prediction is still on its way.
        for (const double predicted : profile_->state().predicted)
            sum += predicted;
        sum += profile_->momentum_gained() - profile_->wall_impulse();
    }
    return sum;
}

StepCounts InertialMotion::counts() const { return counts_; }

std::vector<double> InertialMotion::fluid_velocity() const {
    return profile_ ? profile_->velocity() : std::vector<double>{};
}

} // namespace searle::solvers::suspension
