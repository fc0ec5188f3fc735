#include "solvers/regime.hpp"

#include <string_view>

namespace searle::solvers {

std::string regime_name(const RegimeFacts& facts) {
    std::string names;
    const auto add_if = [&names](bool holds, std::string_view name) {
        if (holds) {
            names += names.empty() ? "" : "+";
            names += name;
        }
    };
    add_if(facts.speed == 0.0, "rest");
    add_if(facts.partly_sheared, "partly-sheared");
    add_if(facts.lag_share > facts.accuracy, "lag");
    add_if(facts.taylor_ratio > 1.0, "taylor-vortices");
    add_if(facts.end_flow_share > facts.accuracy, "end-flow");
    return names.empty() ? "laminar" : names;
}

} // namespace searle::solvers
