#include "solvers/suspension/fluid_profile.hpp"

#include <algorithm>
#include <cmath>

namespace searle::solvers::suspension {

using particles::Column;
using particles::ParticleStore;
using particles::Surroundings;

namespace {

/// Impulse of the fluid on particle i within a step, less coupling * (fluid velocity there).
double rest_of_impulse(const ParticleStore& p, const Surroundings& s, const Column& forces_x,
                       std::size_t i, double coupling, double step) {
    return coupling * ((forces_x[i] + s.viscous_x[i]) / s.drag[i] - p.vx[i]) - forces_x[i] * step;
}

} // namespace

FluidProfile::FluidProfile(const ProfileOptions& options)
    : options_(options), elements_(options.gap, options.cells) {
    const auto nodes = static_cast<std::size_t>(options.cells) + 1;
    for (std::vector<double>* column : {&velocity_, &fraction_, &viscous_force_, &drag_diagonal_,
                                        &drag_beside_, &drag_load_, &predicted_})
        column->assign(nodes, 0.0);
    element_fraction_.assign(nodes - 1, 0.0);
    couple_.assign(nodes - 1, 0.0);
}

void FluidProfile::set_uniform_shear(double wall_speed) {
    velocity_ = elements_.uniform_shear(wall_speed);
}

void FluidProfile::gather_fractions(const ParticleStore& p) {
    std::fill(fraction_.begin(), fraction_.end(), 0.0);
    std::fill(element_fraction_.begin(), element_fraction_.end(), 0.0);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto [e, upper] = elements_.place(p.y[i]);
        const double volume = p.volume(i);
        fraction_[e] += (1.0 - upper) * volume;
        fraction_[e + 1] += upper * volume;
        element_fraction_[e] += volume;
    }
    const double cell = elements_.spacing * options_.wall_area;
    for (std::size_t k = 0; k < fraction_.size(); ++k) {
        const bool at_wall = k == 0 || k + 1 == fraction_.size();
        // Round-off aside a plane cannot hold more than the densest packing.
        fraction_[k] = std::min(fraction_[k] / (at_wall ? 0.5 * cell : cell), 0.74);
    }
    for (double& fraction : element_fraction_)
        fraction /= cell;
}

void FluidProfile::assemble(const ParticleStore& p, Surroundings& s, const Column& forces_x,
                            double step) {
    std::fill(drag_diagonal_.begin(), drag_diagonal_.end(), 0.0);
    std::fill(drag_beside_.begin(), drag_beside_.end(), 0.0);
    std::fill(drag_load_.begin(), drag_load_.end(), 0.0);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto [e, upper] = elements_.place(p.y[i]);
        const double lower = 1.0 - upper;
        // Impulse of the drag in the step to come: K u + rest, u the fluid's velocity there.
        const double coupling = -p.mass[i] * std::expm1(-step * s.drag[i] / p.mass[i]);
        const double rest = rest_of_impulse(p, s, forces_x, i, coupling, step);
        drag_diagonal_[e] += coupling * lower * lower;
        drag_beside_[e] += coupling * lower * upper;
        drag_diagonal_[e + 1] += coupling * upper * upper;
        // What the steps since the last exchange gave beyond the prediction follows now.
        const double load = rest + s.impulse_x[i];
        drag_load_[e] += lower * load;
        drag_load_[e + 1] += upper * load;
        s.impulse_x[i] = 0.0;
    }
    for (std::size_t k = 0; k < predicted_.size(); ++k)
        drag_load_[k] -= predicted_[k];
    if (!options_.stresslets)
        return;
    std::fill(couple_.begin(), couple_.end(), 0.0);
    const double cell = elements_.spacing * options_.wall_area;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto [e, upper] = elements_.place(p.y[i]);
        const double spin = -0.5 * (velocity_[e + 1] - velocity_[e]) / elements_.spacing;
        couple_[e] -= s.rotational_drag[i] * (spin - p.wz[i]) / cell;
    }
}

WallShear FluidProfile::advance(const ParticleStore& p, Surroundings& s, const Column& forces_x,
                                double step, double wall_speed) {
    assemble(p, s, forces_x, step);
    const std::size_t last = velocity_.size() - 1;
    const double area = options_.wall_area;
    const double per_spacing = area / elements_.spacing;
    const auto inertia = [&](std::size_t k) {
        const double share = k == 0 || k == last ? 0.5 : 1.0;
        return share * options_.density * (1.0 - fraction_[k]) * elements_.spacing * area;
    };
    const auto stiffness = [&](std::size_t e) {
        const double particles = options_.stresslets ? 2.5 * element_fraction_[e] : 0.0;
        return options_.viscosity * (1.0 + particles) * per_spacing;
    };
    // Half the couple is shear stress: a body couple c is the force curl c / 2.
    const auto couple = [&](std::size_t e) { return 0.5 * couple_[e] * area; };

    const std::vector<double> before = velocity_;
    velocity_[0] = 0.0;
    velocity_[last] = wall_speed;
    // Thomas' algorithm over the nodes inside.
    std::vector<double> ratio(last + 1, 0.0);
    std::vector<double> reduced(last + 1, 0.0);
    reduced[0] = velocity_[0];
    for (std::size_t k = 1; k < last; ++k) {
        const double diagonal =
            inertia(k) + step * (stiffness(k - 1) + stiffness(k)) + drag_diagonal_[k];
        const double below = -step * stiffness(k - 1) + drag_beside_[k - 1];
        const double above = -step * stiffness(k) + drag_beside_[k];
        const double load =
            inertia(k) * before[k] - drag_load_[k] + step * (couple(k) - couple(k - 1));
        const double pivot = diagonal + below * ratio[k - 1];
        ratio[k] = -above / pivot;
        reduced[k] = (load - below * reduced[k - 1]) / pivot;
    }
    for (std::size_t k = last; k-- > 1;)
        velocity_[k] = reduced[k] + ratio[k] * velocity_[k + 1];

    const auto drag_at = [&](std::size_t k) {
        double impulse = drag_load_[k] + drag_diagonal_[k] * velocity_[k];
        if (k > 0)
            impulse += drag_beside_[k - 1] * velocity_[k - 1];
        if (k < last)
            impulse += drag_beside_[k] * velocity_[k + 1];
        return impulse;
    };
    std::vector<double> impulses(last + 1);
    for (std::size_t k = 0; k <= last; ++k)
        impulses[k] = drag_at(k);
    for (std::size_t k = 1; k < last; ++k)
        viscous_force_[k] = options_.viscosity * per_spacing *
                            (velocity_[k + 1] - 2.0 * velocity_[k] + velocity_[k - 1]);
    WallShear wall;
    const double slope = (velocity_[last] - velocity_[last - 1]) / elements_.spacing;
    wall.viscous = options_.viscosity * slope +
                   inertia(last) * (velocity_[last] - before[last]) / (step * area);
    wall.stresslet =
        (stiffness(last - 1) / per_spacing - options_.viscosity) * slope + couple(last - 1) / area;
    wall.drag = impulses[last] / (step * area);
    const double lower_slope = (velocity_[1] - velocity_[0]) / elements_.spacing;
    const double lower = -(stiffness(0) / per_spacing * lower_slope * area + couple(0)) * step +
                         inertia(0) * (velocity_[0] - before[0]) + impulses[0];
    wall_impulse_ += (wall.viscous + wall.stresslet + wall.drag) * area * step + lower;
    for (std::size_t k = 0; k <= last; ++k)
        momentum_gained_ += inertia(k) * (velocity_[k] - before[k]);

    // The impulses without what was owed: the prediction that the next step compares with.
    for (std::size_t k = 0; k <= last; ++k)
        predicted_[k] = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto [e, upper] = elements_.place(p.y[i]);
        const double coupling = -p.mass[i] * std::expm1(-step * s.drag[i] / p.mass[i]);
        const double flow = velocity_[e] + upper * (velocity_[e + 1] - velocity_[e]);
        const double impulse = coupling * flow + rest_of_impulse(p, s, forces_x, i, coupling, step);
        predicted_[e] += (1.0 - upper) * impulse;
        predicted_[e + 1] += upper * impulse;
    }
    return wall;
}

void FluidProfile::interpolate_mixture(const ParticleStore& p, Surroundings& s,
                                       Column& fluid_fraction) const {
    const double cell = elements_.spacing * options_.wall_area;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto [e, upper] = elements_.place(p.y[i]);
        const double force =
            viscous_force_[e] + upper * (viscous_force_[e + 1] - viscous_force_[e]);
        s.viscous_x[i] = options_.model_a ? p.volume(i) * force / cell : 0.0;
        fluid_fraction[i] = 1.0 - (fraction_[e] + upper * (fraction_[e + 1] - fraction_[e]));
    }
}

void FluidProfile::interpolate_flow(const ParticleStore& p, Surroundings& s) const {
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto [e, upper] = elements_.place(p.y[i]);
        const double rise = velocity_[e + 1] - velocity_[e];
        s.flow_x[i] = velocity_[e] + upper * rise;
        s.spin_z[i] = -0.5 * rise / elements_.spacing;
    }
}

double FluidProfile::mean_stresslet() const {
    if (!options_.stresslets)
        return 0.0;
    double sum = 0.0;
    for (std::size_t e = 0; e < element_fraction_.size(); ++e)
        sum += 2.5 * element_fraction_[e] * options_.viscosity * (velocity_[e + 1] - velocity_[e]) /
                   elements_.spacing +
               0.5 * couple_[e];
    return sum / options_.cells;
}

FluidProfile::State FluidProfile::state() const {
    return {velocity_, viscous_force_, couple_, predicted_, momentum_gained_, wall_impulse_};
}

void FluidProfile::restore(const State& state) {
    velocity_ = state.velocity;
    viscous_force_ = state.viscous_force;
    couple_ = state.couple;
    predicted_ = state.predicted;
    momentum_gained_ = state.momentum_gained;
    wall_impulse_ = state.wall_impulse;
}

} // namespace searle::solvers::suspension
