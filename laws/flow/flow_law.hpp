#pragma once

#include "laws/flow/bingham.hpp"
#include "laws/flow/carreau_yasuda.hpp"
#include "laws/flow/casson.hpp"
#include "laws/flow/cross.hpp"
#include "laws/flow/herschel_bulkley.hpp"
#include "laws/flow/newtonian.hpp"
#include "laws/flow/power_law.hpp"

#include <variant>

namespace searle::laws::flow {

/// The flow law that a scene has; std::visit it once, outside the loop.
using AnyFlowLaw =
    std::variant<Newtonian, Bingham, PowerLaw, HerschelBulkley, Casson, CarreauYasuda, Cross>;

static_assert(FlowLaw<Newtonian> && FlowLaw<Bingham> && FlowLaw<PowerLaw> &&
              FlowLaw<HerschelBulkley> && FlowLaw<Casson> && FlowLaw<CarreauYasuda> &&
              FlowLaw<Cross>);

[[nodiscard]] inline std::string_view name_of(const AnyFlowLaw& law) {
    return std::visit([](const auto& chosen) { return chosen.name; }, law);
}

/// Stress at a shear rate >= 0, Pa.
[[nodiscard]] inline double stress(const AnyFlowLaw& law, double rate) {
    return std::visit([rate](const auto& chosen) { return double{chosen.stress(rate)}; }, law);
}

/// Yield stress, Pa; 0 for a law without one.
[[nodiscard]] inline double yield_stress(const AnyFlowLaw& law) {
    return std::visit([](const auto& chosen) { return double{chosen.yield_stress_value()}; }, law);
}

/// Shear rate at a stress >= 0, 1/s; 0 up to the yield stress.
[[nodiscard]] inline double rate(const AnyFlowLaw& law, double stress) {
    return std::visit(
        [stress](const auto& chosen) {
            const double excess = stress - chosen.yield_stress_value();
            return excess > 0.0 ? double{chosen.rate_at_excess(excess)} : 0.0;
        },
        law);
}

} // namespace searle::laws::flow
