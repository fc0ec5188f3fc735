#include "solvers/suspension/drag_coefficients.hpp"

#include "laws/drag/di_felice.hpp"
#include "laws/drag/ergun_wen_yu.hpp"
#include "laws/drag/stokes.hpp"

#include <cmath>

namespace searle::solvers::suspension {
namespace {

using particles::Column;
using particles::ParticleStore;
using particles::Surroundings;

template <class Law>
void set_with(const Law& law, bool model_b, const ParticleStore& p, Surroundings& s,
              const Column& fluid_fraction, int threads) {
    const auto count = static_cast<long>(p.size());
    const double *vx = p.vx.data(), *vy = p.vy.data(), *vz = p.vz.data();
    const double *radius = p.radius.data(), *flow = s.flow_x.data();
    const double* fraction = fluid_fraction.data();
    const double flow_z = s.flow_z;
    double* drag = s.drag.data();
#pragma omp parallel for simd schedule(static) num_threads(threads) if (parallel : threads > 1)
    for (long i = 0; i < count; ++i) {
        const double sx = flow[i] - vx[i];
        const double sz = flow_z - vz[i];
        const double slip = std::sqrt(sx * sx + vy[i] * vy[i] + sz * sz);
        const double coefficient = law.coefficient(radius[i], slip, fraction[i]);
        drag[i] = model_b ? coefficient / fraction[i] : coefficient;
    }
}

} // namespace

void set_drag(const DragChoice& choice, const ParticleStore& particles, Surroundings& surroundings,
              const Column& fluid_fraction, int threads) {
    const bool model_b = choice.model == CouplingModel::b;
    const auto with = [&](const auto& law) {
        set_with(law, model_b, particles, surroundings, fluid_fraction, threads);
    };
    switch (choice.law) {
    case Drag::stokes:
        return with(laws::drag::Stokes{choice.viscosity, choice.density});
    case Drag::di_felice:
        return with(laws::drag::DiFelice{choice.viscosity, choice.density});
    case Drag::ergun_wen_yu:
        return with(laws::drag::ErgunWenYu{choice.viscosity, choice.density});
    }
}

void set_rotational_drag(double viscosity, const ParticleStore& particles,
                         Surroundings& surroundings) {
    for (std::size_t i = 0; i < particles.size(); ++i)
        surroundings.rotational_drag[i] =
            laws::drag::rotational_coefficient(viscosity, particles.radius[i]);
}

} // namespace searle::solvers::suspension
