#pragma once

#include "rheometry/report/plot.hpp"
#include "rheometry/rheogram.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace searle::rheometry::report {

/// The single names in a regime such as "lag+taylor-vortices".
[[nodiscard]] std::vector<std::string> regime_names(std::string_view regime);

/// A regime's name as people read it: "taylor-vortices" becomes "Taylor vortices".
[[nodiscard]] std::string regime_label(std::string_view name);

struct RegimeShading {
    std::vector<Band> bands;
    std::vector<BandKind> kinds;
};

/// Bands over the stretches of x in which a regime other than "laminar" holds, one kind a regime.
/// `x` has a number a point, in the points' order; only meaningful when x is monotone along the
/// points. Bands meet half-way between points.
[[nodiscard]] RegimeShading shade_regimes(std::span<const RheogramPoint> points,
                                          std::span<const double> x);

/// True when the rates rise and fall along the points, so that a rate does not name a point.
[[nodiscard]] bool passes_rates_twice(const Rheogram& rheogram);

} // namespace searle::rheometry::report
