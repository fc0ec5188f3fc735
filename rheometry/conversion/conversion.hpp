#pragma once

#include "geometry/instrument.hpp"

#include <optional>
#include <string_view>

namespace searle::rheometry {

/// Which shear rate and stress of the gap an instrument reports (physics of each: docs/conversion.md).
enum class RateDefinition {
    bob_wall,   ///< values at the bob's wall
    iso_3219,   ///< ISO 3219 / DIN 53019 "representative": the mean of the two wall values
    mean_radius ///< values at (R_bob + R_cup) / 2
};

[[nodiscard]] std::string_view name_of(RateDefinition definition);

/// What the case file asks for; an absent definition means the instrument's default.
struct ConversionSettings {
    std::optional<RateDefinition> definition;
    /// c_L; absent means the instrument's default (1.10 for the DIN bob, else 1).
    std::optional<double> end_factor;
    /// c_L is to be computed for this bob and fluid.
    bool end_factor_computed = false;
};

/// The two factors, and where they come from.
struct Conversion {
    RateDefinition definition{};
    double end_factor = 1.0;
    /// Pa per N m (per N for the box); end_factor and wetted length included.
    double stress_per_torque{};
    /// (1/s) per rad/s (per m/s for the box).
    double rate_per_speed{};

    [[nodiscard]] double shear_stress(double torque) const { return stress_per_torque * torque; }
    [[nodiscard]] double shear_rate(double speed) const { return rate_per_speed * speed; }
    [[nodiscard]] double speed(double shear_rate) const { return shear_rate / rate_per_speed; }
};

/// The instrument's conversion. Throws std::invalid_argument for a definition that the instrument
/// does not have (the double gap and the box have one each).
[[nodiscard]] Conversion conversion_for(const geometry::Instrument& instrument,
                                        const ConversionSettings& settings);

} // namespace searle::rheometry
