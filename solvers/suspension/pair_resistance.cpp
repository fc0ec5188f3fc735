#include "solvers/suspension/pair_resistance.hpp"

#include "solvers/particles/lanes.hpp"
#include "solvers/suspension/pair_kinematics.hpp"

#include <algorithm>

namespace searle::solvers::suspension {
namespace {

using particles::Lanes;
using particles::load;
using particles::store;

Lanes column(const particles::Column& values, std::size_t at) {
    Lanes lanes;
    load(lanes, values.data() + at);
    return lanes;
}

} // namespace

void PairResistance::take(const particles::AlignedVector<NearPair>& pairs, std::size_t count) {
    const std::size_t padded = (pairs.size() + lanes - 1) / lanes * lanes;
    // What lies behind the pairs resists nothing.
    first_.assign(padded, 0);
    second_.assign(padded, 0);
    for (particles::Column* each : {&nx_, &ny_, &nz_, &lever_first_, &lever_second_, &squeeze_,
                                    &shear_, &mixed_, &pump_, &twist_})
        each->assign(padded, 0.0);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const NearPair& pair = pairs[k];
        first_[k] = pair.first;
        second_[k] = pair.second;
        nx_[k] = pair.nx;
        ny_[k] = pair.ny;
        nz_[k] = pair.nz;
        lever_first_[k] = pair.lever_first;
        lever_second_[k] = pair.lever_second;
        squeeze_[k] = pair.squeeze;
        shear_[k] = pair.shear;
        mixed_[k] = pair.mixed;
        pump_[k] = pair.pump;
        twist_[k] = pair.twist;
    }
    others_.resize(static_cast<std::size_t>(threads_) - 1);
    for (Motions& each : others_)
        each.resize(motions_for(count));
}

void PairResistance::add_pairs(std::size_t begin, std::size_t end, const Motions& motions,
                               Motions& forces) const {
    for (std::size_t at = begin; at < end; at += lanes) {
        Lanes a[8], apart[8];
        for (std::size_t m = 0; m < lanes; ++m) {
            Lanes other;
            load(a[m], motions[static_cast<std::size_t>(first_[at + m])].data());
            load(other, motions[static_cast<std::size_t>(second_[at + m])].data());
            apart[m] = other - a[m];
        }
        particles::transpose(a);
        particles::transpose(apart);
        const Vector<Lanes> n{column(nx_, at), column(ny_, at), column(nz_, at)};
        const Lanes lever_first = column(lever_first_, at);
        const Lanes lever_second = column(lever_second_, at);
        // lever_1 w_1 + lever_2 w_2 by the first's and the difference.
        const Vector<Lanes> turning{apart[3], apart[4], apart[5]};
        const PairMotion<Lanes> motion = pair_motion<Lanes>(
            n, {apart[0], apart[1], apart[2]},
            combined<Lanes>(lever_first + lever_second, {a[3], a[4], a[5]}, lever_second, turning),
            turning);
        const Lanes mixed = column(mixed_, at);
        const PairPush<Lanes> push =
            pair_push<Lanes>(n, column(squeeze_, at) * motion.along,
                             combined(column(shear_, at), motion.shear, mixed, motion.roll),
                             combined(mixed, motion.shear, column(pump_, at), motion.roll));
        const auto& [nqx, nqy, nqz] = push.arm;
        // The couple that first and second have against each other.
        const Lanes twist = column(twist_, at) * dot(turning, n);
        const Lanes cx = push.couple.x + twist * n.x;
        const Lanes cy = push.couple.y + twist * n.y;
        const Lanes cz = push.couple.z + twist * n.z;
        Lanes one[8] = {
            push.force.x,           push.force.y,           push.force.z, lever_first * nqx + cx,
            lever_first * nqy + cy, lever_first * nqz + cz, Lanes{},      Lanes{}};
        Lanes two[8] = {one[0],
                        one[1],
                        one[2],
                        cx - lever_second * nqx,
                        cy - lever_second * nqy,
                        cz - lever_second * nqz,
                        Lanes{},
                        Lanes{}};
        particles::transpose(one);
        particles::transpose(two);
        for (std::size_t m = 0; m < lanes; ++m) {
            double* to = forces[static_cast<std::size_t>(first_[at + m])].data();
            Lanes sum;
            load(sum, to);
            sum -= one[m];
            store(sum, to);
            to = forces[static_cast<std::size_t>(second_[at + m])].data();
            load(sum, to);
            sum += two[m];
            store(sum, to);
        }
    }
}

void PairResistance::add(const Motions& motions, Motions& forces) {
    const std::size_t blocks = first_.size() / lanes;
    if (threads_ == 1)
        return add_pairs(0, first_.size(), motions, forces);
    const auto threads = static_cast<std::size_t>(threads_);
#pragma omp parallel for num_threads(threads_) schedule(static, 1)
    for (std::size_t part = 0; part < threads; ++part) {
        Motions& own = part == 0 ? forces : others_[part - 1];
        if (part > 0)
            std::fill(own.begin(), own.end(), Motion{});
        add_pairs(blocks * part / threads * lanes, blocks * (part + 1) / threads * lanes, motions,
                  own);
    }
    const auto count = static_cast<long>(forces.size());
#pragma omp parallel for num_threads(threads_) schedule(static)
    for (long i = 0; i < count; ++i)
        for (const Motions& other : others_)
            for (std::size_t c = 0; c < 6; ++c)
                forces[static_cast<std::size_t>(i)][c] += other[static_cast<std::size_t>(i)][c];
}

} // namespace searle::solvers::suspension
