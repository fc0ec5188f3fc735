#pragma once

#include "laws/colloid/double_layer.hpp"
#include "laws/colloid/hamaker.hpp"

#include <algorithm>

namespace searle::laws::colloid {

/// Derjaguin & Landau 1941, Verwey & Overbeek 1948: attraction after Hamaker plus the repulsion of
/// the double layers. Below `minimum_separation` the force stays at its value there (surfaces are
/// rough); beyond `cutoff` it is 0 (the potential's step there, not the force's integral, is lost).
template <class Layer>
struct Dlvo {
    Hamaker<double> attraction;
    Layer layer;
    double minimum_separation{}; ///< m, > 0
    double cutoff{};             ///< m, surface distance

    /// Force that pushes apart, N, at any surface distance up to the cutoff, overlap included.
    [[nodiscard]] double repulsion(double h, double r_i, double r_j) const {
        const double distance = std::max(h, minimum_separation);
        return layer.repulsion(distance, r_i, r_j) - attraction.attraction(distance, r_i, r_j);
    }
    /// Energy at a surface distance >= minimum_separation, J.
    [[nodiscard]] double energy(double h, double r_i, double r_j) const {
        return layer.energy(h, r_i, r_j) + attraction.energy(h, r_i, r_j);
    }
};

/// The largest repulsion of a pair between minimum_separation and cutoff, and the energies on the
/// way in from the cutoff; found on a logarithmic grid of distances.
struct DlvoCurve {
    double largest_repulsion{}; ///< N; <= 0: the pair attracts everywhere
    double barrier{};           ///< J, largest energy
    double barrier_distance{};  ///< m, surface distance of it
    double secondary_minimum{}; ///< J, smallest energy farther out than the barrier; <= 0
    /// Largest rise of the repulsion on the way in, outside the barrier's distance, N/m.
    double largest_stiffness{};
};

template <class Layer>
[[nodiscard]] DlvoCurve dlvo_curve(const Dlvo<Layer>& dlvo, double r_i, double r_j) {
    constexpr int steps = 4000;
    DlvoCurve curve;
    const double ratio = dlvo.cutoff / dlvo.minimum_separation;
    double outer_force = 0.0;
    double outer_distance = dlvo.cutoff;
    curve.largest_repulsion = dlvo.repulsion(dlvo.cutoff, r_i, r_j);
    double lowest = 0.0;
    for (int k = steps; k >= 0; --k) {
        const double h = dlvo.minimum_separation * std::pow(ratio, static_cast<double>(k) / steps);
        const double energy = dlvo.energy(h, r_i, r_j);
        const double force = dlvo.repulsion(h, r_i, r_j);
        lowest = std::min(lowest, energy);
        curve.largest_repulsion = std::max(curve.largest_repulsion, force);
        if (energy > curve.barrier) {
            curve.barrier = energy;
            curve.barrier_distance = h;
            curve.secondary_minimum = lowest;
        }
        if (k < steps && force > 0.0)
            curve.largest_stiffness =
                std::max(curve.largest_stiffness, (force - outer_force) / (outer_distance - h));
        outer_force = force;
        outer_distance = h;
    }
    if (curve.barrier <= 0.0)
        curve.secondary_minimum = lowest;
    return curve;
}

} // namespace searle::laws::colloid
