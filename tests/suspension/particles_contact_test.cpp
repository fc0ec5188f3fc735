#include "solvers/particles/motion.hpp"
#include "solvers/particles/packing.hpp"
#include "solvers/particles/pair_forces.hpp"
#include "solvers/particles/wall_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace searle::solvers::particles {
namespace {

constexpr double radius = 1e-3;
constexpr double density = 2500.0;
const ShearBox wide{.length_x = 1.0, .length_y = 1.0, .length_z = 1.0};

/// Two equal spheres, explicit steps, no fluid.
struct Collision {
    ParticleStore p;
    ShearBox box = wide;
    NeighbourList list{0.0, 0.2 * radius};
    std::unique_ptr<PairForces> forces;
    double step;

    Collision(const laws::contact::Hooke& law, double step_of_duration) {
        p.add(0.5, 0.5, 0.5, radius, density);
        p.add(0.5 + 2.0 * radius, 0.5, 0.5, radius, density);
        forces = make_pair_forces(law, NoColloid{}, 1);
        step = step_of_duration * law.duration(0.5 * p.mass[0]);
        list.rebuild(p, box);
    }
    void advance() {
        if (list.is_stale_after(p, kick_and_drift(p, step, 0.0, 1), 0.0))
            list.rebuild(p, box);
        clear_forces(p);
        forces->evaluate(p, box, list, step, false);
        kick(p, step, 1);
    }
};

TEST(HookeContact, a_head_on_pair_separates_with_its_restitution) {
    for (const double restitution : {1.0, 0.9, 0.3}) {
        const laws::contact::Hooke law{.normal_stiffness = 1e3,
                                       .damping_ratio = laws::contact::damping_ratio(restitution)};
        double error[2];
        for (int level = 0; level < 2; ++level) {
            Collision c(law, 0.01 / (1 + level));
            c.p.vx[0] = 0.05;
            c.p.vx[1] = -0.05;
            // Both touch at the start; the contact lasts one duration.
            for (int k = 0; k < 110 * (1 + level); ++k)
                c.advance();
            error[level] = std::abs((c.p.vx[1] - c.p.vx[0]) / 0.1 - restitution);
        }
        EXPECT_LT(error[0], 3e-3) << restitution;
        // Velocity Verlet: the error falls at least linearly (the contact ends between two steps).
        EXPECT_LT(error[1], 0.6 * error[0] + 1e-6) << restitution;
    }
}

TEST(HookeContact, sliding_friction_is_coulombs) {
    const double friction = 0.3;
    const laws::contact::Hooke law{
        .normal_stiffness = 1e3, .tangential_stiffness = 1e3 * 2 / 7, .friction = friction};
    ParticleStore p;
    p.add(0.5, 0.5, 0.5, radius, density);
    p.add(0.5 + 1.99 * radius, 0.5, 0.5, radius, density);
    ShearBox box = wide;
    NeighbourList list(0.0, 0.2 * radius);
    list.rebuild(p, box);
    const auto forces = make_pair_forces(law, NoColloid{}, 1);
    // The second moves across: first the spring holds, k_t v t, then it slides at mu F_n.
    p.vy[1] = 1e-3;
    const double normal = 1e3 * 0.01 * radius;
    for (const double travelled : {0.1, 0.5, 0.99, 1.5, 3.0}) {
        for (Column* spring : {&list.spring_x, &list.spring_y, &list.spring_z})
            spring->assign(1, 0.0);
        clear_forces(p);
        const double limit_travel = friction * normal / law.tangential_stiffness;
        forces->evaluate(p, box, list, travelled * limit_travel / 1e-3, false);
        // Round-off of the places, 1e-16, over the overlap, 1e-5.
        EXPECT_NEAR(p.fy[1] / (-friction * normal), std::min(travelled, 1.0), 3e-11);
        EXPECT_NEAR(p.fx[1] / normal, 1.0, 3e-11);
        // Equal and opposite; both spheres get the same torque at equal levers.
        EXPECT_EQ(p.fy[0], -p.fy[1]);
        EXPECT_NEAR(p.tz[0] / p.tz[1], 1.0, 1e-12);
        // Torque of the force at the contact, -lever n on the second.
        EXPECT_NEAR(p.tz[1] / (-0.995 * radius * p.fy[1]), 1.0, 1e-12);
    }
}

TEST(HookeContact, spheres_that_roll_on_each_other_do_not_rub) {
    const laws::contact::Hooke law{
        .normal_stiffness = 1e3, .tangential_stiffness = 1e3, .friction = 0.5};
    ParticleStore p;
    p.add(0.5, 0.5, 0.5, radius, density);
    p.add(0.5 + 1.99 * radius, 0.5, 0.5, radius, density);
    ShearBox box = wide;
    NeighbourList list(0.0, 0.2 * radius);
    list.rebuild(p, box);
    p.wz[0] = 7.0;
    p.wz[1] = -7.0;
    make_pair_forces(law, NoColloid{}, 1)->evaluate(p, box, list, 1e-3, false);
    EXPECT_NEAR(p.fy[1], 0.0, 1e-18);
    EXPECT_NEAR(p.tz[1], 0.0, 1e-18);
}

TEST(HookeContact, a_rigidly_turning_pair_keeps_its_spring) {
    // A pair that turns as one body has no sliding, so the spring stays what it was and turns
    // along.
    const laws::contact::Hooke law{
        .normal_stiffness = 1e3, .tangential_stiffness = 1e3, .friction = 100.0};
    ParticleStore p;
    p.add(0.5, 0.5, 0.5, radius, density);
    p.add(0.5 + 1.99 * radius, 0.5, 0.5, radius, density);
    p.wz[0] = p.wz[1] = 3.0;
    p.vy[1] = 3.0 * 1.99 * radius;
    ShearBox box = wide;
    NeighbourList list(0.0, 0.2 * radius);
    list.rebuild(p, box);
    make_pair_forces(law, NoColloid{}, 1)->evaluate(p, box, list, 1e-3, false);
    EXPECT_NEAR(list.spring_y[0], 0.0, 1e-18);
}

TEST(HookeContact, energy_is_conserved_without_damping) {
    // 200 spheres in a periodic box, elastic and frictionless: kinetic plus spring energy.
    const laws::contact::Hooke law{.normal_stiffness = 1e3};
    ShearBox box{
        .length_x = 14 * radius, .length_y = 14 * radius, .length_z = 14 * radius, .walls = false};
    ParticleStore p;
    for (int k = 0; k < 216; ++k)
        p.add((2.3 * (k % 6) + 0.5) * radius, (2.3 * (k / 6 % 6) + 0.5) * radius,
              (2.3 * (k / 36) + 0.5) * radius, radius, density);
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.vx[i] = 0.05 * std::sin(1.0 + 13.0 * static_cast<double>(i));
        p.vy[i] = 0.05 * std::cos(2.0 + 7.0 * static_cast<double>(i));
        p.vz[i] = 0.05 * std::sin(3.0 + 3.0 * static_cast<double>(i));
    }
    const auto energy = [&] {
        double sum = 0.0;
        for (std::size_t i = 0; i < p.size(); ++i)
            sum += 0.5 * p.mass[i] * (p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i] + p.vz[i] * p.vz[i]);
        const NearestImage nearest(box);
        for (std::size_t i = 0; i < p.size(); ++i)
            for (std::size_t j = i + 1; j < p.size(); ++j) {
                double dx = p.x[j] - p.x[i], dy = p.y[j] - p.y[i], dz = p.z[j] - p.z[i];
                nearest(dx, dy, dz);
                const double overlap = 2 * radius - std::sqrt(dx * dx + dy * dy + dz * dz);
                if (overlap > 0.0)
                    sum += 0.5 * 1e3 * overlap * overlap;
            }
        return sum;
    };
    NeighbourList list(0.0, 0.1 * radius);
    list.rebuild(p, box);
    const auto forces = make_pair_forces(law, NoColloid{}, 1);
    const double step = 0.01 * law.duration(0.5 * p.mass[0]);
    const double start = energy();
    double worst = 0.0;
    long contacts = 0;
    for (int k = 0; k < 4000; ++k) {
        if (list.is_stale_after(p, kick_and_drift(p, step, 0.0, 1), 0.0))
            list.rebuild(p, box);
        clear_forces(p);
        contacts += forces->evaluate(p, box, list, step, false).contacts;
        kick(p, step, 1);
        if (k % 50 == 0)
            worst = std::max(worst, std::abs(energy() / start - 1.0));
    }
    EXPECT_GT(contacts, 10000) << "they must collide for the test to mean something";
    EXPECT_GT(list.rebuilds(), 5);
    // Verlet's energy oscillates within a contact by about (omega step)^2 / 8 = 1e-4 of the part in
    // springs, and does not drift.
    EXPECT_LT(worst, 2e-4);
    EXPECT_NEAR(energy() / start, 1.0, 1e-4);
}

TEST(Contact, a_pressed_packing_is_summed_alike_in_every_way) {
    // A fresh sum picks the pairs that touch, one that has seen them looks at every listed pair:
    // the same digits. Radii differ, all parts of the law act, and a few threads share the pairs.
    const ShearBox cube{
        .length_x = 14 * radius, .length_y = 14 * radius, .length_z = 14 * radius, .walls = false};
    for (const double rolling : {0.0, 0.1})
        for (const int threads : {1, 3}) {
            const laws::contact::Hooke law{.normal_stiffness = 1e3,
                                           .tangential_stiffness = 300.0,
                                           .damping_ratio = 0.1,
                                           .friction = 0.4,
                                           .rolling_friction = rolling};
            ShearBox box = cube;
            ParticleStore p = random_packing(
                {.sizes = {{2 * radius, 1.0}}, .volume_fraction = 0.58, .density = density}, box);
            for (std::size_t i = 0; i < p.size(); ++i) {
                const double turn = static_cast<double>(i);
                p.radius[i] *= 1.03 + 0.01 * std::sin(turn);
                p.vx[i] = 0.1 * std::sin(7.0 * turn);
                p.wy[i] = 100.0 * std::cos(3.0 * turn);
                p.wz[i] = 50.0 * std::sin(2.0 * turn);
            }
            NeighbourList list(0.0, 0.05 * radius);
            list.rebuild(p, box);
            const double step = 0.02 * law.duration(0.5 * p.mass[0]);
            const auto seasoned = make_pair_forces(law, NoColloid{}, threads);
            for (int k = 0; k < 40; ++k) {
                if (list.is_stale_after(p, kick_and_drift(p, step, 0.0, 1), 0.0))
                    list.rebuild(p, box);
                clear_forces(p);
                ParticleStore copy = p;
                NeighbourList copied_list = list;
                const PairSums sums = seasoned->evaluate(p, box, list, step, true);
                ASSERT_GT(2 * sums.contacts, static_cast<long>(list.size()));
                const PairSums fresh = make_pair_forces(law, NoColloid{}, threads)
                                           ->evaluate(copy, box, copied_list, step, true);
                EXPECT_EQ(sums.contacts, fresh.contacts);
                EXPECT_EQ(sums.contact, fresh.contact);
                EXPECT_EQ(sums.largest_overlap, fresh.largest_overlap);
                EXPECT_EQ(sums.deepest_first, fresh.deepest_first);
                for (std::size_t c = 0; c < p.columns().size(); ++c)
                    ASSERT_EQ(*p.columns()[c], *copy.columns()[c]) << c << ' ' << k;
                ASSERT_EQ(list.spring_x, copied_list.spring_x);
                ASSERT_EQ(list.spring_z, copied_list.spring_z);
                kick(p, step, 1);
                // Action is reaction.
                double fx = 0.0, size = 0.0;
                for (std::size_t i = 0; i < p.size(); ++i) {
                    fx += p.fx[i];
                    size += std::abs(p.fx[i]);
                }
                EXPECT_LT(std::abs(fx), 1e-13 * size);
            }
        }
}

} // namespace
} // namespace searle::solvers::particles
