#pragma once

#include <optional>
#include <variant>
#include <vector>

namespace searle::rheometry {

/// What a speed in a protocol is measured in, as the case file wrote it.
enum class SpeedKind {
    shear_rate, ///< 1/s, at the conversion's definition of the rate
    drive       ///< rad/s of the bob or rotor; m/s of the box's moving wall
};

struct ProtocolSpeed {
    double value{};
    SpeedKind kind = SpeedKind::shear_rate;
};

/// Speed linear in time over `duration` (s, > 0), `points` rows at t = k duration / points, k = 1
/// ... points.
struct Ramp {
    ProtocolSpeed from{};
    ProtocolSpeed to{};
    double duration{};
    int points{};
};

/// A speed per row, each held for `hold` seconds; no value means: until the flow is steady.
/// With a finite hold the speed jumps at the start of each step, the first one from rest, and the
/// row is taken at the step's end.
struct Steps {
    std::vector<ProtocolSpeed> speeds;
    std::optional<double> hold;
    /// Strain that each speed is held for, in place of `hold`; for suspensions.
    std::optional<double> hold_strain = std::nullopt;
    /// Strain at the start of each hold that no average includes; no value: found by a test.
    std::optional<double> discard_strain = std::nullopt;
};

/// One straight piece of a speed history: from the speed where the piece before ended to `to`.
struct Segment {
    ProtocolSpeed to{};
    double duration{};
    int points{};
};

struct Segments {
    std::vector<Segment> segments; ///< the first starts from rest
};

/// The state of the fluid before a ramp that starts at a speed other than zero.
enum class StartState {
    steady, ///< the ramp follows a long hold at `from`
    rest    ///< the drive jumps from rest to `from` at t = 0
};

struct Protocol {
    std::variant<Ramp, Steps, Segments> program;
    StartState start = StartState::steady;
};

} // namespace searle::rheometry
