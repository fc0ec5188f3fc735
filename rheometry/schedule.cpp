#include "rheometry/schedule.hpp"

#include <cmath>

namespace searle::rheometry {
namespace {

using Schedule = std::variant<SteadySpeeds, SpeedHistory>;

double drive_speed(const ProtocolSpeed& speed, const Conversion& conversion) {
    return speed.kind == SpeedKind::drive ? speed.value : conversion.speed(speed.value);
}

/// Rows at the ends of `points` equal parts of the piece; the last one falls exactly on its end,
/// where rounding could otherwise push it into the next piece.
void add_rows(SpeedHistory& history, const SpeedHistory::Piece& piece, double duration,
              int points) {
    for (int k = 1; k < points; ++k) {
        history.row_times.push_back(piece.start_time + duration * k / points);
    }
    history.row_times.push_back(piece.end_time);
}

struct Scheduler {
    const Conversion& conversion;
    StartState start;

    Schedule operator()(const Ramp& ramp) const {
        const double from = drive_speed(ramp.from, conversion);
        SpeedHistory history;
        history.initial_speed = start == StartState::steady ? from : 0.0;
        history.pieces.push_back({.start_time = 0.0,
                                  .end_time = ramp.duration,
                                  .start_speed = from,
                                  .end_speed = drive_speed(ramp.to, conversion)});
        history.row_times.reserve(static_cast<std::size_t>(ramp.points));
        add_rows(history, history.pieces.back(), ramp.duration, ramp.points);
        return history;
    }

    Schedule operator()(const Steps& steps) const {
        if (!steps.hold && !steps.hold_strain) {
            SteadySpeeds series;
            series.speeds.reserve(steps.speeds.size());
            for (const ProtocolSpeed& speed : steps.speeds) {
                series.speeds.push_back(drive_speed(speed, conversion));
            }
            return series;
        }
        SpeedHistory history;
        history.pieces.reserve(steps.speeds.size());
        history.row_times.reserve(steps.speeds.size());
        double time = 0.0;
        for (const ProtocolSpeed& step : steps.speeds) {
            const double speed = drive_speed(step, conversion);
            // A multiple of the hold, not a sum of holds, so that rounding does not pile up.
            const double end =
                steps.hold ? *steps.hold * static_cast<double>(history.pieces.size() + 1)
                           : time + *steps.hold_strain / std::abs(conversion.shear_rate(speed));
            history.pieces.push_back(
                {.start_time = time, .end_time = end, .start_speed = speed, .end_speed = speed});
            history.row_times.push_back(end);
            time = end;
        }
        return history;
    }

    Schedule operator()(const Segments& program) const {
        SpeedHistory history;
        double time = 0.0;
        double speed = 0.0;
        for (const Segment& segment : program.segments) {
            const SpeedHistory::Piece piece{.start_time = time,
                                            .end_time = time + segment.duration,
                                            .start_speed = speed,
                                            .end_speed = drive_speed(segment.to, conversion)};
            history.pieces.push_back(piece);
            add_rows(history, piece, segment.duration, segment.points);
            time = piece.end_time;
            speed = piece.end_speed;
        }
        return history;
    }
};

} // namespace

Schedule schedule(const Protocol& protocol, const Conversion& conversion) {
    return std::visit(Scheduler{conversion, protocol.start}, protocol.program);
}

} // namespace searle::rheometry
