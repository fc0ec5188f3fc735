#include "solvers/suspension/overlap_check.hpp"

#include "solvers/suspension/suspension_motion.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace searle::solvers::suspension {

void check_overlaps(const particles::PairSums& pairs, const particles::WallSums& walls,
                    const particles::ParticleStore& particles, const ParticleSettings& settings,
                    double time, std::optional<double> step) {
    constexpr double deepest_share = 0.2; // of the smallest radius
    const double least = *std::ranges::min_element(particles.radius);
    const double overlap = std::max(pairs.largest_overlap, walls.largest_overlap);
    if (overlap <= deepest_share * least)
        return;
    const std::string who =
        pairs.largest_overlap >= walls.largest_overlap
            ? fmt::format("particles {} and {}", pairs.deepest_first, pairs.deepest_second)
            : fmt::format("particle {} and a wall", walls.deepest);
    const std::string also =
        step ? fmt::format(", or the step of {:.3g} s too long (particles.time_step)", *step) : "";
    throw StepFailure(fmt::format(
        "{} overlap by {:.3g} m at t = {:.6g} s, {:.2g} of the smallest radius: the contact is too "
        "soft for the forces on it ({}){}",
        who, overlap, time, overlap / least, stiffness_key(settings), also));
}

} // namespace searle::solvers::suspension
