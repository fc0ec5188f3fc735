#include "rheometry/speed_history.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace searle::rheometry {

const SpeedHistory::Piece& SpeedHistory::piece_at(double time) const {
    if (pieces.empty()) {
        throw std::logic_error("a speed history without pieces has no speed");
    }
    const auto found =
        std::lower_bound(pieces.begin(), pieces.end(), time,
                         [](const Piece& piece, double t) { return piece.end_time < t; });
    return found == pieces.end() ? pieces.back() : *found;
}

double SpeedHistory::fastest_speed() const {
    double fastest = std::abs(initial_speed);
    for (const Piece& piece : pieces) {
        fastest = std::max({fastest, std::abs(piece.start_speed), std::abs(piece.end_speed)});
    }
    return fastest;
}

double SpeedHistory::speed_at(double time) const {
    const Piece& piece = piece_at(time);
    const double fraction = (time - piece.start_time) / (piece.end_time - piece.start_time);
    // std::lerp meets both ends exactly.
    return std::lerp(piece.start_speed, piece.end_speed, std::clamp(fraction, 0.0, 1.0));
}

double SpeedHistory::acceleration_at(double time) const {
    const Piece& piece = piece_at(time);
    return (piece.end_speed - piece.start_speed) / (piece.end_time - piece.start_time);
}

} // namespace searle::rheometry
