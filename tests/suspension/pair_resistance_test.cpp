#include "solvers/suspension/pair_resistance.hpp"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace searle::solvers::suspension {
namespace {

using Vector = Eigen::Vector3d;

Vector of(const Motion& motion, int from) {
    return {motion[static_cast<std::size_t>(from)], motion[static_cast<std::size_t>(from) + 1],
            motion[static_cast<std::size_t>(from) + 2]};
}

constexpr std::size_t count = 40;

/// Pairs at random, some of them with a wall; any numbers that a film may have.
particles::AlignedVector<NearPair> random_pairs(std::size_t number) {
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> between(0.1, 1.0);
    std::uniform_int_distribution<int> any(0, static_cast<int>(count) - 1);
    particles::AlignedVector<NearPair> pairs;
    while (pairs.size() < number) {
        NearPair pair{};
        pair.first = any(engine);
        pair.second =
            pairs.size() % 5 == 0 ? static_cast<int>(count + pairs.size() % 2) : any(engine);
        if (pair.first == pair.second)
            continue;
        const Vector n =
            Vector(between(engine) - 0.5, between(engine), between(engine) - 0.3).normalized();
        pair.nx = n.x();
        pair.ny = n.y();
        pair.nz = n.z();
        pair.lever_first = between(engine);
        pair.lever_second = between(engine);
        pair.squeeze = between(engine);
        pair.shear = between(engine);
        pair.mixed = 0.1 * between(engine);
        pair.pump = between(engine);
        pair.twist = between(engine);
        pairs.push_back(pair);
    }
    return pairs;
}

Motions random_motions(unsigned seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> number;
    Motions motions(motions_for(count), Motion{});
    for (std::size_t i = 0; i < count; ++i) // walls stand
        for (std::size_t c = 0; c < 6; ++c)
            motions[i][c] = number(engine);
    return motions;
}

double dot(const Motions& a, const Motions& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t c = 0; c < 8; ++c)
            sum += a[i][c] * b[i][c];
    return sum;
}

Motions resistance(const particles::AlignedVector<NearPair>& pairs, const Motions& motions,
                   int threads = 1) {
    PairResistance operation(threads);
    operation.take(pairs, count);
    Motions forces(motions.size(), Motion{});
    operation.add(motions, forces);
    return forces;
}

/// As laws/lubrication/near_contact.hpp defines the films: by the power that they lose.
double power(const particles::AlignedVector<NearPair>& pairs, const Motions& motions) {
    double sum = 0.0;
    for (const NearPair& pair : pairs) {
        const Vector n(pair.nx, pair.ny, pair.nz);
        const Motion& a = motions[static_cast<std::size_t>(pair.first)];
        const Motion& b = motions[static_cast<std::size_t>(pair.second)];
        const Vector apart = of(b, 0) - of(a, 0);
        const Vector spin = of(b, 3) - of(a, 3);
        const double along = apart.dot(n);
        const Vector slip = apart - along * n -
                            (pair.lever_first * of(a, 3) + pair.lever_second * of(b, 3)).cross(n);
        const Vector roll = spin.cross(n);
        sum += pair.squeeze * along * along + pair.shear * slip.squaredNorm() +
               2.0 * pair.mixed * slip.dot(roll) + pair.pump * roll.squaredNorm() +
               pair.twist * std::pow(spin.dot(n), 2);
    }
    return sum;
}

// A symmetric operator is known by the power of all motions.
TEST(PairResistance, loses_the_power_that_defines_the_films_and_is_symmetric) {
    for (const std::size_t number : {1U, 7U, 8U, 9U, 203U}) {
        const auto pairs = random_pairs(number);
        const Motions one = random_motions(1);
        const Motions two = random_motions(2);
        EXPECT_NEAR(dot(one, resistance(pairs, one)) / power(pairs, one), 1.0, 1e-12) << number;
        const double scale = std::sqrt(power(pairs, one) * power(pairs, two));
        EXPECT_NEAR(dot(one, resistance(pairs, two)), dot(two, resistance(pairs, one)),
                    1e-12 * scale)
            << number;
    }
}

TEST(PairResistance, is_the_same_with_more_threads_but_for_rounding) {
    const auto pairs = random_pairs(203);
    const Motions motions = random_motions(3);
    const Motions one = resistance(pairs, motions);
    for (const int threads : {2, 3}) {
        const Motions more = resistance(pairs, motions, threads);
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < 6; ++c)
                EXPECT_NEAR(more[i][c], one[i][c], 1e-12);
        EXPECT_EQ(resistance(pairs, motions, threads), more) << "again, bit for bit";
    }
}

} // namespace
} // namespace searle::solvers::suspension
