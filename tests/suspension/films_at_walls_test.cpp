#include "laws/lubrication/near_wall.hpp"
#include "solvers/suspension/overdamped_motion.hpp"
#include "suspension_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

// Particles without inertia between two walls: films with the walls, and the flow that is solved
// for together with them.

namespace searle::solvers::suspension {
namespace {

using testing::between_walls;

/// Neither fluid nor particles have mass: the flow is steady at any moment.
void take_away_inertia(SuspensionInput& input) { input.density = input.settings.density = 1e-9; }

// The drive's work is all that is lost: what the moving wall feels and the mean over the box are
// sums over quite different things. They differ by the work of what a solve leaves over, which is
// bounded by a twentieth of the accuracy (2e-4 at least) of the fluid's own stress.
TEST(FilmsAtWalls, the_wall_feels_the_mean_stress_of_the_box) {
    for (const double friction : {0.0, 0.5})
        for (const double accuracy : {1e-2, 2e-4}) {
            SuspensionInput input = between_walls(15e-6, 0.4, 500.0);
            input.settings.contact->friction = friction;
            input.settings.contact->stiffness = 0.1;
            input.settings.time_step = 4e-6;
            input.accuracy = accuracy;
            take_away_inertia(input);
            testing::pack(input);
            OverdampedMotion motion(input);
            const auto speed = [&input](double) { return input.initial_wall_speed; };
            const double fluid = 500.0 * testing::water_viscosity;
            double worst = 0.0;
            double contacts = 0.0;
            for (int step = 0; step < 100; ++step) {
                const StressSample sample = motion.advance(speed, 1.0);
                EXPECT_GT(sample.bulk.total(), 3.0 * fluid);
                worst = std::max(worst, std::abs(sample.wall.total() - sample.bulk.total()));
                contacts += std::abs(sample.wall.contact);
            }
            EXPECT_LT(worst, 0.05 * accuracy * fluid) << friction << ' ' << accuracy;
            // Without friction contacts with a wall have no part along it.
            EXPECT_EQ(contacts > 0.0, friction > 0.0);
        }
}

// One sphere near the lower wall: drag 6 pi mu a and 8 pi mu a^3 against the flow, film between
// sphere and wall (laws/lubrication/near_wall.hpp, tested against its sources), written down here
// for the velocity U along the wall and the spin W about -z, the fluid's shear g left as it is:
//     D (U - g y) + k (U - d W) - m W = 0,   C (W - g/2) - d k (U - d W) - m (U - 2 d W) + p W = 0
// with slip U - d W, rolling W, d from centre to wall.
TEST(FilmsAtWalls, a_sphere_near_a_wall_rolls_along_it_with_the_films_resistance) {
    const double a = 0.75e-6;
    const double g = 100.0;
    for (const double gap : {1e-3, 1e-2, 0.1}) {
        // So wide a box that the sphere does not bend the flow.
        SuspensionInput input = between_walls(600e-6, 1e-9, g);
        input.accuracy = 1e-7;
        input.coupling.cells = {1, 1, 1};
        input.settings.contact.reset();
        input.settings.time_step = 1e-9;
        take_away_inertia(input);
        const double d = a * (1.0 + gap);
        input.particles.add(300e-6, d, 300e-6, a, 1e-9);
        input.particles.add(300e-6, 300e-6, 300e-6, a, 1e-9);
        OverdampedMotion motion(input);
        motion.advance([&](double) { return g * 600e-6; }, 1.0);
        const laws::lubrication::Film film =
            laws::lubrication::wall_film((gap + film_roughness) * a, a, testing::water_viscosity,
                                         laws::lubrication::Squeeze::leading);
        const double drag = 6 * std::numbers::pi * testing::water_viscosity * a;
        const double turn = 8 * std::numbers::pi * testing::water_viscosity * a * a * a;
        // Power k s^2 + 2 m s r + p r^2 with s = U - d W, r = -W: forces are its half derivatives.
        const double uu = drag + film.shear;
        const double uw = -d * film.shear - film.mixed;
        const double ww = turn + d * d * film.shear + 2.0 * d * film.mixed + film.pump;
        const double det = uu * ww - uw * uw;
        const double fu = drag * g * d;
        const double fw = turn * 0.5 * g;
        const double speed = (fu * ww - fw * uw) / det;
        const double spin = (fw * uu - fu * uw) / det;
        const auto& p = motion.particles();
        const std::size_t low = p.id[0] == 0 ? 0 : 1;
        EXPECT_NEAR(p.vx[low] / speed, 1.0, 1e-5) << gap;
        EXPECT_NEAR(-p.wz[low] / spin, 1.0, 1e-5) << gap;
        EXPECT_NEAR(p.vy[low], 0.0, 1e-9 * speed);
        // Slower than the flow there, as every wall has it; the other one moves with the flow.
        EXPECT_LT(speed, g * d);
        EXPECT_NEAR(p.vx[1 - low] / (g * 300e-6), 1.0, 1e-6);
    }
}

/// Wall's stress over viscosity times d(rate)/dt when a plate is sped up evenly over a fluid at
/// rest (physics.md section 2), s:  t + T - 2 h^2 / nu sum_n exp(-n^2 pi^2 nu t / h^2) / (n pi)^2,
/// T = h^2 / 3 nu.
double ramp_response(double time, double gap, double kinematic_viscosity) {
    const double own = gap * gap / kinematic_viscosity;
    double transient = 0.0;
    for (int n = 1; n < 30; ++n) {
        const double square = std::pow(n * std::numbers::pi, 2);
        transient += std::exp(-square * time / own) / square;
    }
    return time + own * (1.0 / 3.0 - 2.0 * transient);
}

/// Ends a ramp from rest of `input` at time `end`. @return wall's stress over that of the series
double ramp_at(const SuspensionInput& input, double end, double viscosity, double density) {
    OverdampedMotion motion(input);
    const double gap = input.box.length_y;
    const auto speed = [gap](double time) { return 1e5 * gap * time; };
    StressSample sample;
    while (motion.time() < end)
        sample = motion.advance(speed, end);
    return sample.wall.total() /
           (viscosity * 1e5 * ramp_response(sample.time, gap, viscosity / density));
}

TEST(FilmsAtWalls, the_fluid_between_walls_has_the_inertia_of_a_ramp) {
    const double h = 50e-6;
    const double end = 0.1 * h * h * testing::water_density / testing::water_viscosity;
    SuspensionInput input = between_walls(h, 1e-9, 0.0);
    input.fastest_wall_speed = 1.0;
    input.accuracy = 2e-4;
    input.settings.contact.reset();
    input.particles.add(25e-6, 20e-6, 25e-6, 1e-9, 5700.0);
    input.particles.add(5e-6, 30e-6, 25e-6, 1e-9, 5700.0);
    const auto error = [&](int cells, int steps) {
        input.coupling.cells[1] = cells;
        input.settings.time_step = end / steps;
        return ramp_at(input, end, testing::water_viscosity, testing::water_density) - 1.0;
    };
    // Second order in the cells, with steps so short that they do not show.
    const double cells[] = {error(4, 20000), error(8, 20000), error(16, 20000)};
    EXPECT_NEAR(cells[0] / cells[1], 4.0, 0.5) << cells[0] << ' ' << cells[1];
    EXPECT_NEAR(cells[1] / cells[2], 4.0, 0.5) << cells[1] << ' ' << cells[2];
    EXPECT_LT(std::abs(cells[2]), 3e-3);
    // First order in the steps, against the same cells.
    const double steps[] = {error(16, 100) - cells[2], error(16, 200) - cells[2],
                            error(16, 400) - cells[2]};
    EXPECT_NEAR(steps[0] / steps[1], 2.0, 0.2) << steps[0] << ' ' << steps[1];
    EXPECT_NEAR(steps[1] / steps[2], 2.0, 0.2) << steps[1] << ' ' << steps[2];
}

// Heavy spheres on a lattice too wide for films: what the wall moves is a fluid of Einstein's
// viscosity and of the mixture's density, 1.9 times the fluid's. (Of the fluid's own density the
// stress would be 30 % less.)
TEST(FilmsAtWalls, the_mixture_between_walls_has_the_inertia_of_a_ramp) {
    const double a = 0.75e-6;
    const double apart = 3.2 * a;
    const int planes = 10;
    SuspensionInput input = between_walls(planes * apart, 0.1, 0.0);
    input.box.length_x = input.box.length_z = 3 * apart;
    input.fastest_wall_speed = 1.0;
    input.accuracy = 2e-4;
    input.coupling.cells[1] = planes;
    const double heavy = 8.0 * testing::water_density;
    for (int i = 0; i < planes * 9; ++i)
        input.particles.add((i % 3 + 0.5) * apart, (i / 9 + 0.5) * apart, (i / 3 % 3 + 0.5) * apart,
                            a, heavy);
    const double fraction = input.particles.total_volume() / input.box.volume();
    const double viscosity = testing::water_viscosity * (1.0 + 2.5 * fraction);
    const double density = testing::water_density * (1.0 - fraction) + heavy * fraction;
    EXPECT_NEAR(density / testing::water_density, 1.9, 0.01);
    const double end = 0.1 * std::pow(input.box.length_y, 2) * density / viscosity;
    input.settings.time_step = end / 5000;
    // Second order in the cells: 0.6 % at ten of them (the fluid by itself: 0.9 % at eight).
    EXPECT_NEAR(ramp_at(input, end, viscosity, density), 1.0, 8e-3);
}

// A sphere that overlaps the wall is pushed off by the contact against Stokes' drag and the film:
// U (6 pi mu a + X) = k overlap, X of the roughness alone. At either wall.
TEST(FilmsAtWalls, a_wall_pushes_a_sphere_off_with_the_films_resistance) {
    const double a = 0.75e-6;
    const double overlap = 1e-3 * a;
    for (const bool upper : {false, true}) {
        SuspensionInput input = between_walls(30e-6, 1e-4, 0.0);
        input.fastest_wall_speed = 1.0;
        input.settings.time_step = 1e-12;
        input.particles.add(15e-6, upper ? 30e-6 - a + overlap : a - overlap, 15e-6, a, 5700.0);
        input.particles.add(5e-6, 15e-6, 15e-6, a, 5700.0);
        OverdampedMotion motion(input);
        const StressSample sample = motion.advance([](double) { return 0.0; }, 1.0);
        const double drag = 6 * std::numbers::pi * testing::water_viscosity * a;
        const double expected =
            *input.settings.contact->stiffness * overlap / (drag * (1.0 + 1.0 / film_roughness));
        const std::size_t touching = motion.particles().id[0] == 0 ? 0 : 1;
        EXPECT_NEAR(motion.particles().vy[touching] / expected, upper ? -1.0 : 1.0, 1e-5);
        EXPECT_EQ(sample.contact_number, 0.5);
        EXPECT_EQ(sample.wall.total(), 0.0);
    }
}

TEST(FilmsAtWalls, the_other_direction_has_the_opposite_stress) {
    StressSample samples[2];
    for (const double sign : {1.0, -1.0}) {
        SuspensionInput input = between_walls(12e-6, 0.3, sign * 500.0);
        input.fastest_wall_speed = std::abs(input.fastest_wall_speed);
        input.settings.time_step = 4e-6;
        testing::pack(input);
        for (double& x : input.particles.x) // the mirror image
            x = sign > 0.0 ? x : 12e-6 - x;
        OverdampedMotion motion(input);
        const double wall = input.initial_wall_speed;
        for (int step = 0; step < 20; ++step)
            samples[sign > 0.0 ? 0 : 1] = motion.advance([wall](double) { return wall; }, 1.0);
    }
    for (const auto part :
         {&StressParts::fluid, &StressParts::hydrodynamic, &StressParts::contact}) {
        EXPECT_NEAR(samples[1].wall.*part, -(samples[0].wall.*part),
                    1e-4 * samples[0].wall.total());
        EXPECT_NEAR(samples[1].bulk.*part, -(samples[0].bulk.*part),
                    1e-4 * samples[0].bulk.total());
    }
}

TEST(FilmsAtWalls, a_particle_that_goes_through_a_wall_is_told) {
    SuspensionInput input = between_walls(12e-6, 0.3, 500.0);
    testing::pack(input);
    input.particles.y[3] = -1e-9;
    OverdampedMotion motion(input);
    const double wall = input.initial_wall_speed;
    EXPECT_THROW((void)motion.advance([wall](double) { return wall; }, 1.0), StepFailure);
}

TEST(FilmsAtWalls, spheres_far_apart_have_einsteins_viscosity_between_walls) {
    SuspensionInput input = between_walls(30e-6, 1e-3, 100.0);
    // One in each of 2 x 2 x 2 cells, none near a wall or another.
    for (const double x : {7e-6, 22e-6})
        for (const double y : {8e-6, 22e-6})
            for (const double z : {7e-6, 22e-6})
                input.particles.add(x, y, z, 0.75e-6, 5700.0);
    input.coupling.cells = {2, 2, 2};
    OverdampedMotion motion(input); // starts in uniform shear
    const StressSample sample = motion.advance([](double) { return 100.0 * 30e-6; }, 1.0);
    const double fraction = input.particles.total_volume() / input.box.volume();
    EXPECT_NEAR(sample.wall.total() / (100.0 * testing::water_viscosity), 1.0 + 2.5 * fraction,
                1e-12);
    EXPECT_NEAR(sample.bulk.total(), sample.wall.total(), 1e-12 * sample.wall.total());
}

} // namespace
} // namespace searle::solvers::suspension
