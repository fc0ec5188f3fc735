// Dense suspensions of hard spheres with lubrication and friction: relative viscosity and CPU time
// per unit strain, beside LF_DEM's (N 500, radii 1:1.4 in equal volumes, mean over strain 1 to 4).
// Arguments: number of seeds, then strain.

#include "solvers/particles/packing.hpp"
#include "solvers/suspension/overdamped_motion.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace {

using namespace searle::solvers;
using namespace searle::solvers::suspension;

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Target {
    double fraction, friction, viscosity, spread, cpu;
};

/// Viscosity 1 Pa s, smaller radius 1 m, shear rate 1 1/s: relative numbers.
void compare(const Target& target, int seeds, double strain) {
    double sum = 0.0, squares = 0.0, seconds = 0.0, overlap = 0.0, iterations = 0.0, steps = 0.0;
    for (int seed = 1; seed <= seeds; ++seed) {
        SuspensionInput input;
        const double volumes = 0.5 * (1.0 + 1.0 / (1.4 * 1.4 * 1.4));
        const double side = std::cbrt(500.0 / volumes * 4.18879 / target.fraction);
        input.box = {.length_x = side, .length_y = side, .length_z = side, .walls = false};
        input.settings.density = 1.0;
        input.settings.volume_fraction = target.fraction;
        input.settings.hydrodynamics = Hydrodynamics::lubrication;
        input.settings.contact.emplace();
        input.settings.contact->stiffness = 6.0 * 3.14159 * 2e4;
        input.settings.contact->friction = target.friction;
        input.settings.contact->tangential_stiffness = 0.5 * *input.settings.contact->stiffness;
        input.viscosity = 1.0;
        input.density = 1.0;
        input.accuracy = std::getenv("ACC") ? std::atof(std::getenv("ACC")) : 1e-2;
        input.initial_wall_speed = input.fastest_wall_speed = side;
        input.particles = particles::random_packing({.sizes = {{2.0, 0.5}, {2.8, 0.5}},
                                                     .volume_fraction = target.fraction,
                                                     .density = 1.0,
                                                     .gap = 0.02,
                                                     .seed = static_cast<std::uint64_t>(seed)},
                                                    input.box);
        const double fraction = input.particles.total_volume() / input.box.volume();
        OverdampedMotion motion(input);
        const auto speed = [side](double) { return side; };
        const double start = cpu_seconds();
        SampleMean mean;
        while (motion.time() < strain) {
            const StressSample sample = motion.advance(speed, strain);
            if (motion.time() > 1.0)
                mean.add(sample);
        }
        seconds += (cpu_seconds() - start) / strain;
        const double viscosity = mean.mean().bulk.total() - 2.5 * fraction;
        sum += viscosity;
        squares += viscosity * viscosity;
        iterations += static_cast<double>(motion.counts().solver_iterations);
        steps += static_cast<double>(motion.counts().steps);
        overlap = std::max(overlap, mean.mean().contact_number);
    }
    const double mean = sum / seeds;
    const double deviation =
        seeds > 1 ? std::sqrt(std::max(0.0, (squares / seeds - mean * mean) * seeds / (seeds - 1)))
                  : 0.0;
    std::printf("phi %.2f mu_c %.0f: eta_r - 2.5 phi = %7.3f +- %.3f (total %7.3f); LF_DEM %.2f +- "
                "%.2f; %.3g CPU-s per unit strain%s; %.0f steps, %.1f iterations each; Z %.2f\n",
                target.fraction, target.friction, mean, deviation, mean + 2.5 * target.fraction,
                target.viscosity, target.spread, seconds / seeds,
                target.cpu > 0.0 ? (target.cpu > 100 ? " (178)" : " (85)") : "", steps / seeds,
                iterations / steps, overlap);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const int seeds = argc > 1 ? std::atoi(argv[1]) : 3;
    const double strain = argc > 2 ? std::atof(argv[2]) : 4.0;
    for (const Target& target : {Target{0.3, 0, 2.76, 0.07, 0}, Target{0.4, 0, 5.94, 0.34, 0},
                                 Target{0.5, 0, 15.1, 1.0, 85}, Target{0.3, 1, 3.27, 0.11, 0},
                                 Target{0.4, 1, 10.0, 1.5, 0}, Target{0.5, 1, 82, 16, 178}})
        compare(target, seeds, strain);
}
