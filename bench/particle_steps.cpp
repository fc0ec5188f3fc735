// Particle-steps per CPU-second of the particle solver: contacts alone, contacts with DLVO, dense
// packings, with and without the coupled fluid. One thread. A word as argument: scenes whose name
// has it, alone.

#include "solvers/particles/motion.hpp"
#include "solvers/particles/packing.hpp"
#include "solvers/suspension/inertial_motion.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

namespace {

using namespace searle::solvers;
using namespace searle::solvers::suspension;

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What a scene's name must have to run; empty: all run.
std::string chosen;

constexpr double diameter = 1.5e-6;
constexpr double density = 5700.0;

particles::ShearBox cube_for(double count, double fraction) {
    const double side = diameter * std::cbrt(count * 3.14159265358979 / 6.0 / fraction);
    return {.length_x = side, .length_y = side, .length_z = side, .walls = false};
}

/// Contacts alone, without fluid: what a granular code does.
void contacts_alone(const char* name, double count, double fraction, double squeeze) {
    if (std::string(name).find(chosen) == std::string::npos)
        return;
    particles::ShearBox box = cube_for(count, fraction);
    particles::ParticleStore p = particles::random_packing(
        {.sizes = {{diameter, 1.0}}, .volume_fraction = fraction, .density = density, .seed = 1},
        box);
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.radius[i] *= squeeze;
        const double size = 1e-3;
        p.vx[i] = size * std::sin(1.0 + 13.0 * static_cast<double>(i));
        p.vy[i] = size * std::cos(2.0 + 7.0 * static_cast<double>(i));
        p.vz[i] = size * std::sin(3.0 + 3.0 * static_cast<double>(i));
    }
    const searle::laws::contact::Hooke law{.normal_stiffness = 1e-2,
                                           .tangential_stiffness = 2.0 / 7.0 * 1e-2,
                                           .damping_ratio =
                                               searle::laws::contact::damping_ratio(0.9),
                                           .friction = 0.3};
    const auto forces = particles::make_pair_forces(law, particles::NoColloid{}, 1);
    particles::NeighbourList list(0.0, (fraction < 0.2 ? 0.3 : 0.1) * 0.5 * diameter);
    list.rebuild(p, box);
    const double step = 0.02 * law.duration(0.5 * p.mass[0]);
    double best = 0.0;
    long contacts = 0;
    for (int repeat = 0; repeat < 4; ++repeat) {
        const int steps = static_cast<int>(4e6 / count) + 20;
        const double start = cpu_seconds();
        for (int k = 0; k < steps; ++k) {
            if (list.is_stale_after(p, particles::kick_and_drift(p, step, 0.0, 1), 0.0))
                list.rebuild(p, box);
            particles::clear_forces(p);
            contacts = forces->evaluate(p, box, list, step, false).contacts;
            particles::kick(p, step, 1);
        }
        best = std::max(best, static_cast<double>(p.size()) * steps / (cpu_seconds() - start));
    }
    std::printf("%-44s %7zu spheres, %5.2f contacts each: %6.1f M particle-steps per CPU-s\n", name,
                p.size(), 2.0 * static_cast<double>(contacts) / static_cast<double>(p.size()),
                1e-6 * best);
}

/// The whole solver in shear.
void in_shear(const char* name, double count, double fraction, bool walls, bool dlvo, double rate) {
    if (std::string(name).find(chosen) == std::string::npos)
        return;
    SuspensionInput input;
    input.box = cube_for(count, fraction);
    input.box.walls = walls;
    input.settings.diameter = diameter;
    input.settings.density = density;
    input.settings.volume_fraction = fraction;
    input.settings.hydrodynamics = Hydrodynamics::drag;
    input.settings.integrator = Integrator::implicit_drag;
    input.settings.contact.emplace();
    input.settings.contact->stiffness = 1e-2;
    if (dlvo) {
        input.settings.dlvo.emplace();
        input.settings.dlvo->hamaker = 6e-20;
        input.settings.dlvo->zeta_potential = 32e-3;
        input.settings.dlvo->debye_length = 10e-9;
        // Dense, drag alone pushes pairs over the barrier: rough surfaces keep them from sticking.
        if (fraction > 0.45)
            input.settings.dlvo->minimum_separation = 4e-9;
    }
    input.viscosity = 1.0016e-3;
    input.density = 998.2;
    input.accuracy = 1e-2;
    input.initial_wall_speed = input.fastest_wall_speed = rate * input.box.length_y;
    input.particles = particles::random_packing({.sizes = {{diameter, 1.0}},
                                                 .volume_fraction = fraction,
                                                 .density = density,
                                                 .gap = dlvo ? 30e-9 : 0.0,
                                                 .seed = 1},
                                                input.box);
    InertialMotion motion(input);
    const double speed = input.initial_wall_speed;
    const auto wall = [speed](double) { return speed; };
    while (motion.time() < 0.05 / rate)
        motion.advance(wall, 0.05 / rate);
    const long before = motion.counts().steps;
    const double start = cpu_seconds();
    const double until = motion.time() + (count > 10000 ? 0.05 : 0.5) / rate;
    SampleMean mean;
    while (motion.time() < until)
        mean.add(motion.advance(wall, until));
    const double seconds = cpu_seconds() - start;
    const double steps = static_cast<double>(motion.counts().steps - before);
    const double strain = mean.duration() * rate;
    std::printf(
        "%-44s %7zu spheres: %6.1f M particle-steps per CPU-s, mean step %.3g s, %.3g CPU-s "
        "per unit strain\n",
        name, motion.particles().size(),
        1e-6 * steps * static_cast<double>(motion.particles().size()) / seconds,
        mean.duration() / steps, seconds / strain);
}

} // namespace

int main(int argc, char** argv) try {
    if (argc > 1)
        chosen = argv[1];
    contacts_alone("Hooke, phi 4.68 %", 3310, 0.0468, 1.0);
    contacts_alone("Hooke, just apart, phi 0.5", 31800, 0.5, 1.0);
    contacts_alone("Hooke, pressed together, phi 0.6", 35400, 0.58, 1.02);
    in_shear("DLVO + Hooke, phi 4.68 %, bulk", 3310, 0.0468, false, true, 180);
    in_shear("DLVO + Hooke, phi 0.40, bulk", 3310, 0.40, false, true, 180);
    in_shear("paper's case, coupled fluid, DLVO", 3310, 0.0468, true, true, 180);
    in_shear("paper's case, coupled fluid, no DLVO", 3310, 0.0468, true, false, 180);
    in_shear("phi 0.5, coupled fluid, DLVO", 35000, 0.5, true, true, 180);
    std::puts("cost per step against the number of spheres, DLVO + Hooke, phi 0.2:");
    for (const double count : {500.0, 2000.0, 8000.0, 30000.0, 100000.0})
        in_shear("", count, 0.2, false, true, 180);
} catch (const StepFailure& failure) {
    std::printf("stopped: %s\n", failure.what());
    return 1;
}
