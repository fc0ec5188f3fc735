#include "solvers/particles/packing.hpp"

#include "solvers/particles/neighbour_list.hpp"
#include "solvers/particles/pair_vector.hpp"
#include "solvers/particles/random_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace searle::solvers::particles {
namespace {

constexpr int most_sweeps = 20000;
constexpr int patience = 500; ///< sweeps within which the largest overlap must fall by 30 %

double volume_of(double radius) { return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius; }

/// Pushes of every overlapping pair and wall, each half of what would part it; the largest overlap
/// relative to the sum of the radii.
double push_apart(ParticleStore& p, const ShearBox& box, const NeighbourList& list) {
    std::fill(p.fx.begin(), p.fx.end(), 0.0);
    std::fill(p.fy.begin(), p.fy.end(), 0.0);
    std::fill(p.fz.begin(), p.fz.end(), 0.0);
    const NearestImage nearest(box);
    double worst = 0.0;
    for (std::size_t k = 0; k < list.size(); ++k) {
        const auto i = static_cast<std::size_t>(list.first[k]);
        const auto j = static_cast<std::size_t>(list.second[k]);
        const PairVector between(p, nearest, i, j);
        const double contact = p.radius[i] + p.radius[j];
        const double squared = between.squared_length();
        if (squared >= contact * contact)
            continue;
        const double r = std::max(std::sqrt(squared), 1e-6 * contact);
        const double overlap = contact - r;
        worst = std::max(worst, overlap / contact);
        const double push = 0.5 * overlap / r;
        p.fx[i] -= push * between.x;
        p.fy[i] -= push * between.y;
        p.fz[i] -= push * between.z;
        p.fx[j] += push * between.x;
        p.fy[j] += push * between.y;
        p.fz[j] += push * between.z;
    }
    for (std::size_t i = 0; box.walls && i < p.size(); ++i) {
        const double below = p.radius[i] - p.y[i];
        const double above = p.y[i] - (box.length_y - p.radius[i]);
        worst = std::max({worst, 0.5 * below / p.radius[i], 0.5 * above / p.radius[i]});
        if (below > 0.0)
            p.fy[i] += below;
        if (above > 0.0)
            p.fy[i] -= above;
    }
    return worst;
}

/// Moves along the pushes with inertia (FIRE, Bitzek et al. 2006, Phys. Rev. Lett. 97, 170201).
class Relaxation {
public:
    double step(ParticleStore& p) {
        double power = 0.0;
        double force = 0.0;
        double speed = 0.0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            power += p.fx[i] * p.vx[i] + p.fy[i] * p.vy[i] + p.fz[i] * p.vz[i];
            force += p.fx[i] * p.fx[i] + p.fy[i] * p.fy[i] + p.fz[i] * p.fz[i];
            speed += p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i] + p.vz[i] * p.vz[i];
        }
        if (power > 0.0) {
            if (++downhill_ > 5) {
                step_ = std::min(1.1 * step_, 0.9);
                mixing_ *= 0.99;
            }
        } else {
            downhill_ = 0;
            step_ = std::max(0.5 * step_, 0.05);
            mixing_ = 0.1;
        }
        const double keep = power > 0.0 ? 1.0 - mixing_ : 0.0;
        const double along = power > 0.0 && force > 0.0 ? mixing_ * std::sqrt(speed / force) : 0.0;
        double largest = 0.0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            p.vx[i] = keep * p.vx[i] + (along + step_) * p.fx[i];
            p.vy[i] = keep * p.vy[i] + (along + step_) * p.fy[i];
            p.vz[i] = keep * p.vz[i] + (along + step_) * p.fz[i];
            // A particle jumps by no more than a tenth of its size.
            const double size =
                std::sqrt(p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i] + p.vz[i] * p.vz[i]) * step_;
            const double share = std::min(1.0, 0.2 * p.radius[i] / std::max(size, 1e-300));
            p.x[i] += share * step_ * p.vx[i];
            p.y[i] += share * step_ * p.vy[i];
            p.z[i] += share * step_ * p.vz[i];
            largest = std::max(largest, share * size);
        }
        return largest;
    }

private:
    double step_ = 0.3;
    double mixing_ = 0.1;
    int downhill_ = 0;
};

/// Relaxes until nothing overlaps by more than `tolerance`, or the sweeps are used up.
void relax(ParticleStore& p, ShearBox& box, double tolerance) {
    NeighbourList list(0.0, 0.3 * p.largest_radius());
    list.rebuild(p, box);
    Relaxation relaxation;
    double smallest = 1.0;
    double before = 1.0;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        const double worst = push_apart(p, box, list);
        if (worst <= tolerance)
            return;
        // A jammed packing no longer gets better.
        smallest = std::min(smallest, worst);
        if (sweep % patience == patience - 1) {
            if (smallest > 0.7 * before)
                return;
            before = smallest;
        }
        if (list.is_stale_after(p, relaxation.step(p), 0.0))
            list.rebuild(p, box);
    }
}

void set_radii(ParticleStore& p, const std::vector<double>& radii, double addition) {
    for (std::size_t i = 0; i < p.size(); ++i)
        p.radius[i] = radii[static_cast<std::size_t>(p.id[i])] + addition;
}

/// Largest overlap relative to the sum of the radii.
double overlap_left(ParticleStore& p, ShearBox& box) {
    NeighbourList list(0.0, 0.1 * p.largest_radius());
    list.rebuild(p, box);
    return push_apart(p, box, list);
}

} // namespace

std::vector<double> radii_for(const PackingRequest& request, const ShearBox& box) {
    std::vector<double> radii;
    const double target = request.volume_fraction * box.volume();
    double filled = 0.0;
    double carried = 0.0;
    std::uint64_t draw = 0;
    for (const SizeShare& size : request.sizes) {
        const double wanted = size.share * target + carried;
        double here = 0.0;
        while (true) {
            double radius = 0.5 * size.diameter;
            if (request.spread > 0.0)
                radius *= std::exp(request.spread * normal(request.seed ^ 0x73697a65ULL, draw++));
            // A hair of tolerance, so that round-off does not cost a particle.
            if (here + volume_of(radius) > wanted * (1.0 + 1e-12))
                break;
            here += volume_of(radius);
            radii.push_back(radius);
        }
        carried = wanted - here;
        filled += here;
    }
    std::sort(radii.begin(), radii.end(), std::greater<>());
    return radii;
}

ParticleStore random_packing(const PackingRequest& request, ShearBox box) {
    const std::vector<double> radii = radii_for(request, box);
    ParticleStore p;
    if (radii.empty())
        return p;
    const double largest = radii.front();
    for (std::size_t i = 0; i < radii.size(); ++i) {
        const double low = box.walls ? radii[i] : 0.0;
        const double room = box.length_y - 2.0 * low;
        p.add(box.length_x * uniform(request.seed, 3 * i),
              low + room * uniform(request.seed, 3 * i + 1),
              box.length_z * uniform(request.seed, 3 * i + 2), radii[i], 1.0);
    }
    // Room is kept around each particle where there is room to keep.
    const double fraction = p.total_volume() / box.volume();
    const double most_growth = std::cbrt(0.60 / fraction);
    const double addition =
        std::clamp(0.5 * request.gap, 0.0, std::max(0.0, (most_growth - 1.0) * largest));
    double left = 1.0;
    for (const double share : {1.0, 0.5, 0.1, 0.0}) {
        const double kept = share > 0.0 ? std::max(share * addition, 1e-3 * largest) : 0.0;
        set_radii(p, radii, kept);
        for (Column* column : {&p.vx, &p.vy, &p.vz})
            std::fill(column->begin(), column->end(), 0.0);
        relax(p, box, std::max(0.3 * kept / (largest + kept), 1e-9));
        set_radii(p, radii, 0.0);
        left = overlap_left(p, box);
        if (left <= 1e-8)
            break;
    }
    if (left > 1e-6) {
        const double reached = fraction * std::pow(1.0 - left, 3);
        throw PackingError(fmt::format("no packing without overlap was found at a volume fraction "
                                       "of {:.4g}; it reached {:.3g}",
                                       fraction, reached),
                           reached);
    }
    for (Column* column : {&p.vx, &p.vy, &p.vz, &p.fx, &p.fy, &p.fz})
        std::fill(column->begin(), column->end(), 0.0);
    for (std::size_t i = 0; i < p.size(); ++i)
        p.mass[i] = request.density * p.volume(i);
    return p;
}

} // namespace searle::solvers::particles
