#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace searle::solvers::suspension {

/// Equal linear elements from wall to wall; one node more than elements.
struct LinearElements {
    double spacing{}; ///< m
    int cells{};

    LinearElements(double gap, int count) : spacing(gap / count), cells(count) {}

    struct Place {
        std::size_t element{};
        double upper{}; ///< weight of its upper node
        [[nodiscard]] double lower() const { return 1.0 - upper; }
    };
    /// What lies beyond a wall counts as at it.
    [[nodiscard]] Place place(double y) const {
        const double at = std::clamp(y / spacing, 0.0, static_cast<double>(cells));
        const int element = std::min(static_cast<int>(at), cells - 1);
        return {static_cast<std::size_t>(element), at - element};
    }
    /// Velocities at the nodes in uniform shear with the upper wall at `wall_speed`.
    [[nodiscard]] std::vector<double> uniform_shear(double wall_speed) const {
        std::vector<double> velocity(static_cast<std::size_t>(cells) + 1);
        for (std::size_t k = 0; k < velocity.size(); ++k)
            velocity[k] = wall_speed * static_cast<double>(k) / cells;
        return velocity;
    }
};

} // namespace searle::solvers::suspension
