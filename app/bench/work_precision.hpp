#pragma once

#include "app/bench/measurement.hpp"

#include <vector>

namespace searle::app::bench {

struct WorkPoint {
    double error{};
    double cpu{};
};

/// The points of a curve that no other is both cheaper and more accurate than, by falling error.
[[nodiscard]] std::vector<WorkPoint> best_points(std::vector<WorkPoint> points);

/// CPU time of a curve at an error, interpolated in log-log between best points. At errors above
/// the curve's: its cheapest point (`beyond` true: a bound). NaN below the curve's errors.
struct WorkAt {
    double cpu{};
    bool beyond{};
};
[[nodiscard]] WorkAt work_at(const std::vector<WorkPoint>& best, double error);

/// The ratios of every peer's points with an error, against searle's curve, scene by scene; of a
/// scene whose seconds are a cost (cost_unit) against searle's point of the best accuracy within
/// 1 %, or the most accurate one.
[[nodiscard]] std::vector<Ratio> ratios_of(const BenchResult& result);

/// Per scene and peer the point that is best for the peer: with the least ratio.
[[nodiscard]] std::vector<Ratio> least_ratios(const std::vector<Ratio>& ratios);

[[nodiscard]] double median(std::vector<double> values);

} // namespace searle::app::bench
