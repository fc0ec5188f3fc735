#pragma once

#include "laws/flow/flow_law.hpp"
#include "solvers/radial/tabulated_inverse.hpp"

#include <cmath>
#include <type_traits>

namespace searle::solvers::radial {

/// A law's shear rate and d rate / d stress at an excess stress > 0, with the fewest powers taken.
struct Compliance {
    double rate{};  ///< 1/s
    double slope{}; ///< 1/(Pa s)
};

template <class Law>
[[nodiscard]] inline Compliance compliance(const Law& law, double excess) {
    const double rate = law.rate_at_excess(excess);
    return {rate, 1.0 / law.stress_slope(rate)};
}

[[nodiscard]] inline Compliance compliance(const laws::flow::PowerLaw& law, double excess) {
    const double rate = law.rate_at_excess(excess);
    return {rate, rate / (law.flow_index * excess)};
}

[[nodiscard]] inline Compliance compliance(const laws::flow::HerschelBulkley& law, double excess) {
    const double rate = law.rate_at_excess(excess);
    return {rate, rate / (law.flow_index * excess)};
}

template <class Law>
[[nodiscard]] inline Compliance compliance(const TabulatedLaw<Law>& law, double excess) {
    const double log_stress = std::log(excess);
    if (!law.table.covers(log_stress)) {
        return compliance(static_cast<const Law&>(law), excess);
    }
    const InverseTable::Point point = law.table.at(log_stress);
    const double rate = std::exp(point.log_rate);
    return {rate, point.log_slope * rate / excess};
}

/// Largest p with rate ~ excess^p over a stretch of the law: decides how many points integrate it.
template <class Law>
[[nodiscard]] inline double rate_exponent(const Law& law) {
    if constexpr (requires { law.flow_index; }) {
        return 1.0 / law.flow_index;
    } else if constexpr (std::is_same_v<Law, laws::flow::Casson>) {
        return 2.0;
    } else {
        return 1.0;
    }
}

/// True where rate(stress) is smooth through stress = 0, so that no element ever needs splitting.
template <class Law>
inline constexpr bool smooth_through_rest = false;
template <>
inline constexpr bool smooth_through_rest<laws::flow::Newtonian> = true;

} // namespace searle::solvers::radial
