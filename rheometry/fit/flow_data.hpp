#pragma once

#include "rheometry/fit/fit_options.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace searle::rheometry::fit {

/// One row of a flow curve as it was read.
struct MeasuredPoint {
    double rate{};      ///< 1/s, any sign; NaN: missing
    double stress{};    ///< Pa, any sign; NaN: missing
    double deviation{}; ///< standard deviation of the stress, Pa; NaN: not given
    std::size_t line{}; ///< of the file, for messages; 0: none
    std::string regime; ///< of a rheogram: "laminar", "lag+taylor-vortices"; empty: not known
};

struct ExcludedPoint {
    MeasuredPoint point;
    std::string reason;
};

/// A flow curve that a law can be fitted to: rates increasing, all numbers > 0.
struct FlowData {
    std::vector<double> rates;      ///< 1/s
    std::vector<double> stresses;   ///< Pa
    std::vector<double> deviations; ///< Pa; empty when not given
    std::vector<std::size_t> lines; ///< of the file
    std::vector<ExcludedPoint> excluded;
    /// What is odd about the data, a sentence each.
    std::vector<std::string> remarks;

    [[nodiscard]] std::size_t size() const { return rates.size(); }
};

struct Selection {
    std::optional<Range> rates; ///< 1/s; points outside are left out
    /// Keep points whose regime says that the conversion does not hold there.
    bool keep_disturbed = false;
};

/// Sorts the points by rate and leaves out, each with its reason: missing numbers, rates of 0,
/// stresses of 0 or against the rate, points outside the range, points in the regimes lag,
/// taylor-vortices and end-flow (unless fewer than 5 others remain: all are kept then, with a
/// remark). A negative rate with a negative stress counts as its mirror image.
[[nodiscard]] FlowData select_points(std::span<const MeasuredPoint> points,
                                     const Selection& selection);

} // namespace searle::rheometry::fit
