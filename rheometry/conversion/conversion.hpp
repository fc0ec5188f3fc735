#pragma once

#include "geometry/instrument.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace searle::rheometry {

/// Which shear rate and stress of the gap an instrument reports (physics of each:
/// docs/conversion.md).
enum class RateDefinition {
    bob_wall,   ///< values at the bob's wall
    iso_3219,   ///< ISO 3219 / DIN 53019 "representative": the mean of the two wall values
    mean_radius ///< values at (R_bob + R_cup) / 2
};

/// The name in case files: bob-wall, iso-3219 or mean-radius.
[[nodiscard]] std::string_view name_of(RateDefinition definition);

/// The inverse of name_of; no value for any other text.
[[nodiscard]] std::optional<RateDefinition> definition_named(std::string_view name);

/// Single gap: bob-wall; DIN bob and double gap: iso-3219; box: iso-3219, since its stress and rate
/// are the same everywhere, and so is their mean over the walls.
[[nodiscard]] RateDefinition default_definition(const geometry::Instrument& instrument);

/// True for all three with a single gap or a DIN bob; the double gap and the box have iso-3219
/// only.
[[nodiscard]] bool has_definition(const geometry::Instrument& instrument,
                                  RateDefinition definition);

/// c_L where none is given: 1.10 for the DIN bob (ISO 3219), else 1.
[[nodiscard]] double default_end_factor(const geometry::Instrument& instrument);

/// What the case file asks for; an absent definition means the instrument's default.
struct ConversionSettings {
    std::optional<RateDefinition> definition{};
    /// c_L, > 0; absent means the instrument's default (1.10 for the DIN bob, else 1).
    std::optional<double> end_factor{};
    /// c_L is to be computed for this bob and fluid.
    bool end_factor_computed = false;
};

/// The two factors, and where they come from.
struct Conversion {
    RateDefinition definition{};
    double end_factor = 1.0;
    /// True when a computed c_L was asked for and none is known yet: end_factor is then the
    /// instrument's default, good for rates and for planning, not for a stress that is reported.
    bool end_factor_provisional = false;
    /// Pa per N m (per N for the box); end_factor and wetted length included.
    double stress_per_torque{};
    /// (1/s) per rad/s (per m/s for the box).
    double rate_per_speed{};

    [[nodiscard]] double shear_stress(double torque) const { return stress_per_torque * torque; }
    [[nodiscard]] double shear_rate(double speed) const { return rate_per_speed * speed; }
    [[nodiscard]] double speed(double shear_rate) const { return shear_rate / rate_per_speed; }
};

/// The instrument's conversion. Throws std::invalid_argument for a definition that the instrument
/// does not have, and for an end factor that is not a number above 0.
[[nodiscard]] Conversion conversion_for(const geometry::Instrument& instrument,
                                        const ConversionSettings& settings);

/// Stress at the rotor's wall over the torque (over the force for the box), Pa per N m: for the
/// double gap the Newtonian stress at the rotor's outer wall. The ends are taken out by
/// `end_factor`, as in the conversion.
[[nodiscard]] double rotor_wall_stress_per_torque(const geometry::Instrument& instrument,
                                                  double end_factor);

/// One line for people, e.g. "iso-3219 (mean of the two wall values), c_L = 1.1: 16243.27 Pa per
/// N m, 12.187215 1/s per rad/s".
[[nodiscard]] std::string describe(const Conversion& conversion,
                                   const geometry::Instrument& instrument);

} // namespace searle::rheometry
