#include "solvers/suspension/inertial_motion.hpp"

#include "laws/drag/di_felice.hpp"
#include "laws/drag/stokes.hpp"
#include "suspension_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace searle::solvers::suspension {
namespace {

using testing::pack;
using testing::zirconia;

const auto at_rest = [](double) { return 0.0; };

/// Mean over a stretch of time.
StressSample run(SuspensionMotion& motion, const WallSpeed& speed, double until) {
    SampleMean mean;
    while (motion.time() < until)
        mean.add(motion.advance(speed, until));
    return mean.mean();
}

TEST(InertialMotion, conserves_momentum_of_particles_fluid_and_walls_to_round_off) {
    for (const CouplingModel model : {CouplingModel::a, CouplingModel::b})
        for (const Integrator integrator : {Integrator::implicit_drag, Integrator::explicit_steps})
            for (const int interval : {1, 7}) {
                SuspensionInput input = zirconia(12e-6, 0.3, 500.0);
                input.settings.hydrodynamics = Hydrodynamics::stresslet;
                input.settings.dlvo = testing::zirconia_colloid();
                input.settings.brownian = integrator == Integrator::implicit_drag;
                input.settings.integrator = integrator;
                input.coupling.model = model;
                input.coupling.interval = interval;
                pack(input);
                InertialMotion motion(input);
                const double start = motion.momentum_defect();
                // The fluid starts at rest within a moving wall: momentum flows.
                const auto speed = [&](double t) { return 6e-3 * (1.0 + 1e4 * t); };
                double scale = 0.0;
                while (motion.counts().steps < 700) {
                    motion.advance(speed, 1.0);
                    double momentum = 0.0;
                    for (std::size_t i = 0; i < motion.particles().size(); ++i)
                        momentum += std::abs(motion.particles().mass[i] * motion.particles().vx[i]);
                    scale = std::max(scale, momentum);
                    ASSERT_NEAR(motion.momentum_defect() - start, 0.0, 1e-11 * scale)
                        << "model B: " << (model == CouplingModel::b) << " interval " << interval;
                }
            }
}

TEST(InertialMotion, a_particle_sinks_with_di_felices_speed) {
    SuspensionInput input = zirconia(40e-6, 0.001, 1.0);
    input.settings.gravity = 9.80665;
    input.initial_wall_speed = 0.0;
    input.particles.add(20e-6, 20e-6, 20e-6, 0.75e-6, 5700.0);
    InertialMotion motion(input);
    run(motion, at_rest, 2e-3);
    const auto& p = motion.particles();
    // Force balance with the law itself at the slip that is there; fluid fraction at the particle's
    // plane, and the return flow of what it displaces.
    const double volume = p.volume(0);
    const double plane = volume / (5e-6 * 40e-6 * 40e-6);
    const double slip = -p.vz[0] * (1.0 + volume / (motion.box().volume() - volume));
    const laws::drag::DiFelice law{testing::water_viscosity, testing::water_density};
    const double weight = volume * (5700.0 - testing::water_density) * 9.80665;
    EXPECT_NEAR(slip * law.coefficient(0.75e-6, slip, 1.0 - plane) / weight, 1.0, 1e-9);
    // And with Stokes' speed over 0.96 for the creeping limit; sqrt(Re) adds 0.25 %.
    const double stokes = weight / (6 * std::numbers::pi * testing::water_viscosity * 0.75e-6);
    EXPECT_NEAR(slip / (stokes / 0.96), 1.0, 5e-3);
}

TEST(InertialMotion, diffuses_with_einsteins_coefficient) {
    // kT / (6 pi mu a), Stokes drag; each particle is a sample. Steps of 20 relaxation times and of
    // a tenth of one must agree: the displacement's distribution is exact for any step.
    for (const double step : {1.4e-5, 7e-8}) {
        SuspensionInput input = zirconia(200e-6, 0.001, 1.0);
        input.settings.contact.reset();
        input.settings.drag = Drag::stokes;
        input.settings.brownian = true;
        input.settings.time_step = step;
        input.settings.temperature = 293.15;
        input.initial_wall_speed = 0.0;
        pack(input);
        const std::size_t count = input.particles.size();
        ASSERT_GT(count, 4000U);
        InertialMotion motion(input);
        const double settled = 20 * 0.7e-6;
        run(motion, at_rest, settled);
        std::vector<double> start(3 * count);
        const auto places = [&](std::vector<double>& out) {
            const auto& p = motion.particles();
            for (std::size_t i = 0; i < count; ++i) {
                const auto id = static_cast<std::size_t>(p.id[i]);
                out[3 * id] = p.x[i];
                out[3 * id + 1] = p.y[i];
                out[3 * id + 2] = p.z[i];
            }
        };
        places(start);
        const double duration = 400 * step;
        run(motion, at_rest, settled + duration);
        std::vector<double> end(3 * count);
        places(end);
        double sum = 0.0;
        for (std::size_t k = 0; k < 3 * count; ++k) {
            double moved = end[k] - start[k];
            if (k % 3 != 1)
                moved -= 200e-6 * std::nearbyint(moved / 200e-6);
            sum += moved * moved;
        }
        const double tau = 5700.0 * 2.25e-12 / (18 * testing::water_viscosity);
        const double einstein = laws::colloid::boltzmann * 293.15 /
                                (6 * std::numbers::pi * testing::water_viscosity * 0.75e-6);
        // Ornstein and Uhlenbeck: <x^2> = 2 D (t - tau (1 - exp(-t / tau))).
        const double expected = 2 * einstein * (duration - tau * (1.0 - std::exp(-duration / tau)));
        const double samples = 3.0 * static_cast<double>(count);
        // Four standard errors of a variance.
        EXPECT_NEAR(sum / samples / expected, 1.0, 4 * std::sqrt(2.0 / samples)) << step;
    }
}

TEST(InertialMotion, pure_fluid_follows_the_plane_ramp_to_second_order) {
    // One particle that weighs nothing; physics.md section 2: eta_app / eta = 1 + d^2 / (3 nu t)
    // once the start is over. Implicit Euler is exact for what grows linearly, so the grid is left:
    // the error falls with the square of its spacing.
    double error[2];
    for (int level = 0; level < 2; ++level) {
        SuspensionInput input = zirconia(50e-6, 1e-12, 180.0);
        input.settings.diameter = 1e-9;
        input.initial_wall_speed = 0.0;
        input.settings.time_step = 1e-6;
        input.coupling.interval = 4;
        input.coupling.cells = {8, 8 << level, 8};
        input.particles.add(25e-6, 25e-6, 25e-6, 0.5e-9, 1000.0);
        InertialMotion motion(input);
        const double slope = 180.0 * 50e-6 / 0.02;
        const auto speed = [&](double t) { return slope * t; };
        run(motion, speed, 0.01);
        const StressSample last = motion.advance(speed, 0.01 + 4e-6);
        const double t = motion.time();
        const double nu = testing::water_viscosity / testing::water_density;
        const double expected =
            testing::water_viscosity * slope * t / 50e-6 * (1.0 + 2.5e-9 / (3.0 * nu * t));
        error[level] = std::abs(last.wall.total() / expected - 1.0);
    }
    EXPECT_LT(error[0], 1e-3);
    EXPECT_NEAR(error[0] / error[1], 4.0, 0.2);
}

TEST(InertialMotion, isolated_stresslets_give_einsteins_viscosity) {
    // Without forces between them particles follow the flow, so the stress is that of the fluid and
    // the stresslets alone. Exact for Lees-Edwards; with walls up to the spread of phi across the
    // gap, of second order in it: (2.5 phi)^2 (relative variance of phi, below 1 here).
    for (const bool walls : {false, true}) {
        SuspensionInput input = zirconia(30e-6, 0.01, 100.0);
        input.box.walls = walls;
        input.settings.hydrodynamics = Hydrodynamics::stresslet;
        input.settings.contact.reset();
        pack(input);
        const double fraction = input.particles.total_volume() / input.box.volume();
        InertialMotion motion(input);
        const auto speed = [](double) { return 100.0 * 30e-6; };
        run(motion, speed, 2e-3);
        const StressSample mean = run(motion, speed, 4e-3);
        const double viscosity = mean.wall.total() / (100.0 * testing::water_viscosity);
        EXPECT_NEAR((viscosity - 1.0) / (2.5 * fraction), 1.0, walls ? 0.02 : 2e-3) << walls;
    }
}

TEST(InertialMotion, wall_stress_is_the_bulk_stress_on_average) {
    // Four-way coupled, pressed together: momentum flows through contacts, double layers and the
    // fluid, and what arrives at the wall is the mean over the box (up to the particles' inertia).
    SuspensionInput input = zirconia(20e-6, 0.35, 300.0);
    input.settings.dlvo = testing::zirconia_colloid();
    pack(input);
    InertialMotion motion(input);
    const auto speed = [](double) { return 300.0 * 20e-6; };
    run(motion, speed, 3e-3);
    const StressSample mean = run(motion, speed, 12e-3);
    const double particles = mean.bulk.total() - mean.bulk.fluid;
    EXPECT_GT(particles, 0.1 * mean.bulk.fluid) << "the particles must matter here";
    EXPECT_NEAR(mean.wall.total() / mean.bulk.total(), 1.0, 0.02);
}

TEST(InertialMotion, runs_repeat_bit_for_bit) {
    for (const int threads : {1, 2}) {
        SuspensionInput input = zirconia(15e-6, 0.3, 300.0);
        input.settings.dlvo = testing::zirconia_colloid();
        input.settings.brownian = true;
        input.threads = threads;
        pack(input);
        const auto speed = [](double) { return 300.0 * 15e-6; };
        InertialMotion one(input);
        InertialMotion two(input);
        while (one.counts().steps < 60) {
            one.advance(speed, 1.0);
            two.advance(speed, 1.0);
        }
        EXPECT_EQ(one.particles().x, two.particles().x);
        EXPECT_EQ(one.particles().vy, two.particles().vy);
    }
}

TEST(InertialMotion, a_step_that_cannot_be_taken_names_the_pair) {
    SuspensionInput input = zirconia(15e-6, 0.4, 1e4);
    input.settings.contact->stiffness = 1e-6;
    pack(input);
    InertialMotion motion(input);
    try {
        run(
            motion, [](double) { return 1e4 * 15e-6; }, 1e-3);
        FAIL() << "a contact this soft cannot carry the flow";
    } catch (const StepFailure& failure) {
        EXPECT_NE(std::string(failure.what()).find("overlap"), std::string::npos);
        EXPECT_NE(std::string(failure.what()).find("particle"), std::string::npos);
    }
}

} // namespace
} // namespace searle::solvers::suspension
