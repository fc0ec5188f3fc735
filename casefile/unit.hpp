#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace searle::casefile {

/// Powers of the base units. The angle counts as one of them, so that rad/s is not 1/s.
struct Dimension {
    std::int8_t length{};
    std::int8_t mass{};
    std::int8_t time{};
    std::int8_t current{};
    std::int8_t temperature{};
    std::int8_t amount{};
    std::int8_t luminosity{};
    std::int8_t angle{};

    friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
};

/// What a unit's text means: value in SI = (number 10^decimal_exponent) factor + offset.
struct Unit {
    Dimension dimension;
    /// Apart from the factor, so that "20.38 mm" becomes the double nearest to 0.02038.
    int decimal_exponent{};
    double factor = 1.0;
    double offset{}; ///< other than 0 for degC and degF only
};

struct UnknownUnit {
    std::string reason;
};

/// Reads a unit: what UDUNITS-2 knows ("mPa.s", "kg/m^3", "rpm", "m s-1", "µm"), and the spellings
/// of rheometry that it lacks: cP, P, deg, rev, dyn, Nm, mNm, Pas, mPas, M (mol/l), superscripts;
/// "1/min" and "min^-1" are turns per minute, as on the instruments, not a shear rate.
/// Units that nearly every case has are known by heart (common_units.hpp). The first other one
/// loads the unit database (3 ms); later calls for the same text cost a look-up. Throws
/// std::runtime_error when the database of UDUNITS-2 is needed and not installed.
[[nodiscard]] std::variant<Unit, UnknownUnit> unit_named(std::string_view text);

/// The same from the database, whatever the text.
[[nodiscard]] std::variant<Unit, UnknownUnit> unit_of_database(std::string_view text);

} // namespace searle::casefile
