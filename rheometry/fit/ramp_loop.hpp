#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace searle::rheometry::fit {

/// The area between the ways up and down of a ramp, in the unit of stress times rate (Pa/s: power
/// per volume) when rates and stresses are given; positive when the way up lies above.
struct RampLoop {
    std::size_t turning_row{}; ///< the fastest row
    double low_rate{};         ///< rates that both ways cover, 1/s
    double high_rate{};
    double measured{};       ///< area of the measured stresses
    double inertial{};       ///< area that the fluid's inertia alone gives
    double standard_error{}; ///< of `measured`, from the scatter from row to row

    /// What inertia leaves: thixotropy, or another history of the sample.
    [[nodiscard]] double rest() const { return measured - inertial; }
};

/// @param rates     1/s, in the order in which they were measured, > 0; once up and once down (or
///                  down and up), 5 rows or more each way; anything else gives no loop
/// @param stresses  Pa, as many
/// @param inertial  part of each stress that is the fluid's inertia, Pa, as many
[[nodiscard]] std::optional<RampLoop> ramp_loop(std::span<const double> rates,
                                                std::span<const double> stresses,
                                                std::span<const double> inertial);

} // namespace searle::rheometry::fit
