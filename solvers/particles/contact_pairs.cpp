#include "solvers/particles/contact_pairs.hpp"

#include "solvers/particles/touching_pair.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace searle::solvers::particles {
namespace {

/// Pairs at a time: what the loops below hand to each other stays in the fastest cache.
constexpr int block = 64;
constexpr int lanes = 8;

struct alignas(64) Lane {
    double at[block];
    double& operator[](int m) { return at[m]; }
    double operator[](int m) const { return at[m]; }
};

/// A block of touching pairs. Reading particles and adding to them jumps about in memory, and two
/// pairs may add to one particle: both are loops over pairs one by one, the law between them is a
/// loop over whole vector registers.
struct Block {
    Lane rx, ry, rz;       ///< from the first to the second, m
    Lane vx, vy, vz;       ///< of the second less the first, m/s
    Lane wx1, wy1, wz1;    ///< angular velocities, 1/s
    Lane wx2, wy2, wz2;    //
    Lane radius1, radius2; ///< m
    Lane mass1, mass2;     ///< kg
    Lane sx, sy, sz;       ///< springs, m
    Lane overlap;          ///< m
    Lane fx, fy, fz;       ///< on the second, N
    Lane tx1, ty1, tz1;    ///< on the first, N m
    Lane tx2, ty2, tz2;    ///< on the second
    int first[block], second[block];
};

template <bool friction>
void read(Block& b, const ParticleStore& p, const NeighbourList& list, const int* pairs,
          int count) {
    const int *first = list.first.data(), *second = list.second.data();
    const double *x = p.x.data(), *y = p.y.data(), *z = p.z.data();
    const double *vx = p.vx.data(), *vy = p.vy.data(), *vz = p.vz.data();
    const double *wx = p.wx.data(), *wy = p.wy.data(), *wz = p.wz.data();
    const double *radius = p.radius.data(), *mass = p.mass.data();
    const double *sx = list.spring_x.data(), *sy = list.spring_y.data();
    const double* sz = list.spring_z.data();
    for (int m = 0; m < count; ++m) {
        const int k = pairs[m];
        const int i = first[k];
        const int j = second[k];
        b.first[m] = i;
        b.second[m] = j;
        b.rx[m] = x[j] - x[i];
        b.ry[m] = y[j] - y[i];
        b.rz[m] = z[j] - z[i];
        b.vx[m] = vx[j] - vx[i];
        b.vy[m] = vy[j] - vy[i];
        b.vz[m] = vz[j] - vz[i];
        b.radius1[m] = radius[i];
        b.radius2[m] = radius[j];
        b.mass1[m] = mass[i];
        b.mass2[m] = mass[j];
        if constexpr (friction) {
            b.wx1[m] = wx[i];
            b.wy1[m] = wy[i];
            b.wz1[m] = wz[i];
            b.wx2[m] = wx[j];
            b.wy2[m] = wy[j];
            b.wz2[m] = wz[j];
            b.sx[m] = sx[k];
            b.sy[m] = sy[k];
            b.sz[m] = sz[k];
        }
    }
}

template <bool friction, bool rolling>
void act(Block& b, const laws::contact::Hooke& law, const NearestImage& nearest, double step,
         int count) {
    // Whole registers: what lies beyond `count` is of the block before, and nobody reads it.
    const int padded = (count + lanes - 1) / lanes * lanes;
#pragma omp simd
    for (int m = 0; m < padded; ++m) {
        double dx = b.rx[m];
        double dy = b.ry[m];
        double dz = b.rz[m];
        const double crossings = nearest(dx, dy, dz);
        const double r = std::sqrt(dx * dx + dy * dy + dz * dz);
        const double inverse = 1.0 / r;
        const double overlap = b.radius1[m] + b.radius2[m] - r;
        const Touch touch{.nx = dx * inverse,
                          .ny = dy * inverse,
                          .nz = dz * inverse,
                          .overlap = overlap,
                          .vx = b.vx[m] - crossings * nearest.speed,
                          .vy = b.vy[m],
                          .vz = b.vz[m],
                          .lever_first = b.radius1[m] - 0.5 * overlap,
                          .lever_second = b.radius2[m] - 0.5 * overlap,
                          .wx1 = b.wx1[m],
                          .wy1 = b.wy1[m],
                          .wz1 = b.wz1[m],
                          .wx2 = b.wx2[m],
                          .wy2 = b.wy2[m],
                          .wz2 = b.wz2[m],
                          .reduced_mass = b.mass1[m] * b.mass2[m] / (b.mass1[m] + b.mass2[m]),
                          .rolling_radius =
                              rolling ? b.radius1[m] * b.radius2[m] / (b.radius1[m] + b.radius2[m])
                                      : 0.0};
        double sx = b.sx[m];
        double sy = b.sy[m];
        double sz = b.sz[m];
        const TouchForce f = touch_force<friction, rolling>(law, touch, step, sx, sy, sz);
        b.rx[m] = dx;
        b.ry[m] = dy;
        b.rz[m] = dz;
        b.overlap[m] = overlap;
        b.fx[m] = f.normal * touch.nx + f.tx;
        b.fy[m] = f.normal * touch.ny + f.ty;
        b.fz[m] = f.normal * touch.nz + f.tz;
        if constexpr (friction) {
            b.sx[m] = sx;
            b.sy[m] = sy;
            b.sz[m] = sz;
            const double cx = touch.ny * f.tz - touch.nz * f.ty;
            const double cy = touch.nz * f.tx - touch.nx * f.tz;
            const double cz = touch.nx * f.ty - touch.ny * f.tx;
            b.tx1[m] = touch.lever_first * cx + f.rx;
            b.ty1[m] = touch.lever_first * cy + f.ry;
            b.tz1[m] = touch.lever_first * cz + f.rz;
            b.tx2[m] = touch.lever_second * cx - f.rx;
            b.ty2[m] = touch.lever_second * cy - f.ry;
            b.tz2[m] = touch.lever_second * cz - f.rz;
        }
    }
}

template <bool friction>
void write(const Block& b, const ForceColumns& to, NeighbourList& list, const int* pairs,
           int count) {
    double *sx = list.spring_x.data(), *sy = list.spring_y.data(), *sz = list.spring_z.data();
    for (int m = 0; m < count; ++m) {
        const int i = b.first[m];
        const int j = b.second[m];
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
            to.tx[j] -= b.tx2[m];
            to.ty[j] -= b.ty2[m];
            to.tz[j] -= b.tz2[m];
            const int k = pairs[m];
            sx[k] = b.sx[m];
            sy[k] = b.sy[m];
            sz[k] = b.sz[m];
        }
    }
}

void note_deepest(const Block& b, const ParticleStore& p, int count, PairSums& sums) {
    double deepest = sums.largest_overlap;
#pragma omp simd reduction(max : deepest)
    for (int m = 0; m < count; ++m)
        deepest = b.overlap[m] > deepest ? b.overlap[m] : deepest;
    if (deepest <= sums.largest_overlap)
        return;
    const int m =
        static_cast<int>(std::find(b.overlap.at, b.overlap.at + count, deepest) - b.overlap.at);
    sums.largest_overlap = deepest;
    sums.deepest_first = p.id[static_cast<std::size_t>(b.first[m])];
    sums.deepest_second = p.id[static_cast<std::size_t>(b.second[m])];
}

template <bool friction, bool rolling>
void add(const laws::contact::Hooke& law, const ParticleStore& p, const ShearBox& box,
         NeighbourList& list, const AlignedVector<int>& touching, const ForceColumns& forces,
         double step, bool sampling, PairSums& sums) {
    const NearestImage nearest(box);
    const int total = static_cast<int>(touching.size());
    Block b{};
    for (int start = 0; start < total; start += block) {
        const int count = std::min(block, total - start);
        const int* pairs = touching.data() + start;
        read<friction>(b, p, list, pairs, count);
        act<friction, rolling>(b, law, nearest, step, count);
        write<friction>(b, forces, list, pairs, count);
        note_deepest(b, p, count, sums);
        if (sampling)
            add_virial(sums.contact, b.rx.at, b.ry.at, b.rz.at, b.fx.at, b.fy.at, b.fz.at, count);
    }
}

} // namespace

void add_contact_forces(const laws::contact::Hooke& law, const ParticleStore& particles,
                        const ShearBox& box, NeighbourList& list,
                        const AlignedVector<int>& touching, const ForceColumns& forces, double step,
                        bool sampling, PairSums& sums) {
    if (touching.empty())
        return;
    if (law.friction == 0.0)
        add<false, false>(law, particles, box, list, touching, forces, step, sampling, sums);
    else if (law.rolling_friction == 0.0)
        add<true, false>(law, particles, box, list, touching, forces, step, sampling, sums);
    else
        add<true, true>(law, particles, box, list, touching, forces, step, sampling, sums);
}

void add_virial(Virial& virial, const double* rx, const double* ry, const double* rz,
                const double* fx, const double* fy, const double* fz, int count) {
    double xx = 0, xy = 0, xz = 0, yx = 0, yy = 0, yz = 0, zx = 0, zy = 0, zz = 0;
#pragma omp simd reduction(+ : xx, xy, xz, yx, yy, yz, zx, zy, zz)
    for (int m = 0; m < count; ++m) {
        xx += rx[m] * fx[m];
        xy += rx[m] * fy[m];
        xz += rx[m] * fz[m];
        yx += ry[m] * fx[m];
        yy += ry[m] * fy[m];
        yz += ry[m] * fz[m];
        zx += rz[m] * fx[m];
        zy += rz[m] * fy[m];
        zz += rz[m] * fz[m];
    }
    const double sum[9] = {xx, xy, xz, yx, yy, yz, zx, zy, zz};
    for (std::size_t e = 0; e < 9; ++e)
        virial[e] += sum[e];
}

} // namespace searle::solvers::particles
