// What the length of the step costs in accuracy: the parts of the particles' stress over a short
// strain from one common state, against much shorter steps.
// Argument: the reference's step in seconds for the paper's case (1e-9 as the paper; slow).

#include "solvers/particles/packing.hpp"
#include "solvers/suspension/inertial_motion.hpp"
#include "solvers/suspension/overdamped_motion.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

namespace {

using namespace searle::solvers;
using namespace searle::solvers::suspension;

SuspensionInput zirconia(double side, double fraction, bool dlvo, Hydrodynamics level) {
    SuspensionInput input;
    input.box = {.length_x = side, .length_y = side, .length_z = side};
    input.box.walls = level != Hydrodynamics::lubrication;
    input.settings.diameter = 1.5e-6;
    input.settings.density = 5700.0;
    input.settings.volume_fraction = fraction;
    input.settings.hydrodynamics = level;
    input.settings.integrator = Integrator::implicit_drag;
    input.settings.contact.emplace();
    input.settings.contact->stiffness = 1e-2;
    if (dlvo) {
        input.settings.dlvo.emplace();
        input.settings.dlvo->hamaker = 6e-20;
        input.settings.dlvo->zeta_potential = 32e-3;
        input.settings.dlvo->debye_length = 10e-9;
    }
    input.viscosity = 1.0016e-3;
    input.density = 998.2;
    input.initial_wall_speed = input.fastest_wall_speed = 180.0 * side;
    input.particles = particles::random_packing({.sizes = {{1.5e-6, 1.0}},
                                                 .volume_fraction = fraction,
                                                 .density = 5700.0,
                                                 .gap = dlvo ? 30e-9 : 0.0,
                                                 .seed = 1},
                                                input.box);
    return input;
}

std::unique_ptr<SuspensionMotion> motion_of(SuspensionInput input) {
    if (input.settings.hydrodynamics == Hydrodynamics::lubrication)
        return std::make_unique<OverdampedMotion>(std::move(input));
    return std::make_unique<InertialMotion>(std::move(input));
}

void compare(const char* name, SuspensionInput input, double reference_step) {
    const double speed = input.initial_wall_speed;
    const auto wall = [speed](double) { return speed; };
    input.accuracy = 1e-3;
    // The common state.
    {
        const auto first = motion_of(input);
        while (first->time() < 2.0 / 180.0)
            first->advance(wall, 2.0 / 180.0);
        input.particles = first->particles();
    }
    const auto run = [&](double accuracy, double step) {
        SuspensionInput own = input;
        own.accuracy = accuracy;
        if (step > 0.0)
            own.settings.time_step = step;
        const auto motion = motion_of(own);
        SampleMean mean;
        const double until = 0.1 / 180.0;
        while (motion->time() < until)
            mean.add(motion->advance(wall, until));
        std::printf("%-28s accuracy %-7.2g mean step %.3g s: bulk contact %.6g, dlvo %.6g, "
                    "hydrodynamic %.6g; wall %.7g Pa\n",
                    name, accuracy, until / static_cast<double>(motion->counts().steps),
                    mean.mean().bulk.contact, mean.mean().bulk.colloid,
                    mean.mean().bulk.hydrodynamic, mean.mean().wall.total());
        std::fflush(stdout);
        return mean.mean();
    };
    const StressSample exact = run(1e-3, reference_step);
    for (const double accuracy : {1e-2, 3e-3, 1e-3, 3e-4}) {
        const StressSample mean = run(accuracy, 0.0);
        const auto off = [](double value, double right) {
            return right == 0.0 ? 0.0 : 100.0 * (value / right - 1.0);
        };
        std::printf(
            "    off by: contact %.3g %%, dlvo %.3g %%, hydrodynamic %.3g %%; wall %.3g %%\n",
            off(mean.bulk.contact, exact.bulk.contact), off(mean.bulk.colloid, exact.bulk.colloid),
            off(mean.bulk.hydrodynamic, exact.bulk.hydrodynamic),
            off(mean.wall.total(), exact.wall.total()));
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv) {
    const double step = argc > 1 ? std::atof(argv[1]) : 1e-8;
    compare("DLVO, phi 4.68 %", zirconia(50e-6, 0.0468, true, Hydrodynamics::drag), step);
    compare("plain, phi 4.68 %", zirconia(50e-6, 0.0468, false, Hydrodynamics::drag), step);
    compare("DLVO, phi 0.3", zirconia(20e-6, 0.3, true, Hydrodynamics::drag), step);
    compare("plain, phi 0.3", zirconia(20e-6, 0.3, false, Hydrodynamics::drag), step);
    compare("films, plain, phi 0.3", zirconia(20e-6, 0.3, false, Hydrodynamics::lubrication),
            5.6e-8);
    compare("films, DLVO, phi 0.3", zirconia(20e-6, 0.3, true, Hydrodynamics::lubrication), 5.6e-8);
}
