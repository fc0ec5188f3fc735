#include "solvers/suspension/microstructure.hpp"

#include "solvers/particles/local_volumes.hpp"
#include "solvers/particles/neighbour_list.hpp"
#include "solvers/particles/pair_vector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace searle::solvers::suspension {
namespace {

using particles::ParticleStore;
using particles::ShearBox;

constexpr double snapshots_a_local_one = 10.0;

double mean_diameter(const ParticleStore& particles) {
    double sum = 0.0;
    for (const double radius : particles.radius)
        sum += 2.0 * radius;
    return sum / static_cast<double>(particles.size());
}

/// Volume of a sphere's part below a plane at `height` over its centre.
double volume_below(double radius, double height) {
    const double h = std::clamp(height, -radius, radius) + radius;
    return std::numbers::pi * h * h * (radius - h / 3.0);
}

/// Volume of a shell of radius r ... r + dr, per dr, of which only heights between two planes
/// count, averaged over centres evenly between them: 4 pi r^2 (1 - r / (2 H)) up to r = H, then
/// 2 pi r H.
double shell_between_planes(double r, double height) {
    return r < height ? 4.0 * std::numbers::pi * r * r * (1.0 - 0.5 * r / height)
                      : 2.0 * std::numbers::pi * r * height;
}

} // namespace

void Microstructure::add(const ParticleStore& particles, const ShearBox& box,
                         std::span<const double> fluid_velocity) {
    if (std::fmod(snapshots_, snapshots_a_local_one) == 0.0)
        add_local_fractions(particles, box);
    snapshots_ += 1.0;
    particles_ = static_cast<double>(particles.size());
    count_pairs(particles, box);
    add_slices(particles, box);
    for (std::size_t k = 0; k < slices && fluid_velocity.size() > 1; ++k) {
        const double at = (static_cast<double>(k) + 0.5) / slices *
                          static_cast<double>(fluid_velocity.size() - 1);
        const auto below = std::min(static_cast<std::size_t>(at), fluid_velocity.size() - 2);
        const double share = at - static_cast<double>(below);
        fluid_[k] += (1.0 - share) * fluid_velocity[below] + share * fluid_velocity[below + 1];
    }
    if (fluid_velocity.size() < 2)
        fluid_.fill(std::numeric_limits<double>::quiet_NaN());
}

/// Works on copies: the list brings the particles into an order of its own.
void Microstructure::count_pairs(ParticleStore particles, ShearBox box) {
    const double diameter = mean_diameter(particles);
    const double least = 2.0 * *std::ranges::min_element(particles.radius);
    const double most = 2.0 * particles.largest_radius();
    const double period =
        std::min({box.length_x, box.length_z, box.walls ? box.length_x : box.length_y});
    const double whole = std::min(furthest * diameter, 0.5 * period);
    const double skin = 1e-3 * diameter;
    // Centres up to least + reach apart are known, whoever they are.
    const double reach = std::max(0.0, std::min(whole - least, 0.5 * period - most - 2.0 * skin));
    reach_ = (least + reach) / diameter;
    particles::NeighbourList list(reach, skin);
    list.rebuild(particles, box);
    const particles::NearestImage nearest(box);
    std::vector<int> partners(particles.size(), 0);
    for (std::size_t k = 0; k < list.size(); ++k) {
        const auto i = static_cast<std::size_t>(list.first[k]);
        const auto j = static_cast<std::size_t>(list.second[k]);
        const particles::PairVector between(particles, nearest, i, j);
        const double distance = std::sqrt(between.squared_length());
        if (distance < particles.radius[i] + particles.radius[j]) {
            ++partners[i];
            ++partners[j];
        }
        const auto bin = static_cast<std::size_t>(distance / diameter / bin_width);
        if (bin < bins)
            (between.x * between.y * box.shear_rate < 0.0 ? pressed_ : pulled_)[bin] += 1.0;
    }
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (box.walls)
            partners[i] += (particles.y[i] < particles.radius[i]) +
                           (particles.y[i] > box.length_y - particles.radius[i]);
        contacts_[std::min(static_cast<std::size_t>(partners[i]), most_contacts)] += 1.0;
    }
    const double height = box.walls ? box.length_y - diameter : box.length_y;
    const double density = particles_ / (box.length_x * height * box.length_z);
    for (std::size_t k = 0; k < bins; ++k) {
        const double r = (static_cast<double>(k) + 0.5) * bin_width * diameter;
        const double shell =
            box.walls ? shell_between_planes(r, height) : 4.0 * std::numbers::pi * r * r;
        even_[k] += 0.5 * particles_ * density * shell * bin_width * diameter;
    }
}

void Microstructure::add_slices(const ParticleStore& particles, const ShearBox& box) {
    const double thickness = box.length_y / static_cast<double>(slices);
    const double slice_volume = box.length_x * box.length_z * thickness;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double radius = particles.radius[i];
        const double y = particles.y[i];
        const auto lowest = static_cast<long>(std::floor((y - radius) / thickness));
        const auto highest = static_cast<long>(std::floor((y + radius) / thickness));
        for (long k = lowest; k <= highest; ++k) {
            const double bottom = static_cast<double>(k) * thickness;
            const double part =
                volume_below(radius, bottom + thickness - y) - volume_below(radius, bottom - y);
            constexpr auto count = static_cast<long>(slices);
            const long turns = k >= 0 ? k / count : -((count - 1 - k) / count);
            // Through a wall by less than the contact's overlap; through a period as its image.
            const long inside = box.walls ? std::clamp(k, 0L, count - 1) : k - turns * count;
            const double speed =
                particles.vx[i] - (box.walls ? 0.0 : static_cast<double>(turns) * box.image_speed);
            volume_[static_cast<std::size_t>(inside)] += part / slice_volume;
            flux_[static_cast<std::size_t>(inside)] += part / slice_volume * speed;
        }
    }
}

void Microstructure::add_local_fractions(const ParticleStore& particles, const ShearBox& box) {
    const std::vector<double> volumes = particles::local_volumes(particles, box);
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        const double own = 4.0 / 3.0 * std::numbers::pi * std::pow(particles.radius[i], 3);
        // A cell that overlapping spheres cover has no volume.
        const double fraction = own / std::max(volumes[i], own);
        const auto bin = static_cast<std::size_t>(fraction * static_cast<double>(fractions));
        local_[std::min(bin, fractions - 1)] += 1.0;
    }
}

std::vector<Microstructure::PairBin> Microstructure::pair_distribution() const {
    std::vector<PairBin> found;
    for (std::size_t k = 0; k < bins; ++k) {
        const double end = static_cast<double>(k + 1) * bin_width;
        if (end > reach_ + 1e-9)
            break;
        found.push_back({.distance = end - 0.5 * bin_width,
                         .all = (pressed_[k] + pulled_[k]) / even_[k],
                         .pressed = 2.0 * pressed_[k] / even_[k],
                         .pulled = 2.0 * pulled_[k] / even_[k]});
    }
    return found;
}

std::vector<Microstructure::Slice> Microstructure::profile() const {
    std::vector<Slice> found;
    for (std::size_t k = 0; k < slices; ++k)
        found.push_back({.height = (static_cast<double>(k) + 0.5) / slices,
                         .volume_fraction = volume_[k] / snapshots_,
                         .particle_velocity = volume_[k] > 0.0
                                                  ? flux_[k] / volume_[k]
                                                  : std::numeric_limits<double>::quiet_NaN(),
                         .fluid_velocity = fluid_[k] / snapshots_});
    return found;
}

std::array<double, Microstructure::fractions> Microstructure::local_fraction_shares() const {
    std::array<double, fractions> shares = local_;
    const double all = std::accumulate(local_.begin(), local_.end(), 0.0);
    for (double& share : shares)
        share /= all;
    return shares;
}

std::array<double, Microstructure::most_contacts + 1> Microstructure::contact_shares() const {
    std::array<double, most_contacts + 1> shares = contacts_;
    for (double& share : shares)
        share /= snapshots_ * particles_;
    return shares;
}

double Microstructure::contact_number() const {
    const auto shares = contact_shares();
    double sum = 0.0;
    for (std::size_t k = 0; k < shares.size(); ++k)
        sum += static_cast<double>(k) * shares[k];
    return sum;
}

template <class Self, class Visit>
void Microstructure::visit(Self& self, Visit visit) {
    for (auto* number : {&self.snapshots_, &self.particles_, &self.reach_})
        visit(*number);
    for (auto& number : self.local_)
        visit(number);
    for (auto* column : {&self.pressed_, &self.pulled_, &self.even_})
        for (auto& number : *column)
            visit(number);
    for (auto& number : self.contacts_)
        visit(number);
    for (auto* column : {&self.volume_, &self.flux_, &self.fluid_})
        for (auto& number : *column)
            visit(number);
}

std::vector<double> Microstructure::numbers() const {
    std::vector<double> all;
    visit(*this, [&all](double number) { all.push_back(number); });
    return all;
}

Microstructure Microstructure::from(std::span<const double> numbers) {
    Microstructure restored;
    if (numbers.size() != restored.numbers().size())
        throw std::invalid_argument("these are not the numbers of a microstructure");
    std::size_t next = 0;
    visit(restored, [&](double& number) {
        number = numbers[next];
        ++next;
    });
    return restored;
}

} // namespace searle::solvers::suspension
