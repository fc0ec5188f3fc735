#include "rheometry/conversion/conversion.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace searle::rheometry {
namespace {

constexpr double pi = std::numbers::pi;

constexpr std::array definition_names{
    std::pair{RateDefinition::bob_wall, std::string_view{"bob-wall"}},
    std::pair{RateDefinition::iso_3219, std::string_view{"iso-3219"}},
    std::pair{RateDefinition::mean_radius, std::string_view{"mean-radius"}}};

/// The difference of squares as a product: the relative error stays that of the radii's difference
/// however narrow the gap is.
double difference_of_squares(double larger, double smaller) {
    return (larger - smaller) * (larger + smaller);
}

/// R_i^2 R_o^2 / (R_o^2 - R_i^2), m^2: a gap's Newtonian torque is 4 pi eta omega L times this.
double gap_area(double inner, double outer) {
    return inner * inner * outer * outer / difference_of_squares(outer, inner);
}

struct Factors {
    double stress_per_torque; ///< before the end factor
    double rate_per_speed;
};

/// Newtonian flow in a gap: stress M / (2 pi L r^2), rate 2 omega R_b^2 R_c^2 / ((R_c^2 - R_b^2)
/// r^2).
Factors values_at_radius(double bob, double cup, double length, double radius) {
    const double area = radius * radius;
    return {1.0 / (2.0 * pi * length * area), 2.0 * gap_area(bob, cup) / area};
}

Factors single_gap_factors(RateDefinition definition, double bob, double cup, double length) {
    switch (definition) {
    case RateDefinition::bob_wall:
        return values_at_radius(bob, cup, length, bob);
    case RateDefinition::mean_radius:
        return values_at_radius(bob, cup, length, 0.5 * (bob + cup));
    case RateDefinition::iso_3219:
        break;
    }
    const Factors at_bob = values_at_radius(bob, cup, length, bob);
    const Factors at_cup = values_at_radius(bob, cup, length, cup);
    return {0.5 * (at_bob.stress_per_torque + at_cup.stress_per_torque),
            0.5 * (at_bob.rate_per_speed + at_cup.rate_per_speed)};
}

struct FactorsOf {
    RateDefinition definition;

    Factors operator()(const geometry::ConcentricCylinders& gap) const {
        return single_gap_factors(definition, gap.bob_radius, gap.cup_radius, gap.height);
    }
    Factors operator()(const geometry::DinBob& bob) const {
        return single_gap_factors(definition, bob.bob_radius, bob.cup_radius, bob.height());
    }
    Factors operator()(const geometry::DoubleGap& gap) const {
        const auto& [post, inside, outside, cup] = gap.radii;
        const double rate = (outside * outside + cup * cup) / difference_of_squares(cup, outside);
        const double areas = gap_area(post, inside) + gap_area(outside, cup);
        return {rate / (4.0 * pi * gap.height * areas), rate};
    }
    Factors operator()(const geometry::Box& box) const {
        return {1.0 / box.wall_area(), 1.0 / box.gap};
    }
};

struct RotorWallStress {
    double operator()(const geometry::ConcentricCylinders& gap) const {
        return 1.0 / (2.0 * pi * gap.height * gap.bob_radius * gap.bob_radius);
    }
    double operator()(const geometry::DinBob& bob) const {
        return 1.0 / (2.0 * pi * bob.height() * bob.bob_radius * bob.bob_radius);
    }
    double operator()(const geometry::DoubleGap& gap) const {
        const auto& [post, inside, outside, cup] = gap.radii;
        const double outer = gap_area(outside, cup);
        const double share = outer / (gap_area(post, inside) + outer);
        return share / (2.0 * pi * gap.height * outside * outside);
    }
    double operator()(const geometry::Box& box) const { return 1.0 / box.wall_area(); }
};

void require_end_factor(double end_factor) {
    if (!(std::isfinite(end_factor) && end_factor > 0.0))
        throw std::invalid_argument(
            fmt::format("the end factor must be a number above 0, not {}", end_factor));
}

std::string_view meaning_of(RateDefinition definition) {
    switch (definition) {
    case RateDefinition::bob_wall:
        return "values at the bob's wall";
    case RateDefinition::iso_3219:
        return "mean of the two wall values";
    case RateDefinition::mean_radius:
        return "values at the mean radius";
    }
    return {};
}

} // namespace

std::string_view name_of(RateDefinition definition) {
    for (const auto& [value, name] : definition_names)
        if (value == definition)
            return name;
    return {};
}

std::optional<RateDefinition> definition_named(std::string_view name) {
    for (const auto& [value, known] : definition_names)
        if (known == name)
            return value;
    return std::nullopt;
}

RateDefinition default_definition(const geometry::Instrument& instrument) {
    return std::holds_alternative<geometry::ConcentricCylinders>(instrument)
               ? RateDefinition::bob_wall
               : RateDefinition::iso_3219;
}

bool has_definition(const geometry::Instrument& instrument, RateDefinition definition) {
    return definition == RateDefinition::iso_3219 ||
           std::holds_alternative<geometry::ConcentricCylinders>(instrument) ||
           std::holds_alternative<geometry::DinBob>(instrument);
}

double default_end_factor(const geometry::Instrument& instrument) {
    return std::holds_alternative<geometry::DinBob>(instrument) ? 1.10 : 1.0;
}

Conversion conversion_for(const geometry::Instrument& instrument,
                          const ConversionSettings& settings) {
    const RateDefinition definition = settings.definition.value_or(default_definition(instrument));
    if (!has_definition(instrument, definition))
        throw std::invalid_argument(fmt::format("a {} has no definition {}; its only one is {}",
                                                geometry::name_of(instrument), name_of(definition),
                                                name_of(default_definition(instrument))));
    const double end_factor = settings.end_factor.value_or(default_end_factor(instrument));
    require_end_factor(end_factor);
    const Factors factors = std::visit(FactorsOf{definition}, instrument);
    return {.definition = definition,
            .end_factor = end_factor,
            .end_factor_provisional = settings.end_factor_computed && !settings.end_factor,
            .stress_per_torque = factors.stress_per_torque / end_factor,
            .rate_per_speed = factors.rate_per_speed};
}

double rotor_wall_stress_per_torque(const geometry::Instrument& instrument, double end_factor) {
    require_end_factor(end_factor);
    return std::visit(RotorWallStress{}, instrument) / end_factor;
}

std::string describe(const Conversion& conversion, const geometry::Instrument& instrument) {
    if (!geometry::rotates(instrument))
        return fmt::format(
            "{} (force over area, speed over gap), c_L = {}: {:.9g} Pa per N, {:.9g} 1/s "
            "per m/s",
            name_of(conversion.definition), conversion.end_factor, conversion.stress_per_torque,
            conversion.rate_per_speed);
    const std::string_view meaning = std::holds_alternative<geometry::DoubleGap>(instrument)
                                         ? "exact for a Newtonian fluid in both gaps together"
                                         : meaning_of(conversion.definition);
    return fmt::format("{} ({}), c_L = {}: {:.9g} Pa per N m, {:.9g} 1/s per rad/s",
                       name_of(conversion.definition), meaning, conversion.end_factor,
                       conversion.stress_per_torque, conversion.rate_per_speed);
}

} // namespace searle::rheometry
