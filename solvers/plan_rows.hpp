#pragma once

#include "solvers/plan_forecast.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace searle::solvers {

[[nodiscard]] inline bool is_box(const Scene& scene) {
    return std::holds_alternative<geometry::Box>(scene.instrument);
}
[[nodiscard]] inline bool is_din_bob(const Scene& scene) {
    return std::holds_alternative<geometry::DinBob>(scene.instrument);
}
[[nodiscard]] inline bool has_ends(const Scene& scene) {
    return geometry::has_ends(scene.instrument);
}
/// A single or double gap without ends: where vortices are solved in a periodic cell.
[[nodiscard]] inline bool is_endless_gap(const Scene& scene) {
    return (std::holds_alternative<geometry::ConcentricCylinders>(scene.instrument) ||
            std::holds_alternative<geometry::DoubleGap>(scene.instrument)) &&
           !has_ends(scene);
}
[[nodiscard]] inline bool is_newtonian(const Scene& scene) {
    return std::holds_alternative<laws::flow::Newtonian>(scene.fluid.law);
}

/// Secondary flow may be left out only when a few times its estimate is far below what was asked.
[[nodiscard]] inline bool end_flow_matters(std::span<const RowForecast> rows, double accuracy) {
    constexpr double margin = 12.0;
    return std::ranges::any_of(
        rows, [&](const RowForecast& row) { return margin * row.end_flow_share > accuracy; });
}

/// The row where a quantity, given as a function of the row, is largest in magnitude; the forecast
/// has at least one row.
template <class Value>
[[nodiscard]] std::size_t row_of_largest(const Forecast& forecast, const Value& value) {
    std::size_t found = 0;
    for (std::size_t i = 1; i < forecast.rows.size(); ++i) {
        if (std::abs(value(i)) > std::abs(value(found))) {
            found = i;
        }
    }
    return found;
}

/// Number of rows for which a predicate of the row holds.
template <class Predicate>
[[nodiscard]] std::size_t count_rows(const Forecast& forecast, const Predicate& holds) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < forecast.rows.size(); ++i) {
        count += holds(i) ? 1 : 0;
    }
    return count;
}

[[nodiscard]] inline std::size_t rows_with_lag(const Scene& scene, const Forecast& forecast) {
    return count_rows(forecast, [&](std::size_t i) {
        return forecast.rows[i].lag_share > scene.solver.accuracy;
    });
}

/// Height of the wetted cylinder over the width of the gap that the conversion is for; 0 for the
/// box.
[[nodiscard]] double slenderness(const geometry::Instrument& instrument);

} // namespace searle::solvers
