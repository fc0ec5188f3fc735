#pragma once

#include <span>
#include <vector>

namespace searle::rheometry {

/// The drive's speed over time: piecewise linear, jumps allowed.
/// Speeds are rad/s of the bob or rotor, or m/s of the box's moving wall; times are s.
struct SpeedHistory {
    struct Piece {
        double start_time{};
        double end_time{};
        double start_speed{};
        double end_speed{};
    };

    /// In order, without holes: each piece starts when the one before ends; the first at t = 0.
    std::vector<Piece> pieces;
    /// Times of the rows, increasing, within the pieces; a time where two pieces meet belongs to
    /// the earlier one.
    std::vector<double> row_times;
    /// Speed that the flow is steady at before t = 0.
    double initial_speed{};

    [[nodiscard]] double duration() const { return pieces.empty() ? 0.0 : pieces.back().end_time; }
    /// Largest magnitude of the speed, the one before t = 0 included.
    [[nodiscard]] double fastest_speed() const;
    /// The piece that holds `time`, the earlier one where two meet. Throws without pieces.
    [[nodiscard]] const Piece& piece_at(double time) const;
    /// Speed just before or at `time`, 0 <= time <= duration().
    [[nodiscard]] double speed_at(double time) const;
    /// Time derivative of the speed just before `time`.
    [[nodiscard]] double acceleration_at(double time) const;
};

/// A steady series: one speed per row, no time.
struct SteadySpeeds {
    std::vector<double> speeds;
};

} // namespace searle::rheometry
