#include "solvers/plan_text.hpp"

#include <fmt/format.h>

namespace searle::solvers {

std::string percent(double share) {
    const double value = 100.0 * share;
    if (value > 0.0 && value < 1e-10) {
        return "less than 1e-10 %";
    }
    return value >= 100.0 ? fmt::format("{:.0f} %", value) : fmt::format("{:.2g} %", value);
}

std::string rows_of(std::size_t count, std::size_t total) {
    if (total == 1) {
        return count == 1 ? "the only row" : "no row";
    }
    if (count == 0) {
        return fmt::format("none of {} rows", total);
    }
    return count == total ? fmt::format("all {} rows", total)
                          : fmt::format("{} of {} rows", count, total);
}

} // namespace searle::solvers
