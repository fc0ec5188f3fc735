#include "solvers/suspension/overdamped_motion.hpp"

#include "solvers/suspension/overlap_check.hpp"
#include "solvers/suspension/pair_kinematics.hpp"
#include "solvers/suspension/particle_checkpoint.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace searle::solvers::suspension {
namespace {

constexpr double strain_share = 1e-3; ///< strain within a step
constexpr double move_share = 2e-3;   ///< displacement beside the mean flow within a step, radii
constexpr double range_share = 0.2;   ///< closing of a pair within a step over the Debye length

/// What a solve may leave over of the forces: at phi 0.4 that changes the mean stress of the box by
/// 2e-5 of itself.
constexpr double residual_share = 1e-4;
/// What a solve may leave between the wall's stress and the box's, over the asked accuracy and the
/// fluid's own stress: a third of what is claimed for the films of a thin suspension.
constexpr double wall_share = 0.05;

double scale_for(double accuracy) { return std::clamp(accuracy / 1e-2, 0.02, 1.0); }

double reach_for(const SuspensionInput& input, const particles::AnyColloid& colloid) {
    return std::max(farthest_film * input.particles.largest_radius(), particles::reach_of(colloid));
}

} // namespace

double overdamped_step(double accuracy, double shear_rate) {
    return scale_for(accuracy) * strain_share / shear_rate;
}

OverdampedMotion::OverdampedMotion(SuspensionInput input)
    : input_(std::move(input)), particles_(input_.particles), box_(input_.box),
      contact_(contact_law(input_.settings)),
      friction_(contact_ ? laws::contact::friction_of(*contact_) : 0.0),
      colloid_(colloid_law(input_.settings.dlvo, input_.settings.temperature)),
      films_{.viscosity = input_.viscosity,
             .farthest_gap = farthest_film,
             .roughness = film_roughness,
             .length_unit = input_.particles.largest_radius()},
      list_(reach_for(input_, colloid_), 0.25 * input_.particles.largest_radius()),
      solver_(particles_.size(), input_.viscosity, films_.length_unit, input_.threads) {
    motion_.assign(motions_for(particles_.size()), Motion{});
    right_side_ = motion_;
    if (box_.walls)
        profile_.emplace(MixtureProfileOptions{.gap = box_.length_y,
                                               .wall_area = box_.length_x * box_.length_z,
                                               .cells = input_.coupling.cells[1],
                                               .viscosity = input_.viscosity,
                                               .density = input_.density,
                                               .length_unit = films_.length_unit});
    if (profile_)
        profile_->set_uniform_shear(input_.initial_wall_speed);
    list_.rebuild(particles_, box_);
}

double OverdampedMotion::choose_step(double rate) const {
    if (input_.settings.time_step)
        return *input_.settings.time_step;
    const double scale = scale_for(input_.accuracy);
    // Beside a wall that jumps the flow is far steeper than in the mean.
    const double steepest = std::max(rate, profile_ ? profile_->steepest_rate() : 0.0);
    double step = strain_share / std::max(steepest, 1e-300);
    const double radius = *std::min_element(particles_.radius.begin(), particles_.radius.end());
    if (counts_.steps == 0)
        step *= 0.01;
    else
        step = std::min(step, 1.2 * step_ / scale);
    if (fastest_ > 0.0)
        step = std::min(step, move_share * radius / fastest_);
    if (input_.settings.dlvo && fastest_closing_ > 0.0)
        step = std::min(step, range_share *
                                  debye_length(*input_.settings.dlvo, input_.settings.temperature) /
                                  fastest_closing_);
    return scale * step;
}

void OverdampedMotion::set_right_side(double rate) {
    for (Motion& each : right_side_)
        each = {};
    for (const NearPair& c : pairs_) {
        // Mean straining motion of the second against the first.
        const double half = 0.5 * rate * c.distance;
        const Vector<double> n{c.nx, c.ny, c.nz};
        const PairMotion<double> strained =
            pair_motion<double>(n, {half * c.ny, half * c.nx, 0.0}, {}, {});
        // On the first: the film's drag of the straining motion, less what pushes the second.
        const double normal = c.squeeze * strained.along - c.push;
        const double rolled = is_wall(c, particles_.size()) ? wall_roll(rate) * -c.ny : 0.0;
        const Vector<double> roll{rolled, 0.0, 0.0};
        const Vector<double> film = combined(c.shear, strained.shear, c.mixed, roll);
        const PairPush<double> push =
            pair_push(n, normal, {film.x - c.tx, film.y - c.ty, film.z - c.tz},
                      combined(c.mixed, strained.shear, c.pump, roll));
        Motion& a = right_side_[static_cast<std::size_t>(c.first)];
        Motion& b = right_side_[static_cast<std::size_t>(c.second)];
        a[0] += push.force.x;
        a[1] += push.force.y;
        a[2] += push.force.z;
        b[0] -= push.force.x;
        b[1] -= push.force.y;
        b[2] -= push.force.z;
        a[3] += c.lever_first * push.arm.x + push.couple.x;
        a[4] += c.lever_first * push.arm.y + push.couple.y;
        a[5] += c.lever_first * push.arm.z + push.couple.z;
        b[3] += c.lever_second * push.arm.x - push.couple.x;
        b[4] += c.lever_second * push.arm.y - push.couple.y;
        b[5] += c.lever_second * push.arm.z - push.couple.z;
    }
}

ResistanceSolver::Goal OverdampedMotion::goal_of_solve(double rate) const {
    ResistanceSolver::Goal goal{.residual_share = residual_share};
    if (!box_.walls)
        return goal;
    // Of the fluid's stress; where the wall all but stands, of that at a hundredth of its speed.
    const double fastest = input_.fastest_wall_speed / box_.length_y;
    const double stress = input_.viscosity * std::max(std::abs(rate), 1e-2 * fastest);
    goal.shear_rate = rate;
    goal.largest_work = wall_share * std::clamp(input_.accuracy, 2e-4, 1e-2) * stress *
                        std::abs(rate) * box_.volume();
    return goal;
}

void OverdampedMotion::solve(double rate) {
    set_right_side(rate);
    solver_.prepare(particles_, pairs_);
    if (profile_) {
        profile_->prepare(particles_, solver_.drag(), solver_.turning_drag(), rate, step_);
        profile_->add_load(right_side_);
    }
    MixtureProfile* profile = profile_ ? &*profile_ : nullptr;
    const ResistanceSolver::Outcome found =
        solver_.solve(profile, goal_of_solve(rate), right_side_, motion_);
    counts_.solver_iterations += found.iterations;
    if (!found.converged)
        throw StepFailure(fmt::format("the velocities of the particles were not found within {} "
                                      "iterations at t = {:.6g} s (residual {:.2g} of the forces)",
                                      found.iterations, time_, found.residual));
    if (profile_)
        profile_->follow(motion_);
}

void OverdampedMotion::keep_spring(const NearPair& pair, double x, double y, double z) {
    const auto k = static_cast<std::size_t>(pair.listed);
    if (is_wall(pair, particles_.size())) {
        (is_upper_wall(pair, particles_.size()) ? list_.upper_x : list_.lower_x)[k] = x;
        (is_upper_wall(pair, particles_.size()) ? list_.upper_z : list_.lower_z)[k] = z;
        return;
    }
    list_.spring_x[k] = x;
    list_.spring_y[k] = y;
    list_.spring_z[k] = z;
}

StressSample OverdampedMotion::move(double step, double rate) {
    particles::Virial film{}, contact{}, colloid{};
    const Motion wall_motion{0.0, 0.0, 0.0, 0.0, 0.0, wall_roll(rate)};
    StressParts on_upper;     // forces of the particles on the upper wall along x, N
    double wall_couple = 0.0; // of the films at the walls: power over the shear rate, N m
    fastest_closing_ = 0.0;
    for (const NearPair& c : pairs_) {
        const Motion& a = motion_[static_cast<std::size_t>(c.first)];
        const Motion& b = is_wall(c, particles_.size())
                              ? wall_motion
                              : motion_[static_cast<std::size_t>(c.second)];
        const double half = 0.5 * rate * c.distance;
        const auto levered = [&](std::size_t k) {
            return c.lever_first * a[k] + c.lever_second * b[k];
        };
        const auto [along, s, r] = pair_motion<double>(
            {c.nx, c.ny, c.nz}, {b[0] - a[0] + half * c.ny, b[1] - a[1] + half * c.nx, b[2] - a[2]},
            {levered(3), levered(4), levered(5)}, {b[3] - a[3], b[4] - a[4], b[5] - a[5]});
        const double reach[3] = {c.distance * c.nx, c.distance * c.ny, c.distance * c.nz};
        const auto add = [&](particles::Virial& virial, double fx, double fy, double fz) {
            const double f[3] = {fx, fy, fz};
            for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t m = 0; m < 3; ++m)
                    virial[3 * k + m] += reach[k] * f[m];
        };
        const double film_normal = -c.film_squeeze * along;
        add(film, film_normal * c.nx - c.film_shear * s.x - c.mixed * r.x,
            film_normal * c.ny - c.film_shear * s.y - c.mixed * r.y,
            film_normal * c.nz - c.film_shear * s.z - c.mixed * r.z);
        const double colloid_normal = c.push - c.contact_push - step * c.colloid_stiffness * along;
        add(colloid, colloid_normal * c.nx, colloid_normal * c.ny, colloid_normal * c.nz);
        if (c.colloid_stiffness > 0.0)
            fastest_closing_ = std::max(fastest_closing_, std::abs(along));
        if (c.touches) {
            const double normal = c.contact_push - step * c.stiffness * along;
            const double spring = step * c.tangential_stiffness;
            const double tx = c.tx - spring * s.x;
            const double ty = c.ty - spring * s.y;
            const double tz = c.tz - spring * s.z;
            add(contact, normal * c.nx + tx, normal * c.ny + ty, normal * c.nz + tz);
            if (is_upper_wall(c, particles_.size()))
                on_upper.contact += tx;
            if (friction_ > 0.0)
                keep_spring(c, step * s.x - c.tx / c.spring, step * s.y - c.ty / c.spring,
                            step * s.z - c.tz / c.spring);
        } else if (friction_ > 0.0) {
            keep_spring(c, 0.0, 0.0, 0.0);
        }
        if (is_wall(c, particles_.size())) {
            wall_couple -= 0.5 * films_.length_unit * c.ny * (c.mixed * s.x + c.pump * r.x);
            if (is_upper_wall(c, particles_.size()))
                on_upper.hydrodynamic -= c.film_shear * s.x + c.mixed * r.x;
        }
    }
    double fastest_squared = 0.0;
    double beside_squared = 0.0;
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        const Motion& v = motion_[i];
        const double across_squared = v[1] * v[1] + v[2] * v[2];
        const double along = profile_ ? v[0] - profile_->velocity_at(i) : v[0];
        fastest_squared = std::max(fastest_squared, v[0] * v[0] + across_squared);
        beside_squared = std::max(beside_squared, along * along + across_squared);
        particles_.vx[i] = rate * particles_.y[i] + v[0];
        particles_.vy[i] = v[1];
        particles_.vz[i] = v[2];
        particles_.wx[i] = v[3] / films_.length_unit;
        particles_.wy[i] = v[4] / films_.length_unit;
        particles_.wz[i] = v[5] / films_.length_unit - 0.5 * rate;
        // The mean flow is integrated with the height in the middle of the step.
        particles_.x[i] += step * (rate * (particles_.y[i] + 0.5 * step * v[1]) + v[0]);
        particles_.y[i] += step * v[1];
        particles_.z[i] += step * v[2];
    }
    fastest_ = std::sqrt(beside_squared);
    farthest_moved_ = step * std::sqrt(fastest_squared);

    const double per_volume = 1.0 / box_.volume();
    const auto shear = [&](const particles::Virial& v) {
        return -0.5 * (v[1] + v[3]) * per_volume;
    };
    StressSample s;
    s.time = time_ + 0.5 * step;
    s.duration = step;
    s.shear_rate = rate;
    s.bulk.fluid = input_.viscosity * rate;
    const double stresslets = profile_
                                  ? profile_->mean_stresslet()
                                  : 2.5 * particles_.total_volume() * per_volume * s.bulk.fluid;
    s.bulk.hydrodynamic = stresslets + shear(film) + wall_couple * per_volume;
    s.bulk.contact = shear(contact);
    s.bulk.colloid = shear(colloid);
    const auto diagonal = [&](std::size_t k) {
        return -(film[k] + contact[k] + colloid[k]) * per_volume;
    };
    s.first_normal_difference = diagonal(0) - diagonal(4);
    s.second_normal_difference = diagonal(4) - diagonal(8);
    s.particle_pressure = -(diagonal(0) + diagonal(4) + diagonal(8)) / 3.0;
    s.contact_number = static_cast<double>(2 * sums_.contacts + wall_sums_.contacts) /
                       static_cast<double>(particles_.size());
    s.wall = s.bulk;
    if (profile_) {
        const double area = box_.length_x * box_.length_z;
        const WallShear wall = profile_->wall_shear(motion_);
        s.wall = {.fluid = wall.viscous,
                  .hydrodynamic = wall.hydrodynamic() - on_upper.hydrodynamic / area,
                  .contact = -on_upper.contact / area};
    }
    return s;
}

std::vector<double> OverdampedMotion::fluid_velocity() const {
    return profile_ ? profile_->velocity() : std::vector<double>{};
}

void OverdampedMotion::save(Checkpoint& into) const {
    put_particles(into, particles_, box_, list_, counts_);
    std::vector<double> velocities;
    for (std::size_t i = 0; i < particles_.size(); ++i)
        velocities.insert(velocities.end(), motion_[i].begin(), motion_[i].end());
    into.put("velocities", velocities);
    if (profile_)
        into.put("fluid_velocity", profile_->velocity());
    into.put("motion", std::vector<double>{time_, step_, fastest_, fastest_closing_});
}

void OverdampedMotion::restore(const Checkpoint& from) {
    get_particles(from, particles_, box_, list_, counts_);
    const std::vector<double>& velocities = from.column("velocities");
    for (std::size_t i = 0; i < particles_.size(); ++i)
        for (std::size_t c = 0; c < 8; ++c)
            motion_[i][c] = velocities.at(8 * i + c);
    if (profile_)
        profile_->restore(from.column("fluid_velocity"));
    const std::vector<double>& motion = from.column("motion");
    time_ = motion.at(0);
    step_ = motion.at(1);
    fastest_ = motion.at(2);
    fastest_closing_ = motion.at(3);
}

void OverdampedMotion::check_places() const {
    check_overlaps(sums_, wall_sums_, particles_, input_.settings, time_);
    // Without contacts nothing but the film, which roughness lets through, keeps them inside.
    for (std::size_t i = 0; box_.walls && i < particles_.size(); ++i)
        if (!(particles_.y[i] > 0.0 && particles_.y[i] < box_.length_y))
            throw StepFailure(fmt::format("particle {} went through a wall at t = {:.6g} s: "
                                          "particles.contact keeps particles between walls",
                                          particles_.id[i], time_));
}

StressSample OverdampedMotion::advance(const WallSpeed& speed, double until) {
    const double start_rate = speed(time_ + 1e-12 * (until - time_)) / box_.length_y;
    double step = choose_step(std::abs(start_rate));
    // From rest nothing but the rate at the end tells how far a step goes.
    const double end_rate = speed(std::min(time_ + step, until)) / box_.length_y;
    if (std::abs(end_rate) > std::abs(start_rate))
        step = choose_step(std::abs(end_rate));
    const double steps = std::ceil((until - time_) / step * (1.0 - 1e-9));
    const bool ends = steps < 1.5;
    if (steps < 2.5)
        step = (until - time_) / std::max(steps, 1.0);
    const double rate = 0.5 * (start_rate + speed(std::min(time_ + step, until)) / box_.length_y);
    box_.set_shear_rate(rate);
    step_ = step;
    sums_ = gather_near_pairs(particles_, box_, list_, films_, contact_, colloid_, step, pairs_);
    wall_sums_ = box_.walls
                     ? gather_wall_pairs(particles_, box_, list_, films_, contact_, step, pairs_)
                     : particles::WallSums{};
    check_places();
    solve(rate);
    const StressSample result = move(step, rate);
    box_.advance(step);
    time_ = ends ? until : time_ + step;
    ++counts_.steps;
    counts_.shortest_step = counts_.steps == 1 ? step : std::min(counts_.shortest_step, step);
    counts_.longest_step = std::max(counts_.longest_step, step);
    if (list_.is_stale_after(particles_, farthest_moved_, rate * step)) {
        // The warm start follows the particles into their new order.
        particles::Column columns[6];
        std::vector<particles::Column*> companions;
        for (std::size_t c = 0; c < 6; ++c) {
            columns[c].resize(particles_.size());
            for (std::size_t i = 0; i < particles_.size(); ++i)
                columns[c][i] = motion_[i][c];
            companions.push_back(&columns[c]);
        }
        list_.rebuild(particles_, box_, companions);
        for (std::size_t c = 0; c < 6; ++c)
            for (std::size_t i = 0; i < particles_.size(); ++i)
                motion_[i][c] = columns[c][i];
        ++counts_.rebuilds;
    }
    return result;
}

} // namespace searle::solvers::suspension
