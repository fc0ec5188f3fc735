#include "solvers/particles/pair_forces.hpp"

#include "solvers/particles/contact_pairs.hpp"
#include "solvers/particles/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace searle::solvers::particles {
namespace {

constexpr int block = 256;
constexpr std::size_t forces_and_torques = 6;

/// A block of pairs: what the vector loop leaves for the sums over particles.
struct Block {
    alignas(64) double rx[block], ry[block], rz[block]; ///< from the first to the second, m
    alignas(64) double fx[block], fy[block], fz[block]; ///< on the second, N
    alignas(64) double surface[block];                  ///< surface distance, m
};

/// What one thread works with.
struct Worker {
    AlignedVector<int> near;           ///< pairs within the colloid's reach
    AlignedVector<int> touching;       ///< pairs that touch
    AlignedVector<int> touched_before; ///< in the step before
    ContactPairs contacts;
    bool most_touch = false; ///< of the listed pairs, in the step before
    Column copy;             ///< forces and torques, for all threads but the first
    PairSums sums;
};

template <class Colloid, bool has_contact>
class ComposedForces final : public PairForces {
public:
    ComposedForces(const laws::contact::AnyContact& contact, const Colloid& colloid, int threads)
        : contact_(contact), colloid_(colloid), workers_(static_cast<std::size_t>(threads)) {}

    PairSums evaluate(ParticleStore& p, const ShearBox& box, NeighbourList& list, double step,
                      bool sampling) override {
        const auto threads = static_cast<int>(workers_.size());
        const bool renumbered = list.rebuilds() != rebuilds_seen_;
        rebuilds_seen_ = list.rebuilds();
#pragma omp parallel num_threads(threads) if (threads > 1)
        {
#pragma omp for schedule(static, 1)
            for (int t = 0; t < threads; ++t) {
                Worker& worker = workers_[static_cast<std::size_t>(t)];
                const auto pairs = static_cast<long>(list.size());
                const auto begin = static_cast<int>(pairs * t / threads);
                const auto end = static_cast<int>(pairs * (t + 1) / threads);
                const ForceColumns sums = sums_of(worker, p, t);
                const ContactPairs::Scene scene{contact_, p, box, list, sums, step, sampling};
                worker.sums = {};
                if (has_contact && !has_colloid && worker.most_touch) {
                    worker.contacts.add(scene, begin, end, worker.sums);
                } else {
                    if (renumbered)
                        worker.touched_before = pairs_with_springs(list, begin, end);
                    select(p, box, list, begin, end, worker);
                    if constexpr (has_colloid)
                        act_at_distance(p, box, list, worker, sums, sampling);
                    if constexpr (has_contact)
                        act_at_contact(scene, worker);
                }
                const bool most_touched = worker.most_touch;
                worker.most_touch = 2 * worker.sums.contacts > end - begin;
                // Who looked at every pair did not note which touched.
                if (most_touched && !worker.most_touch)
                    worker.touched_before = pairs_with_springs(list, begin, end);
            }
            if (threads > 1)
                gather(p);
        }
        return total();
    }

private:
    static constexpr bool has_colloid = !std::is_same_v<Colloid, NoColloid>;

    ForceColumns sums_of(Worker& worker, ParticleStore& p, int thread) const {
        if (thread == 0)
            return {p.fx.data(), p.fy.data(), p.fz.data(), p.tx.data(), p.ty.data(), p.tz.data()};
        const std::size_t count = p.size();
        worker.copy.assign(forces_and_torques * count, 0.0);
        double* at = worker.copy.data();
        return {at, at + count, at + 2 * count, at + 3 * count, at + 4 * count, at + 5 * count};
    }

    static AlignedVector<int> pairs_with_springs(const NeighbourList& list, int begin, int end) {
        AlignedVector<int> found;
        for (int k = begin; k < end; ++k) {
            const auto at = static_cast<std::size_t>(k);
            if (list.spring_x[at] != 0.0 || list.spring_y[at] != 0.0 || list.spring_z[at] != 0.0)
                found.push_back(k);
        }
        return found;
    }

    /// The pairs of the list that act in this step.
    void select(const ParticleStore& p, const ShearBox& box, const NeighbourList& list, int begin,
                int end, Worker& worker) const {
        double reach = 0.0;
        if constexpr (has_colloid)
            reach = colloid_.cutoff;
        const NearestImage nearest(box);
        const int* first = list.first.data();
        const int* second = list.second.data();
        const double *x = p.x.data(), *y = p.y.data(), *z = p.z.data(), *radius = p.radius.data();
        AlignedVector<int>& near = worker.near;
        near.resize(static_cast<std::size_t>(end - begin) + 8);
        int found = 0;
        alignas(64) double excess[block];
        alignas(64) int places[block];
        for (int start = begin; start < end; start += block) {
            const int count = std::min(block, end - start);
#pragma omp simd
            for (int m = 0; m < count; ++m) {
                const int i = first[start + m];
                const int j = second[start + m];
                double dx = x[j] - x[i];
                double dy = y[j] - y[i];
                double dz = z[j] - z[i];
                nearest(dx, dy, dz);
                const double limit = radius[i] + radius[j] + reach;
                excess[m] = dx * dx + dy * dy + dz * dz - limit * limit;
                places[m] = start + m;
            }
            found += keep_negative(excess, places, count, near.data() + found);
        }
        near.resize(static_cast<std::size_t>(found));
    }

    void act_at_distance(const ParticleStore& p, const ShearBox& box, const NeighbourList& list,
                         Worker& worker, const ForceColumns& sums, bool sampling) const {
        const NearestImage nearest(box);
        const int* first = list.first.data();
        const int* second = list.second.data();
        const double *x = p.x.data(), *y = p.y.data(), *z = p.z.data(), *radius = p.radius.data();
        const int total = static_cast<int>(worker.near.size());
        worker.touching.resize(worker.near.size() + 1);
        int touching = 0;
        Block b;
        for (int start = 0; start < total; start += block) {
            const int count = std::min(block, total - start);
            const int* near = worker.near.data() + start;
#pragma omp simd
            for (int m = 0; m < count; ++m) {
                const int i = first[near[m]];
                const int j = second[near[m]];
                double dx = x[j] - x[i];
                double dy = y[j] - y[i];
                double dz = z[j] - z[i];
                nearest(dx, dy, dz);
                const double r = std::sqrt(dx * dx + dy * dy + dz * dz);
                const double h = r - radius[i] - radius[j];
                const double share = colloid_.repulsion(h, radius[i], radius[j]) / r;
                b.rx[m] = dx;
                b.ry[m] = dy;
                b.rz[m] = dz;
                b.fx[m] = share * dx;
                b.fy[m] = share * dy;
                b.fz[m] = share * dz;
                b.surface[m] = h;
            }
            for (int m = 0; m < count; ++m) {
                const int i = first[near[m]];
                const int j = second[near[m]];
                sums.fx[i] -= b.fx[m];
                sums.fy[i] -= b.fy[m];
                sums.fz[i] -= b.fz[m];
                sums.fx[j] += b.fx[m];
                sums.fy[j] += b.fy[m];
                sums.fz[j] += b.fz[m];
                worker.touching[static_cast<std::size_t>(touching)] = near[m];
                touching += b.surface[m] < 0.0 ? 1 : 0;
            }
            if (sampling)
                add_virial(worker.sums.colloid, b.rx, b.ry, b.rz, b.fx, b.fy, b.fz, count);
        }
        worker.touching.resize(static_cast<std::size_t>(touching));
    }

    static void act_at_contact(const ContactPairs::Scene& scene, Worker& worker) {
        NeighbourList& list = scene.list;
        const AlignedVector<int>& touching = has_colloid ? worker.touching : worker.near;
        // Springs of pairs that parted; both lists ascend.
        auto now = touching.begin();
        for (const int k : worker.touched_before) {
            while (now != touching.end() && *now < k)
                ++now;
            if (now == touching.end() || *now != k) {
                const auto at = static_cast<std::size_t>(k);
                list.spring_x[at] = list.spring_y[at] = list.spring_z[at] = 0.0;
            }
        }
        worker.contacts.add(scene, touching, worker.sums);
        worker.touched_before = touching;
    }

    /// Adds the other threads' sums to the particles', in the order of the threads.
    void gather(ParticleStore& p) {
        const auto count = static_cast<long>(p.size());
        double* target[forces_and_torques] = {p.fx.data(), p.fy.data(), p.fz.data(),
                                              p.tx.data(), p.ty.data(), p.tz.data()};
        for (std::size_t c = 0; c < forces_and_torques; ++c)
            for (std::size_t t = 1; t < workers_.size(); ++t) {
                const double* from = workers_[t].copy.data() + c * p.size();
                double* to = target[c];
#pragma omp for simd schedule(static)
                for (long i = 0; i < count; ++i)
                    to[i] += from[i];
            }
    }

    [[nodiscard]] PairSums total() const {
        PairSums sum = workers_.front().sums;
        for (std::size_t t = 1; t < workers_.size(); ++t) {
            const PairSums& other = workers_[t].sums;
            for (std::size_t e = 0; e < 9; ++e) {
                sum.contact[e] += other.contact[e];
                sum.colloid[e] += other.colloid[e];
            }
            sum.contacts += other.contacts;
            if (other.largest_overlap > sum.largest_overlap) {
                sum.largest_overlap = other.largest_overlap;
                sum.deepest_first = other.deepest_first;
                sum.deepest_second = other.deepest_second;
            }
        }
        return sum;
    }

    laws::contact::AnyContact contact_;
    Colloid colloid_;
    std::vector<Worker> workers_;
    long rebuilds_seen_ = 0;
};

} // namespace

double reach_of(const AnyColloid& colloid) {
    return std::visit(
        []<class Colloid>(const Colloid& chosen) {
            if constexpr (std::is_same_v<Colloid, NoColloid>)
                return 0.0;
            else
                return chosen.cutoff;
        },
        colloid);
}

std::unique_ptr<PairForces>
make_pair_forces(const std::optional<laws::contact::AnyContact>& contact, const AnyColloid& colloid,
                 int threads) {
    return std::visit(
        [&]<class Colloid>(const Colloid& chosen) -> std::unique_ptr<PairForces> {
            if (contact)
                return std::make_unique<ComposedForces<Colloid, true>>(*contact, chosen, threads);
            return std::make_unique<ComposedForces<Colloid, false>>(laws::contact::Hooke{}, chosen,
                                                                    threads);
        },
        colloid);
}

} // namespace searle::solvers::particles
