#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace searle::rheometry {

/// Where a measurement lies on a merged curve: `share` of the way from point `index` to the next.
struct CurvePosition {
    std::size_t index{};
    double share{}; ///< 0 <= share < 1
};

/// A measured curve with one point per speed, in logarithms.
struct FlowCurve {
    std::vector<double> log_omega;  ///< ln(rad/s), strictly increasing
    std::vector<double> log_stress; ///< ln(Pa), mean of the measurements merged into the point
    std::vector<double> weights;    ///< number of these measurements

    [[nodiscard]] std::size_t size() const { return log_omega.size(); }
    [[nodiscard]] std::vector<double> omega() const;
    [[nodiscard]] std::vector<double> stress() const;
    /// No value for a row that is no part of the curve (see merged_curve).
    [[nodiscard]] std::optional<CurvePosition> position_of(double speed, double stress) const;
};

/// Sorts measurements by the size of the speed and merges those whose speeds agree to 1 part in
/// 1000, or closer than a 400th of the whole range of ln(speed). Rows at rest, and rows whose
/// stress has not the sign of the speed, are left out.
[[nodiscard]] FlowCurve merged_curve(std::span<const double> speeds,
                                     std::span<const double> stresses);

/// The first `count` points.
[[nodiscard]] FlowCurve first_points(const FlowCurve& curve, std::size_t count);

/// At most `most` points, neighbours merged.
[[nodiscard]] FlowCurve thinned(const FlowCurve& curve, std::size_t most);

} // namespace searle::rheometry
