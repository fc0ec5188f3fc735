#pragma once

#include "rheometry/report/rich_text.hpp"

#include <vector>

namespace searle::rheometry::report {

struct Tick {
    double value{};
    RichText label; ///< empty for a tick without a label
};

struct TickMarks {
    std::vector<Tick> major;
    std::vector<double> minor;
};

/// Ticks at 1, 2 or 5 times a power of ten within [low, high], at least two and at most `most` (>=
/// 5) of them, low < high, both finite. Labels have just the digits that the step needs.
[[nodiscard]] TickMarks linear_ticks(double low, double high, int most);

/// Ticks for a logarithmic axis, 0 < low < high. Over several decades: powers of ten labelled
/// (every second, third, ... where more than `most` would come), the 2 ... 9 between them as minor
/// ticks. Where fewer than two powers of ten would be labelled, and below a decade and a half, 2
/// and 5 are labelled too; below half a decade, and where that labels too few, linear_ticks.
[[nodiscard]] TickMarks logarithmic_ticks(double low, double high, int most);

} // namespace searle::rheometry::report
