#include "solvers/particles/motion.hpp"
#include "solvers/particles/pair_forces.hpp"
#include "tests/suspension/suspension_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace searle::solvers::particles {
namespace {

constexpr double radius = 1e-3;
constexpr double density = 2500.0;

laws::contact::Hertz elastic() { return {.shear_modulus = 1e7, .poisson_ratio = 0.3}; }

struct HeadOn {
    double restitution;
    double duration; ///< s
    double deepest;  ///< m
};

/// Two equal spheres that meet at `speed`, by velocity Verlet with a step of `share` of the elastic
/// contact.
HeadOn head_on(const laws::contact::Hertz& law, double speed, double share) {
    ParticleStore p;
    p.add(0.5, 0.5, 0.5, radius, density);
    p.add(0.5 + 2.0 * radius, 0.5, 0.5, radius, density);
    p.vx[0] = 0.5 * speed;
    p.vx[1] = -0.5 * speed;
    ShearBox box{.length_x = 1.0, .length_y = 1.0, .length_z = 1.0};
    NeighbourList list{0.0, 0.2 * radius};
    list.rebuild(p, box);
    const auto forces = make_pair_forces(law, NoColloid{}, 1);
    const double deepest = law.deepest_overlap(speed, 0.5 * radius, 0.5 * p.mass[0]);
    const double step = share * 2.94 * deepest / speed;
    HeadOn found{};
    double before = 0.0;
    for (int k = 0; k < static_cast<int>(1.5 / share); ++k) {
        if (list.is_stale_after(p, kick_and_drift(p, step, 0.0, 1), 0.0))
            list.rebuild(p, box);
        clear_forces(p);
        forces->evaluate(p, box, list, step, false);
        kick(p, step, 1);
        const double overlap = 2.0 * radius - (p.x[1] - p.x[0]);
        found.deepest = std::max(found.deepest, overlap);
        if (before > 0.0 && overlap <= 0.0)
            found.duration = step * (k + before / (before - overlap));
        before = overlap;
    }
    found.restitution = (p.vx[1] - p.vx[0]) / speed;
    return found;
}

/// Landau & Lifshitz, Theory of Elasticity, section 9: the contact lasts 2.943275 times the
/// deepest overlap over the speed, 2.943275 = (4/5) sqrt(pi) Gamma(2/5) / Gamma(9/10).
TEST(HertzContact, a_head_on_pair_has_hertzs_duration_and_depth) {
    constexpr double constant = 2.9432749;
    for (const double speed : {1e-3, 0.1}) {
        std::vector<double> errors;
        for (const double share : {0.02, 0.01, 0.005}) {
            const HeadOn found = head_on(elastic(), speed, share);
            const double deepest = elastic().deepest_overlap(
                speed, 0.5 * radius,
                0.5 * density * 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3));
            errors.push_back(std::abs(found.duration / (constant * deepest / speed) - 1.0));
            EXPECT_NEAR(found.deepest / deepest, 1.0, 2.0 * share * share + 1e-3 * share);
        }
        // Second order, as velocity Verlet.
        EXPECT_GT(errors[0] / errors[1], 3.0) << speed;
        EXPECT_GT(errors[1] / errors[2], 3.0) << speed;
        EXPECT_LT(errors[2], 3e-5);
    }
}

/// The same restitution at every speed (Tsuji et al. 1992; Antypov & Elliott 2011).
TEST(HertzContact, restitution_is_the_one_asked_for_at_every_speed) {
    for (const double restitution : {1.0, 0.9, 0.5})
        for (const double speed : {1e-3, 0.03, 1.0}) {
            laws::contact::Hertz law = elastic();
            law.damping_ratio = laws::contact::damping_ratio(restitution);
            // The contact ends between two steps: first order, with a sign that changes.
            for (const double share : {0.02, 0.01, 0.005, 0.0025})
                EXPECT_NEAR(head_on(law, speed, share).restitution, restitution, 0.1 * share)
                    << speed << ' ' << share;
        }
}

/// First the spring holds, k_t s, then it slides at friction times the normal force.
TEST(HertzContact, sliding_friction_is_coulombs) {
    laws::contact::Hertz law = elastic();
    law.friction = 0.3;
    ParticleStore p;
    p.add(0.5, 0.5, 0.5, radius, density);
    p.add(0.5 + 1.99 * radius, 0.5, 0.5, radius, density);
    ShearBox box{.length_x = 1.0, .length_y = 1.0, .length_z = 1.0};
    NeighbourList list(0.0, 0.2 * radius);
    list.rebuild(p, box);
    const auto forces = make_pair_forces(law, NoColloid{}, 1);
    p.vy[1] = 1e-3;
    const laws::contact::ContactSpring spring = law.at(0.01 * radius, 0.5 * radius, 1.0);
    const double normal = spring.normal * 0.01 * radius;
    for (const double travelled : {0.1, 0.99, 1.5}) {
        for (Column* each : {&list.spring_x, &list.spring_y, &list.spring_z})
            each->assign(1, 0.0);
        clear_forces(p);
        const double limit_travel = law.friction * normal / spring.tangential;
        forces->evaluate(p, box, list, travelled * limit_travel / 1e-3, false);
        // Round-off of the places, 1e-16, over the overlap, 1e-5, times 3/2.
        EXPECT_NEAR(p.fy[1] / (-law.friction * normal), std::min(travelled, 1.0), 5e-11);
        EXPECT_NEAR(p.fx[1] / normal, 1.0, 5e-11);
        EXPECT_EQ(p.fy[0], -p.fy[1]);
    }
}

} // namespace
} // namespace searle::solvers::particles
