#pragma once

#include "solvers/suspension/lubrication_pairs.hpp"

namespace searle::solvers::suspension {

/// The resistance of near pairs as columns, for many products with motions. Eight pairs at a time:
/// their particles are read as rows and turned into columns, the law goes over whole registers.
class PairResistance {
public:
    /// @param threads  1 or more; each sums forces of its own, added in a fixed order
    explicit PairResistance(int threads) : threads_(threads) {}

    /// Takes the pairs' films and springs. @param count particles
    void take(const particles::AlignedVector<NearPair>& pairs, std::size_t count);

    /// Adds R times the motions: what resists them, positive along them.
    /// @param motions, forces  motions_for(count) of them
    void add(const Motions& motions, Motions& forces);

private:
    static constexpr std::size_t lanes = 8;
    void add_pairs(std::size_t begin, std::size_t end, const Motions& motions,
                   Motions& forces) const;

    int threads_;
    particles::AlignedVector<int> first_, second_;
    particles::Column nx_, ny_, nz_, lever_first_, lever_second_;
    particles::Column squeeze_, shear_, mixed_, pump_, twist_;
    std::vector<Motions> others_; ///< forces of the threads after the first
};

} // namespace searle::solvers::suspension
