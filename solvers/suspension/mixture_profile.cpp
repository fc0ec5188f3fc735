#include "solvers/suspension/mixture_profile.hpp"

#include <algorithm>
#include <cmath>

namespace searle::solvers::suspension {

MixtureProfile::MixtureProfile(const MixtureProfileOptions& options)
    : options_(options), elements_(options.gap, options.cells) {
    const auto nodes = static_cast<std::size_t>(options.cells) + 1;
    for (std::vector<double>* column : {&pivot_, &ratio_, &load_, &scratch_, &beside_, &velocity_})
        column->assign(nodes, 0.0);
    fraction_.assign(nodes - 1, 0.0);
}

void MixtureProfile::set_uniform_shear(double wall_speed) {
    velocity_ = elements_.uniform_shear(wall_speed);
}

void MixtureProfile::prepare(const particles::ParticleStore& p, const particles::Column& drag,
                             const particles::Column& turning_drag, double shear_rate,
                             double step) {
    shear_rate_ = shear_rate;
    drag_ = &drag;
    turning_drag_ = &turning_drag;
    place_.resize(p.size());
    const std::size_t last = velocity_.size() - 1;
    const double spacing = elements_.spacing;
    const double area = options_.wall_area;
    const double turn = 0.5 * options_.length_unit / spacing;
    std::vector<double> diagonal(last + 1, 0.0);
    std::vector<double> above(last, 0.0); // between a node and the next
    std::vector<double> excess(last + 1, 0.0);
    std::fill(fraction_.begin(), fraction_.end(), 0.0);
    for (std::size_t i = 0; i < p.size(); ++i) {
        place_[i] = elements_.place(p.y[i]);
        const auto [e, upper] = place_[i];
        const double lower = place_[i].lower();
        fraction_[e] += p.volume(i) / (spacing * area);
        const double mass = p.mass[i] - options_.density * p.volume(i);
        excess[e] += lower * mass;
        excess[e + 1] += upper * mass;
        const double couple = turning_drag[i] * turn * turn;
        diagonal[e] += drag[i] * lower * lower + couple;
        above[e] += drag[i] * lower * upper - couple;
        diagonal[e + 1] += drag[i] * upper * upper + couple;
    }
    std::fill(load_.begin(), load_.end(), 0.0);
    for (std::size_t e = 0; e < last; ++e) {
        const double stiffness = options_.viscosity * (1.0 + 2.5 * fraction_[e]) * area / spacing;
        diagonal[e] += stiffness;
        above[e] -= stiffness;
        diagonal[e + 1] += stiffness;
        // K times the mean shear: nothing but for a viscosity that varies.
        const double force = options_.viscosity * 2.5 * fraction_[e] * shear_rate * area;
        load_[e] += force;
        load_[e + 1] -= force;
    }
    for (std::size_t k = 0; k <= last; ++k) {
        const double fluid = options_.density * spacing * area * (k == 0 || k == last ? 0.5 : 1.0);
        // Whole particles at their centres: no plane holds more of them than the densest packing.
        constexpr double densest = 0.74;
        const double mass = fluid + std::max(excess[k], -densest * fluid);
        const double rise = shear_rate * spacing * static_cast<double>(k) - velocity_[k];
        load_[k] -= mass / step * rise;
        diagonal[k] += mass / step;
        if (k == last)
            wall_inertia_ = mass / step * rise;
    }
    for (std::size_t k = 1; k < last; ++k) {
        pivot_[k] = diagonal[k] - (k > 1 ? ratio_[k - 1] * ratio_[k - 1] * pivot_[k - 1] : 0.0);
        ratio_[k] = above[k] / pivot_[k];
    }
}

void MixtureProfile::solve(std::vector<double>& load) const {
    const std::size_t last = load.size() - 1;
    for (std::size_t k = 2; k < last; ++k)
        load[k] -= ratio_[k - 1] * load[k - 1];
    load[0] = load[last] = 0.0;
    for (std::size_t k = last; k-- > 1;)
        load[k] = load[k] / pivot_[k] - ratio_[k] * load[k + 1];
}

void MixtureProfile::gather(const Motions& motions, std::vector<double>& load) const {
    const double turn = 0.5 * options_.length_unit / elements_.spacing;
    for (std::size_t i = 0; i < place_.size(); ++i) {
        const auto [e, upper] = place_[i];
        const double push = (*drag_)[i] * motions[i][0];
        const double couple = (*turning_drag_)[i] * motions[i][5] * turn;
        load[e] += (1.0 - upper) * push + couple;
        load[e + 1] += upper * push - couple;
    }
}

void MixtureProfile::spread(const std::vector<double>& beside, double factor,
                            Motions& forces) const {
    const double turn = 0.5 * options_.length_unit / elements_.spacing;
    for (std::size_t i = 0; i < place_.size(); ++i) {
        const auto [e, upper] = place_[i];
        const double rise = beside[e + 1] - beside[e];
        forces[i][0] -= factor * (*drag_)[i] * (beside[e] + upper * rise);
        forces[i][5] += factor * (*turning_drag_)[i] * turn * rise;
    }
}

void MixtureProfile::add_load(Motions& forces) {
    scratch_ = load_;
    solve(scratch_);
    spread(scratch_, -1.0, forces);
}

void MixtureProfile::subtract_response(const Motions& motions, Motions& forces) {
    std::fill(scratch_.begin(), scratch_.end(), 0.0);
    gather(motions, scratch_);
    solve(scratch_);
    spread(scratch_, 1.0, forces);
}

void MixtureProfile::follow(const Motions& motions) {
    beside_ = load_;
    gather(motions, beside_);
    solve(beside_);
    for (std::size_t k = 0; k < velocity_.size(); ++k)
        velocity_[k] = beside_[k] + shear_rate_ * elements_.spacing * static_cast<double>(k);
}

double MixtureProfile::velocity_at(std::size_t i) const {
    const auto [e, upper] = place_[i];
    return beside_[e] + upper * (beside_[e + 1] - beside_[e]);
}

double MixtureProfile::steepest_rate() const {
    double steepest = 0.0;
    for (std::size_t e = 0; e < fraction_.size(); ++e)
        steepest =
            std::max(steepest, std::abs(velocity_[e + 1] - velocity_[e]) / elements_.spacing);
    return steepest;
}

WallShear MixtureProfile::wall_shear(const Motions& motions) const {
    const std::size_t last = beside_.size() - 1;
    const double rate = shear_rate_ + (beside_[last] - beside_[last - 1]) / elements_.spacing;
    WallShear wall;
    wall.viscous = options_.viscosity * rate + wall_inertia_ / options_.wall_area;
    wall.stresslet = 2.5 * fraction_[last - 1] * options_.viscosity * rate;
    // The fluid at the wall carries what drag and couples of the last element put on it.
    const double turn = 0.5 * options_.length_unit / elements_.spacing;
    for (std::size_t i = 0; i < place_.size(); ++i) {
        if (place_[i].element != last - 1)
            continue;
        const double spin = -turn * (beside_[last] - beside_[last - 1]);
        wall.drag +=
            place_[i].upper * (*drag_)[i] * (velocity_at(i) - motions[i][0]) / options_.wall_area;
        wall.stresslet -= turn * (*turning_drag_)[i] * (spin - motions[i][5]) / options_.wall_area;
    }
    return wall;
}

double MixtureProfile::mean_stresslet() const {
    double sum = 0.0;
    for (std::size_t e = 0; e < fraction_.size(); ++e)
        sum += 2.5 * fraction_[e] * options_.viscosity *
               (shear_rate_ + (beside_[e + 1] - beside_[e]) / elements_.spacing);
    return sum / options_.cells;
}

} // namespace searle::solvers::suspension
