#pragma once

#include "casefile/keys.hpp"
#include "rheometry/protocol.hpp"

#include <optional>
#include <variant>
#include <vector>

namespace searle::rheometry {

/// Rows of a protocol, at most.
inline constexpr int most_rows = 1000000;

/// The kinds of speed that a ramp or a segment takes, in the order of casefile::Quantity::kind.
enum class WrittenSpeedKind : std::size_t { shear_rate, angular_velocity, wall_speed };

struct RampAsWritten {
    casefile::Quantity from;
    casefile::Quantity to;
    double duration{};
    int points = 100;
    StartState start = StartState::steady;
};

enum class Spacing { logarithmic, linear };

struct SpeedRange {
    double from{};
    double to{};
    int count{};
    Spacing spacing = Spacing::logarithmic;
};

/// Speeds of one kind: listed, or spread over a range, or (both empty) not given.
struct SpeedSeries {
    std::vector<double> listed;
    std::optional<SpeedRange> range;

    [[nodiscard]] bool is_given() const { return !listed.empty() || range.has_value(); }
};

struct StepsAsWritten {
    SpeedSeries shear_rates;
    SpeedSeries angular_velocities;
    SpeedSeries wall_speeds;
    std::optional<double> hold; ///< s; no value: until the flow is steady
    std::optional<double> hold_strain;
    std::optional<double> discard_strain; ///< no value: the program chooses
};

struct SegmentAsWritten {
    casefile::Quantity to;
    double duration{};
    int points = 50;
};

struct SegmentsAsWritten {
    std::vector<SegmentAsWritten> segments;
};

/// The section [protocol].
struct ProtocolAsWritten {
    std::variant<RampAsWritten, StepsAsWritten, SegmentsAsWritten> program;
};

[[nodiscard]] casefile::Keys<RampAsWritten> ramp_keys();
[[nodiscard]] casefile::Keys<StepsAsWritten> steps_keys();
[[nodiscard]] casefile::Keys<SegmentsAsWritten> segments_keys();
[[nodiscard]] casefile::Keys<ProtocolAsWritten> protocol_keys();

/// The speeds of a range with at least two speeds, both ends exact.
[[nodiscard]] std::vector<double> speeds_of(const SpeedRange& range);

/// The protocol that a section without faults describes.
[[nodiscard]] Protocol protocol_of(const ProtocolAsWritten& written);

} // namespace searle::rheometry
