#pragma once

#include "rheometry/fit/fit_result.hpp"
#include "rheometry/fit/flow_data.hpp"
#include "rheometry/fit/model.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace searle::rheometry::fit {

/// Rates that can be measured, e.g. those of one geometry on one drive.
struct RateWindow {
    std::string name;
    Range rates; ///< 1/s, 0 < low < high
};

struct DesignPoint {
    double rate{}; ///< 1/s
    std::size_t repeats{};
};

/// Which further points would shrink the confidence region most.
struct Design {
    std::string window;
    std::vector<DesignPoint> points; ///< rates increasing
    /// Standard errors after these points over those before, per parameter; NaN where the present
    /// data give none.
    std::vector<double> shrinkage;
    /// Standard errors that the data and these points together promise, SI.
    std::vector<double> standard_errors;
    double volume_ratio{}; ///< of the confidence ellipsoid, after over before; 0 if it was infinite
};

/// D-optimal: point by point the one that raises the determinant of the information most, then
/// exchanged one by one until none is better. The scatter is taken to stay as it was, relative or
/// absolute as the weights were.
/// @param count  further points, >= 1
[[nodiscard]] Design suggest_points(const Model& model, const FitResult& result,
                                    const RateWindow& window, std::size_t count);

/// One design per window, the best first.
[[nodiscard]] std::vector<Design> suggest_windows(const Model& model, const FitResult& result,
                                                  const std::vector<RateWindow>& windows,
                                                  std::size_t count);

} // namespace searle::rheometry::fit
