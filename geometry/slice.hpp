#pragma once

#include <numbers>

namespace searle::geometry {

/// The part of an instrument that a mesh holds.
struct Slice {
    double angle = 2.0 * std::numbers::pi; ///< rad, 0 < angle <= 2 pi
    double height{};                       ///< m, of the meshed part of the cylinder
    double instrument_height{};            ///< m, that the torque is for

    /// Torque of the instrument over torque on the slice, >= 1: the only place where it is said.
    [[nodiscard]] constexpr double factor() const {
        return 2.0 * std::numbers::pi / angle * (instrument_height / height);
    }
};

} // namespace searle::geometry
