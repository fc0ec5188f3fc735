#include "solvers/suspension/mixture_profile.hpp"

#include <algorithm>

namespace searle::solvers::suspension {

MixtureProfile::MixtureProfile(const MixtureProfileOptions& options)
    : options_(options), spacing_(options.gap / options.cells) {
    const auto nodes = static_cast<std::size_t>(options.cells) + 1;
    for (std::vector<double>* column : {&pivot_, &ratio_, &load_, &scratch_, &beside_, &velocity_})
        column->assign(nodes, 0.0);
    fraction_.assign(nodes - 1, 0.0);
}

void MixtureProfile::set_uniform_shear(double wall_speed) {
    for (std::size_t k = 0; k < velocity_.size(); ++k)
        velocity_[k] = wall_speed * static_cast<double>(k) / options_.cells;
}

void MixtureProfile::prepare(const particles::ParticleStore& p, const particles::Column& drag,
                             const particles::Column& turning_drag, double shear_rate,
                             double step) {
    shear_rate_ = shear_rate;
    drag_ = &drag;
    turning_drag_ = &turning_drag;
    element_.resize(p.size());
    upper_.resize(p.size());
    std::fill(fraction_.begin(), fraction_.end(), 0.0);
    const std::size_t last = beside_.size() - 1;
    std::vector<double> diagonal(last + 1, 0.0);
    std::vector<double> above(last, 0.0); // between a node and the next
    std::vector<double> mass(last + 1, options_.density * spacing_ * options_.wall_area);
    mass.front() *= 0.5;
    mass.back() *= 0.5;
    const double turn = 0.5 * options_.length_unit / spacing_;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double place =
            std::clamp(p.y[i] / spacing_, 0.0, static_cast<double>(options_.cells));
        const int element = std::min(static_cast<int>(place), options_.cells - 1);
        const auto e = static_cast<std::size_t>(element);
        const double upper = place - element;
        const double lower = 1.0 - upper;
        element_[i] = e;
        upper_[i] = upper;
        fraction_[e] += p.volume(i) / (spacing_ * options_.wall_area);
        const double excess = p.mass[i] - options_.density * p.volume(i);
        mass[e] += lower * excess;
        mass[e + 1] += upper * excess;
        const double couple = turning_drag[i] * turn * turn;
        diagonal[e] += drag[i] * lower * lower + couple;
        above[e] += drag[i] * lower * upper - couple;
        diagonal[e + 1] += drag[i] * upper * upper + couple;
    }
    for (std::size_t e = 0; e < last; ++e) {
        const double stiffness =
            options_.viscosity * (1.0 + 2.5 * fraction_[e]) * options_.wall_area / spacing_;
        diagonal[e] += stiffness;
        above[e] -= stiffness;
        diagonal[e + 1] += stiffness;
    }
    // The mean shear in a viscosity that varies, K times a linear velocity; then the inertia.
    std::fill(load_.begin(), load_.end(), 0.0);
    for (std::size_t e = 0; e < last; ++e) {
        const double force =
            options_.viscosity * 2.5 * fraction_[e] * shear_rate * options_.wall_area;
        load_[e] += force;
        load_[e + 1] -= force;
    }
    for (std::size_t k = 0; k <= last; ++k) {
        const double rise = shear_rate * spacing_ * static_cast<double>(k) - velocity_[k];
        load_[k] -= mass[k] / step * rise;
        diagonal[k] += mass[k] / step;
        wall_inertia_ = mass[k] / step * rise; // in the end the last node's
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
    const double turn = 0.5 * options_.length_unit / spacing_;
    for (std::size_t i = 0; i < element_.size(); ++i) {
        const std::size_t e = element_[i];
        const double push = (*drag_)[i] * motions[i][0];
        const double couple = (*turning_drag_)[i] * motions[i][5] * turn;
        load[e] += (1.0 - upper_[i]) * push + couple;
        load[e + 1] += upper_[i] * push - couple;
    }
}

void MixtureProfile::spread(const std::vector<double>& beside, double factor,
                            Motions& forces) const {
    const double turn = 0.5 * options_.length_unit / spacing_;
    for (std::size_t i = 0; i < element_.size(); ++i) {
        const std::size_t e = element_[i];
        const double rise = beside[e + 1] - beside[e];
        forces[i][0] -= factor * (*drag_)[i] * (beside[e] + upper_[i] * rise);
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
        velocity_[k] = beside_[k] + shear_rate_ * spacing_ * static_cast<double>(k);
}

double MixtureProfile::velocity_at(std::size_t i) const {
    const std::size_t e = element_[i];
    return beside_[e] + upper_[i] * (beside_[e + 1] - beside_[e]);
}

WallShear MixtureProfile::wall_shear(const Motions& motions) const {
    const std::size_t last = beside_.size() - 1;
    const double rate = shear_rate_ + (beside_[last] - beside_[last - 1]) / spacing_;
    WallShear wall;
    wall.viscous = options_.viscosity * rate + wall_inertia_ / options_.wall_area;
    wall.stresslet = 2.5 * fraction_[last - 1] * options_.viscosity * rate;
    // The fluid at the wall carries what drag and couples of the last element put on it.
    const double turn = 0.5 * options_.length_unit / spacing_;
    for (std::size_t i = 0; i < element_.size(); ++i) {
        if (element_[i] != last - 1)
            continue;
        const double spin = -turn * (beside_[last] - beside_[last - 1]);
        wall.drag +=
            upper_[i] * (*drag_)[i] * (velocity_at(i) - motions[i][0]) / options_.wall_area;
        wall.stresslet -= turn * (*turning_drag_)[i] * (spin - motions[i][5]) / options_.wall_area;
    }
    return wall;
}

double MixtureProfile::mean_stresslet() const {
    double sum = 0.0;
    for (std::size_t e = 0; e < fraction_.size(); ++e)
        sum += 2.5 * fraction_[e] * options_.viscosity *
               (shear_rate_ + (beside_[e + 1] - beside_[e]) / spacing_);
    return sum / options_.cells;
}

} // namespace searle::solvers::suspension
