#include "solvers/suspension/lubrication_pairs.hpp"

#include "laws/lubrication/near_contact.hpp"
#include "laws/lubrication/near_wall.hpp"
#include "solvers/particles/pair_vector.hpp"

#include <algorithm>
#include <cmath>

namespace searle::solvers::suspension {
namespace {

void set_film(const laws::lubrication::Film& film, double length_unit, NearPair& pair) {
    pair.squeeze = pair.film_squeeze = film.squeeze;
    pair.shear = pair.film_shear = film.shear;
    pair.mixed = film.mixed / length_unit;
    pair.pump = film.pump / (length_unit * length_unit);
    pair.twist = film.twist / (length_unit * length_unit);
}

/// Force of the colloid and how much it rises per approach, N and N/m, where it rises.
template <class Colloid>
void add_colloid(const Colloid& colloid, double gap, double r_1, double r_2, NearPair& pair) {
    if constexpr (!std::is_same_v<Colloid, particles::NoColloid>) {
        if (gap >= colloid.cutoff)
            return;
        pair.push += colloid.repulsion(gap, r_1, r_2);
        const double probe = 1e-4 * colloid.minimum_separation + 1e-5 * std::abs(gap);
        const double rise =
            (colloid.repulsion(gap - probe, r_1, r_2) - colloid.repulsion(gap + probe, r_1, r_2)) /
            (2.0 * probe);
        pair.colloid_stiffness = std::max(rise, 0.0);
    }
}

/// Tangential displacement of the second against the first, m.
struct Displacement {
    double x{}, y{}, z{};
};

/// Without inertia a dashpot has nothing to do that the film does not.
template <class Law>
void add_contact(const Law& law, double overlap, double reduced_radius, const Displacement& moved,
                 NearPair& pair) {
    const laws::contact::ContactSpring spring = law.at(overlap, reduced_radius, 0.0);
    pair.touches = true;
    pair.stiffness = spring.slope;
    pair.contact_push = spring.normal * overlap;
    pair.push += pair.contact_push;
    if (law.friction == 0.0)
        return;
    const double along = moved.x * pair.nx + moved.y * pair.ny + moved.z * pair.nz;
    const double stiffness = spring.tangential;
    pair.spring = stiffness;
    pair.tx = -stiffness * (moved.x - along * pair.nx);
    pair.ty = -stiffness * (moved.y - along * pair.ny);
    pair.tz = -stiffness * (moved.z - along * pair.nz);
    const double size = std::sqrt(pair.tx * pair.tx + pair.ty * pair.ty + pair.tz * pair.tz);
    const double limit = law.friction * pair.contact_push;
    pair.tangential_stiffness = stiffness;
    if (size >= limit * (1.0 - 1e-9)) {
        const double share = size > 0.0 ? limit / size : 0.0;
        pair.tx *= share;
        pair.ty *= share;
        pair.tz *= share;
        pair.tangential_stiffness = 0.0;
    }
}

} // namespace

particles::PairSums gather_near_pairs(const particles::ParticleStore& p,
                                      const particles::ShearBox& box,
                                      const particles::NeighbourList& list,
                                      const LubricationSettings& settings,
                                      const std::optional<laws::contact::AnyContact>& contact,
                                      const particles::AnyColloid& colloid, double step,
                                      particles::AlignedVector<NearPair>& pairs) {
    particles::PairSums sums;
    pairs.clear();
    const particles::NearestImage nearest(box);
    const double reach = particles::reach_of(colloid);
    for (std::size_t k = 0; k < list.size(); ++k) {
        const auto i = static_cast<std::size_t>(list.first[k]);
        const auto j = static_cast<std::size_t>(list.second[k]);
        const particles::PairVector between(p, nearest, i, j);
        const double radii = p.radius[i] + p.radius[j];
        const double farthest = radii + std::max(0.5 * settings.farthest_gap * radii, reach);
        const double squared = between.squared_length();
        if (squared >= farthest * farthest)
            continue;
        const double distance = std::sqrt(squared);
        const double gap = distance - radii;
        NearPair pair{};
        pair.first = list.first[k];
        pair.second = list.second[k];
        pair.listed = static_cast<int>(k);
        pair.nx = between.x / distance;
        pair.ny = between.y / distance;
        pair.nz = between.z / distance;
        pair.distance = distance;
        pair.lever_first = distance * p.radius[i] / radii / settings.length_unit;
        pair.lever_second = distance * p.radius[j] / radii / settings.length_unit;
        if (gap < 0.5 * settings.farthest_gap * radii) {
            const double rough = std::max(gap, 0.0) + 0.5 * settings.roughness * radii;
            const laws::lubrication::Film film =
                laws::lubrication::film(rough, p.radius[i], p.radius[j], settings.viscosity,
                                        laws::lubrication::Squeeze::leading);
            set_film(film, settings.length_unit, pair);
        }
        std::visit([&](const auto& law) { add_colloid(law, gap, p.radius[i], p.radius[j], pair); },
                   colloid);
        if (contact && gap < 0.0) {
            std::visit(
                [&](const auto& law) {
                    add_contact(law, -gap, p.radius[i] * p.radius[j] / radii,
                                {list.spring_x[k], list.spring_y[k], list.spring_z[k]}, pair);
                },
                *contact);
            ++sums.contacts;
            if (-gap > sums.largest_overlap) {
                sums.largest_overlap = -gap;
                sums.deepest_first = p.id[i];
                sums.deepest_second = p.id[j];
            }
        }
        // Springs as at the step's end: they resist the motion within it.
        pair.squeeze += step * (pair.stiffness + pair.colloid_stiffness);
        pair.shear += step * pair.tangential_stiffness;
        pairs.push_back(pair);
    }
    return sums;
}

particles::WallSums gather_wall_pairs(const particles::ParticleStore& p,
                                      const particles::ShearBox& box,
                                      const particles::NeighbourList& list,
                                      const LubricationSettings& settings,
                                      const std::optional<laws::contact::AnyContact>& contact,
                                      double step, particles::AlignedVector<NearPair>& pairs) {
    particles::WallSums sums;
    const auto gather = [&](const particles::AlignedVector<int>& near, bool upper,
                            const particles::Column& moved_x, const particles::Column& moved_z) {
        for (const int index : near) {
            const auto i = static_cast<std::size_t>(index);
            const double radius = p.radius[i];
            const double distance = upper ? box.length_y - p.y[i] : p.y[i];
            const double gap = distance - radius;
            if (gap >= settings.farthest_gap * radius)
                continue;
            NearPair pair{};
            pair.first = pair.listed = index;
            pair.second = static_cast<int>(p.size()) + (upper ? 1 : 0);
            pair.ny = upper ? 1.0 : -1.0;
            pair.distance = distance;
            pair.lever_first = distance / settings.length_unit;
            set_film(laws::lubrication::wall_film(std::max(gap, 0.0) + settings.roughness * radius,
                                                  radius, settings.viscosity,
                                                  laws::lubrication::Squeeze::leading),
                     settings.length_unit, pair);
            if (contact && gap < 0.0) {
                std::visit(
                    [&](const auto& law) {
                        add_contact(law, -gap, radius, {moved_x[i], 0.0, moved_z[i]}, pair);
                    },
                    *contact);
                ++sums.contacts;
                if (-gap > sums.largest_overlap) {
                    sums.largest_overlap = -gap;
                    sums.deepest = p.id[i];
                }
            }
            pair.squeeze += step * pair.stiffness;
            pair.shear += step * pair.tangential_stiffness;
            pairs.push_back(pair);
        }
    };
    gather(list.near_lower, false, list.lower_x, list.lower_z);
    gather(list.near_upper, true, list.upper_x, list.upper_z);
    return sums;
}

} // namespace searle::solvers::suspension
