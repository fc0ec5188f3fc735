#include "solvers/particles/contact_pairs.hpp"

#include "solvers/particles/contact_block.hpp"
#include "solvers/particles/lanes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace searle::solvers::particles {
namespace {

using Block = ContactBlock;
constexpr int lanes = Block::lanes;

/// Pairs from the particles' columns.
template <bool friction>
void read(Block& b, const ParticleStore& p, const int* first, const int* second, int count) {
    const double *x = p.x.data(), *y = p.y.data(), *z = p.z.data();
    const double *vx = p.vx.data(), *vy = p.vy.data(), *vz = p.vz.data();
    const double *wx = p.wx.data(), *wy = p.wy.data(), *wz = p.wz.data();
    const double *radius = p.radius.data(), *mass = p.mass.data();
    for (int m = 0; m < count; ++m) {
        const int i = first[m];
        const int j = second[m];
        b.dx[m] = x[j] - x[i];
        b.dy[m] = y[j] - y[i];
        b.dz[m] = z[j] - z[i];
        b.vx[m] = vx[j] - vx[i];
        b.vy[m] = vy[j] - vy[i];
        b.vz[m] = vz[j] - vz[i];
        b.radii_apart[m] = radius[j] - radius[i];
        b.radii[m] = radius[j] + radius[i];
        b.inverse_masses[m] = 1.0 / mass[j] + 1.0 / mass[i];
        if constexpr (friction) {
            b.spin_x[m] = wx[j] - wx[i];
            b.spin_y[m] = wy[j] - wy[i];
            b.spin_z[m] = wz[j] - wz[i];
            b.wx[m] = wx[j] + wx[i];
            b.wy[m] = wy[j] + wy[i];
            b.wz[m] = wz[j] + wz[i];
        }
    }
}

template <bool friction>
void write(const Block& b, const ForceColumns& to, const int* first, const int* second, int count) {
    for (int m = 0; m < count; ++m) {
        const int i = first[m];
        const int j = second[m];
        to.fx[i] -= b.fx[m];
        to.fy[i] -= b.fy[m];
        to.fz[i] -= b.fz[m];
        to.fx[j] += b.fx[m];
        to.fy[j] += b.fy[m];
        to.fz[j] += b.fz[m];
        if constexpr (friction) {
            to.tx[i] -= b.tx1[m];
            to.ty[i] -= b.ty1[m];
            to.tz[i] -= b.tz1[m];
            to.tx[j] += b.tx2[m];
            to.ty[j] += b.ty2[m];
            to.tz[j] += b.tz2[m];
        }
    }
}

void store_columns(const Lanes (&columns)[8], int at, std::initializer_list<double*> to) {
    int c = 0;
    for (double* values : to)
        store(columns[c++], values + at);
}

void load_columns(Lanes (&columns)[8], int at, std::initializer_list<const double*> from) {
    int c = 0;
    for (const double* values : from)
        load(columns[c++], values + at);
}

void count_contacts(const Block& b, const ParticleStore& p, const int* first, const int* second,
                    int count, PairSums& sums) {
    double deepest = sums.largest_overlap;
    int contacts = 0;
#pragma omp simd reduction(max : deepest) reduction(+ : contacts)
    for (int m = 0; m < count; ++m) {
        deepest = b.overlap[m] > deepest ? b.overlap[m] : deepest;
        contacts += b.overlap[m] > 0.0 ? 1 : 0;
    }
    sums.contacts += contacts;
    if (deepest <= sums.largest_overlap)
        return;
    const auto m = std::find(b.overlap, b.overlap + count, deepest) - b.overlap;
    sums.largest_overlap = deepest;
    sums.deepest_first = p.id[static_cast<std::size_t>(first[m])];
    sums.deepest_second = p.id[static_cast<std::size_t>(second[m])];
}

} // namespace

void ContactPairs::start_rows(const ParticleStore& p, int begin) {
    rows_.begin = rows_.end = begin / lanes * lanes;
    rows_.state.resize(16 * p.size());
    rows_.force.resize(8 * p.size());
}

/// Rows for the particles before `until`, and some more. Called as blocks of pairs need them, which
/// finds them in a near cache: the list goes through the particles in their order.
void ContactPairs::fill_rows(const ParticleStore& p, const ForceColumns& forces, int until) {
    if (until <= rows_.end)
        return;
    const int begin = rows_.end;
    const int end = std::min(until + 8 * lanes, static_cast<int>(p.size()));
    rows_.end = end < static_cast<int>(p.size()) ? end / lanes * lanes : end;
    const double *x = p.x.data(), *y = p.y.data(), *z = p.z.data();
    const double *vx = p.vx.data(), *vy = p.vy.data(), *vz = p.vz.data();
    const double *wx = p.wx.data(), *wy = p.wy.data(), *wz = p.wz.data();
    const double *radius = p.radius.data(), *mass = p.mass.data();
    double* state = rows_.state.data();
    double* force = rows_.force.data();
    // Eight particles at a time; the columns' own ends are read one by one.
    for (int i = begin; i < rows_.end; i += lanes) {
        Lanes a[8], b[8], f[8];
        if (i + lanes <= end) {
            load_columns(a, i, {x, y, z, vx, vy, vz, radius, wx});
            load_columns(b, i, {wy, wz, wx, wy, wz, radius, mass, mass});
            load_columns(f, i,
                         {forces.fx, forces.fy, forces.fz, forces.tx, forces.ty, forces.tz,
                          forces.tx, forces.tx});
        } else {
            for (int m = 0; m < lanes; ++m) {
                const int at = std::min(i + m, end - 1);
                int c = 0;
                for (const double* column : {x, y, z, vx, vy, vz, radius, wx})
                    a[c++][m] = column[at];
                c = 0;
                for (const double* column : {wy, wz, wx, wy, wz, radius, mass, mass})
                    b[c++][m] = column[at];
                c = 0;
                for (const double* column :
                     {forces.fx, forces.fy, forces.fz, forces.tx, forces.ty, forces.tz})
                    f[c++][m] = column[at];
            }
        }
        b[6] = 1.0 / b[6];
        b[7] = f[6] = f[7] = Lanes{};
        transpose(a);
        transpose(b);
        transpose(f);
        for (int m = 0; m < std::min(lanes, end - i); ++m) {
            store(a[m], state + 16 * (i + m));
            store(b[m], state + 16 * (i + m) + 8);
            store(f[m], force + 8 * (i + m));
        }
    }
}

void ContactPairs::return_forces(const ForceColumns& forces) const {
    const double* force = rows_.force.data();
    double* const to[6] = {forces.fx, forces.fy, forces.fz, forces.tx, forces.ty, forces.tz};
    for (int i = rows_.begin; i < rows_.end; i += lanes) {
        const int count = std::min(lanes, rows_.end - i);
        Lanes f[8];
        for (int m = 0; m < lanes; ++m)
            load(f[m], force + 8 * (i + std::min(m, count - 1)));
        transpose(f);
        for (int c = 0; c < 6; ++c) {
            if (count == lanes)
                store(f[c], to[c] + i);
            else
                for (int m = 0; m < count; ++m)
                    to[c][i + m] = f[c][m];
        }
    }
}

/// Pairs from rows, by eight. What lies beyond `count` is the last pair again.
void ContactPairs::read(ContactBlock& b, const int* first, const int* second, int count) const {
    const double* state = rows_.state.data();
    // Of the second half of a row the first two are subtracted, the others added.
    const Lanes sign = {-1.0, -1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
    for (int at = 0; at < count; at += lanes) {
        Lanes apart[8], both[8];
        for (int m = 0; m < lanes; ++m) {
            const int k = std::min(at + m, count - 1);
            const double* one = state + 16 * static_cast<std::ptrdiff_t>(first[k]);
            const double* other = state + 16 * static_cast<std::ptrdiff_t>(second[k]);
            Lanes mine, yours;
            load(mine, one);
            load(yours, other);
            apart[m] = yours - mine;
            load(mine, one + 8);
            load(yours, other + 8);
            both[m] = yours + sign * mine;
        }
        transpose(apart);
        transpose(both);
        store_columns(apart, at, {b.dx, b.dy, b.dz, b.vx, b.vy, b.vz, b.radii_apart, b.spin_x});
        store_columns(both, at, {b.spin_y, b.spin_z, b.wx, b.wy, b.wz, b.radii, b.inverse_masses});
    }
}

void ContactPairs::write(const ContactBlock& b, const int* first, const int* second, int count) {
    double* force = rows_.force.data();
    for (int at = 0; at < count; at += lanes) {
        Lanes one[8], other[8];
        load_columns(one, at, {b.fx, b.fy, b.fz, b.tx1, b.ty1, b.tz1});
        load_columns(other, at, {b.fx, b.fy, b.fz, b.tx2, b.ty2, b.tz2});
        one[6] = one[7] = other[6] = other[7] = Lanes{};
        transpose(one);
        transpose(other);
        for (int m = 0; m < std::min(lanes, count - at); ++m) {
            const int k = at + m;
            double* to = force + 8 * static_cast<std::ptrdiff_t>(first[k]);
            Lanes sum;
            load(sum, to);
            sum -= one[m];
            store(sum, to);
            to = force + 8 * static_cast<std::ptrdiff_t>(second[k]);
            load(sum, to);
            sum += other[m];
            store(sum, to);
        }
    }
}

template <bool friction, bool rolling, class Law>
void ContactPairs::add_with(const Scene& scene, const Law& law, const AlignedVector<int>* touching,
                            int begin, int end, PairSums& sums) {
    const ParticleStore& p = scene.particles;
    NeighbourList& list = scene.list;
    const NearestImage nearest(scene.box);
    double *sx = list.spring_x.data(), *sy = list.spring_y.data(), *sz = list.spring_z.data();
    const bool in_rows = 2 * static_cast<std::size_t>(end - begin) > p.size();
    if (in_rows) {
        int least = static_cast<int>(p.size());
        for (int at = begin; at < end; ++at)
            least =
                std::min(least, list.first[static_cast<std::size_t>(
                                    touching ? (*touching)[static_cast<std::size_t>(at)] : at)]);
        start_rows(p, least);
    }
    Block b{};
    int own_first[Block::size], own_second[Block::size];
    for (int start = begin; start < end; start += Block::size) {
        const int count = std::min(Block::size, end - start);
        const int* pairs = touching ? touching->data() + start : nullptr;
        const int* first = own_first;
        const int* second = own_second;
        if (touching) {
            for (int m = 0; m < count; ++m) {
                own_first[m] = list.first[static_cast<std::size_t>(pairs[m])];
                own_second[m] = list.second[static_cast<std::size_t>(pairs[m])];
            }
        } else {
            first = list.first.data() + start;
            second = list.second.data() + start;
        }
        if (in_rows) {
            fill_rows(p, scene.forces, *std::max_element(second, second + count) + 1);
            read(b, first, second, count);
        } else {
            particles::read<friction>(b, p, first, second, count);
        }
        for (int m = 0; friction && m < count; ++m) {
            const int k = touching ? pairs[m] : start + m;
            b.sx[m] = sx[k];
            b.sy[m] = sy[k];
            b.sz[m] = sz[k];
        }
        act<friction, rolling>(b, law, nearest, scene.step, count);
        if (in_rows)
            write(b, first, second, count);
        else
            particles::write<friction>(b, scene.forces, first, second, count);
        for (int m = 0; friction && m < count; ++m) {
            const int k = touching ? pairs[m] : start + m;
            sx[k] = b.sx[m];
            sy[k] = b.sy[m];
            sz[k] = b.sz[m];
        }
        count_contacts(b, p, first, second, count, sums);
        if (scene.sampling)
            add_virial(sums.contact, b.dx, b.dy, b.dz, b.fx, b.fy, b.fz, count);
    }
    if (in_rows)
        return_forces(scene.forces);
}

void ContactPairs::add_of(const Scene& scene, const AlignedVector<int>* touching, int begin,
                          int end, PairSums& sums) {
    if (begin >= end)
        return;
    std::visit(
        [&](const auto& law) {
            if (law.friction == 0.0)
                add_with<false, false>(scene, law, touching, begin, end, sums);
            else if (law.rolling_friction == 0.0)
                add_with<true, false>(scene, law, touching, begin, end, sums);
            else
                add_with<true, true>(scene, law, touching, begin, end, sums);
        },
        scene.law);
}

void ContactPairs::add(const Scene& scene, const AlignedVector<int>& touching, PairSums& sums) {
    add_of(scene, &touching, 0, static_cast<int>(touching.size()), sums);
}

void ContactPairs::add(const Scene& scene, int begin, int end, PairSums& sums) {
    add_of(scene, nullptr, begin, end, sums);
}

void add_virial(Virial& virial, const double* rx, const double* ry, const double* rz,
                const double* fx, const double* fy, const double* fz, int count) {
    Virial sum = virial;
    for (int m = 0; m < count; ++m) {
        const double r[3] = {rx[m], ry[m], rz[m]};
        const double f[3] = {fx[m], fy[m], fz[m]};
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t c = 0; c < 3; ++c)
                sum[3 * a + c] += r[a] * f[c];
    }
    virial = sum;
}

} // namespace searle::solvers::particles
