#include "casefile/unit.hpp"

#include "casefile/common_units.hpp"
#include "casefile/unit_spelling.hpp"

#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <udunits2.h>

namespace searle::casefile {
namespace {

struct FreeSystem {
    void operator()(ut_system* system) const { ut_free_system(system); }
};
struct FreeUnit {
    void operator()(ut_unit* unit) const { ut_free(unit); }
};

struct Collected {
    Unit unit;
    bool linear = true; ///< false for decibels and calendar times
};

std::int8_t* power_of(Dimension& dimension, const char* base_unit) {
    struct Base {
        const char* name;
        std::int8_t Dimension::*power;
    };
    static constexpr Base bases[] = {
        {"meter", &Dimension::length},       {"kilogram", &Dimension::mass},
        {"second", &Dimension::time},        {"ampere", &Dimension::current},
        {"kelvin", &Dimension::temperature}, {"mole", &Dimension::amount},
        {"candela", &Dimension::luminosity}, {"radian", &Dimension::angle},
    };
    for (const Base& base : bases)
        if (std::strcmp(base.name, base_unit) == 0)
            return &(dimension.*base.power);
    return nullptr;
}

ut_status visit_product(const ut_unit*, int count, const ut_unit* const* base_units,
                        const int* powers, void* argument) {
    auto& collected = *static_cast<Collected*>(argument);
    for (int at = 0; at < count; ++at) {
        const char* name = ut_get_name(base_units[at], UT_ASCII);
        std::int8_t* power = name ? power_of(collected.unit.dimension, name) : nullptr;
        if (!power || std::abs(powers[at]) > 100)
            return UT_VISIT_ERROR;
        *power = static_cast<std::int8_t>(powers[at]);
    }
    return UT_SUCCESS;
}

ut_status visit_basic(const ut_unit* unit, void* argument) {
    const int first_power = 1;
    return visit_product(unit, 1, &unit, &first_power, argument);
}

extern const ut_visitor collector;

ut_status visit_galilean(const ut_unit*, double scale, const ut_unit* underlying, double offset,
                         void* argument) {
    auto& unit = static_cast<Collected*>(argument)->unit;
    unit.factor *= scale;
    unit.offset += scale * offset;
    return ut_accept_visitor(underlying, &collector, argument);
}

ut_status visit_timestamp(const ut_unit*, const ut_unit*, double, void* argument) {
    static_cast<Collected*>(argument)->linear = false;
    return UT_SUCCESS;
}

ut_status visit_logarithmic(const ut_unit*, double, const ut_unit*, void* argument) {
    static_cast<Collected*>(argument)->linear = false;
    return UT_SUCCESS;
}

const ut_visitor collector{visit_basic, visit_product, visit_galilean, visit_timestamp,
                           visit_logarithmic};

bool is_gap(char sign) { return std::string_view{" ./*("}.find(sign) != std::string_view::npos; }

/// True where the text before a digit makes its number a factor instead of a power.
bool is_factor(std::string_view before) {
    if (before.empty() || (is_gap(before.back()) && !before.ends_with("**")))
        return true;
    if (before.ends_with("per")) {
        before.remove_suffix(3);
        return before.empty() || !std::isalpha(static_cast<unsigned char>(before.back()));
    }
    const bool is_signed = before.back() == '+' || before.back() == '-';
    return is_signed && is_factor(before.substr(0, before.size() - 1));
}

/// A number that is no power: UDUNITS takes "000 mm" and "60 s" as units, in a case file they are
/// slips. A power of 0 is one, too, and where letters follow it UDUNITS loses memory.
bool holds_loose_number(std::string_view unit) {
    if (unit.starts_with("1/") || unit.starts_with("1 /"))
        unit.remove_prefix(1);
    for (std::size_t at = 0; at < unit.size(); ++at) {
        if (std::isdigit(static_cast<unsigned char>(unit[at])) == 0)
            continue;
        const std::string_view before = unit.substr(0, at);
        const bool goes_on =
            !before.empty() && std::isdigit(static_cast<unsigned char>(before.back()));
        const bool in_name = before.ends_with('_'); // mercury_0C
        if (is_factor(before) || (unit[at] == '0' && !goes_on && !in_name))
            return true;
    }
    return false;
}

/// UDUNITS reads "m) and more" as m, and '@' as a shift of the origin.
bool is_well_formed(std::string_view spelling) {
    int open = 0;
    for (const char sign : spelling) {
        if (sign == '(')
            ++open;
        if (sign == ')' && --open < 0)
            return false;
        if (!std::isalnum(static_cast<unsigned char>(sign)) &&
            std::string_view{"_.*/^-+ ()%"}.find(sign) == std::string_view::npos)
            return false;
    }
    return open == 0;
}

void split_off_power_of_ten(Unit& unit) {
    const int exponent = static_cast<int>(std::lround(std::log10(std::abs(unit.factor))));
    const double rest = unit.factor / std::pow(10.0, exponent);
    if (std::abs(rest - 1.0) <= 8.0 * std::numeric_limits<double>::epsilon()) {
        unit.decimal_exponent = exponent;
        unit.factor = 1.0;
    }
}

class UnitLibrary {
public:
    UnitLibrary() {
        ut_set_error_message_handler(ut_ignore);
        system_.reset(ut_read_xml(nullptr));
        if (!system_)
            throw std::runtime_error("the unit database of UDUNITS-2 cannot be read; the package "
                                     "libudunits2-data holds it");
    }

    std::variant<Unit, UnknownUnit> unit(std::string_view text) {
        const auto known = known_.find(text);
        if (known != known_.end())
            return known->second;
        const std::variant<Unit, UnknownUnit> found = parse(text);
        // A file full of nonsense must not fill the memory.
        if (known_.size() < 1000)
            known_.emplace(text, found);
        return found;
    }

private:
    std::variant<Unit, UnknownUnit> parse(std::string_view text) const {
        if (holds_loose_number(ascii_signs(text)))
            return UnknownUnit{"holds a number"};
        const std::string spelling = udunits_spelling(text);
        if (!is_well_formed(spelling))
            return UnknownUnit{"is not known"};
        const std::unique_ptr<ut_unit, FreeUnit> parsed{
            ut_parse(system_.get(), spelling.c_str(), UT_ASCII)};
        Collected collected;
        if (!parsed || ut_accept_visitor(parsed.get(), &collector, &collected) != UT_SUCCESS)
            return UnknownUnit{"is not known"};
        if (!collected.linear || !(collected.unit.factor > 0.0) ||
            !std::isfinite(collected.unit.factor))
            return UnknownUnit{"cannot be used here"};
        split_off_power_of_ten(collected.unit);
        return collected.unit;
    }

    std::unique_ptr<ut_system, FreeSystem> system_;
    std::map<std::string, std::variant<Unit, UnknownUnit>, std::less<>> known_;
};

} // namespace

std::variant<Unit, UnknownUnit> unit_of_database(std::string_view text) {
    static std::mutex one_at_a_time;
    const std::lock_guard lock{one_at_a_time};
    static UnitLibrary library;
    return library.unit(text);
}

std::variant<Unit, UnknownUnit> unit_named(std::string_view text) {
    if (const std::optional<Unit> common = common_unit(text))
        return *common;
    return unit_of_database(text);
}

} // namespace searle::casefile
