#include "solvers/plan_lag.hpp"

#include "solvers/plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace searle::solvers {
namespace {

using Piece = rheometry::SpeedHistory::Piece;

constexpr double memory_scale = 6.0 / (std::numbers::pi * std::numbers::pi);
/// exp(-30) of a disturbance is nothing at any accuracy.
constexpr double forgotten = 30.0;
/// Pieces looked at one by one; what is older enters by its total variation, an upper bound.
constexpr int remembered_pieces = 12;
/// A share is relative to the row's stress (at rest to the yield stress, between whose two signs
/// the law leaves the stress open), but never to less than this part of the largest: at rest a
/// fluid without yield stress has no other scale.
constexpr double stress_floor = 1e-6;

/// At rest a yield stress holds the fluid unless inertia is more than this part of it: the row's
/// torque is open then, and no time steps close it.
constexpr double held_share = 0.1;

/// Changes of speed and acceleration that a row remembers.
class History {
public:
    explicit History(const rheometry::SpeedHistory& history) : history_(history) {
        double previous = history.initial_speed;
        double variation = 0.0;
        variation_.reserve(history.pieces.size());
        for (const Piece& piece : history.pieces) {
            variation_.push_back(variation);
            variation += std::abs(piece.start_speed - previous) +
                         std::abs(piece.end_speed - piece.start_speed);
            previous = piece.end_speed;
        }
    }

    /// Inertial torque at `time`, in piece `last`, of a gap with this response.
    [[nodiscard]] double torque(double time, std::size_t last, const GapResponse& response) const {
        const double inverse_decay = 1.0 / response.decay_time;
        double changes = 0.0;
        int looked_at = 0;
        for (std::size_t i = last + 1; i-- > 0;) {
            const Piece& piece = history_.pieces[i];
            const double since_start = (time - piece.start_time) * inverse_decay;
            const double since_end = std::max(0.0, time - piece.end_time) * inverse_decay;
            if (since_end > forgotten) {
                break;
            }
            if (++looked_at > remembered_pieces) {
                changes += std::copysign(variation_[i + 1] * inverse_decay * after_jump(since_end),
                                         changes);
                break;
            }
            const double acceleration =
                (piece.end_speed - piece.start_speed) / (piece.end_time - piece.start_time);
            if (acceleration != 0.0) {
                changes += acceleration * (after_kink(since_start) - after_kink(since_end));
            }
            const double before = i > 0 ? history_.pieces[i - 1].end_speed : history_.initial_speed;
            if (before != piece.start_speed && since_start > 0.0) {
                changes += (piece.start_speed - before) * inverse_decay * after_jump(since_start);
            }
        }
        return memory_scale * response.inertia * changes;
    }

private:
    const rheometry::SpeedHistory& history_;
    std::vector<double> variation_; ///< of the speed, before each piece
};

double share(double inertial, double steady, double floor) {
    const double size = std::abs(inertial);
    return size > 0.0 ? size / (size + std::max(std::abs(steady), floor)) : 0.0;
}

} // namespace

std::vector<LagForecast> forecast_lag(const rheometry::SpeedHistory& history, SteadyCurve& curve) {
    std::vector<LagForecast> forecasts(history.row_times.size());
    if (curve.at_rest_only()) {
        return forecasts;
    }
    const History memory(history);
    const std::size_t gaps = curve.gaps().size();
    const double yield_torque = curve.yield_torque();
    const double floor = stress_floor * curve.at(curve.largest_speed()).torque;
    std::size_t piece = 0;
    for (std::size_t row = 0; row < forecasts.size(); ++row) {
        const double time = history.row_times[row];
        while (piece + 1 < history.pieces.size() && history.pieces[piece].end_time < time) {
            ++piece;
        }
        const double speed = history.speed_at(time);
        const SteadyState here = curve.at(speed);
        std::array<double, 2> slowest{};
        const double before =
            piece > 0 ? history.pieces[piece - 1].end_speed : history.initial_speed;
        for (const double visited : {speed, history.pieces[piece].start_speed, before}) {
            const SteadyState& state = visited == speed ? here : curve.at(visited);
            for (std::size_t g = 0; g < gaps && visited != 0.0; ++g) {
                slowest[g] = std::max(slowest[g], state.gaps[g].response.decay_time);
            }
        }
        double likely = 0.0;
        double most = 0.0;
        for (std::size_t g = 0; g < gaps; ++g) {
            GapResponse response = here.gaps[g].response;
            likely += memory.torque(time, piece, response);
            response.decay_time = std::max(response.decay_time, slowest[g]);
            most += std::abs(memory.torque(time, piece, response));
        }
        for (const GapResponse& chamber : here.chambers) {
            // An estimate on the high side: it decides what is solved for, and is not told as lag.
            if (chamber.inertia > 0.0) {
                most += std::abs(memory.torque(time, piece, chamber));
            }
        }
        const double steady = speed == 0.0 ? yield_torque : here.torque;
        if (speed == 0.0 && most < held_share * steady) {
            continue;
        }
        forecasts[row].share = share(likely, steady, floor);
        forecasts[row].largest = std::max(forecasts[row].share, share(most, steady, floor));
    }
    return forecasts;
}

std::vector<double> settling_times(SteadyCurve& curve, double start_speed,
                                   std::span<const double> speeds, double accuracy) {
    std::vector<double> times;
    times.reserve(speeds.size());
    double time = 0.0;
    double previous = start_speed;
    for (const double speed : speeds) {
        double longest = 0.0;
        if (speed != previous) {
            // The tangent flow of the side that forgets more slowly, gap by gap.
            const SteadyState after = curve.at(speed != 0.0 ? speed : previous);
            const SteadyState earlier = previous != 0.0 ? curve.at(previous) : after;
            const auto wait_for = [&](const GapResponse& now, const GapResponse& then) {
                const double decay_time = std::max(now.decay_time, then.decay_time);
                const double torque =
                    memory_scale * now.inertia / decay_time * std::abs(speed - previous);
                longest =
                    std::max(longest, decay_time * std::log(torque / (accuracy * after.torque)));
            };
            for (std::size_t g = 0; g < curve.gaps().size(); ++g) {
                wait_for(after.gaps[g].response, earlier.gaps[g].response);
            }
            for (std::size_t c = 0; c < after.chambers.size(); ++c) {
                if (after.chambers[c].inertia > 0.0) {
                    wait_for(after.chambers[c], earlier.chambers[c]);
                }
            }
        }
        time += longest;
        times.push_back(time);
        previous = speed;
    }
    return times;
}

std::vector<double> settling_times(const geometry::Instrument& instrument, const Fluid& fluid,
                                   std::span<const double> speeds, double accuracy) {
    SteadyCurve curve(instrument, fluid, speeds);
    return settling_times(curve, 0.0, speeds, accuracy);
}

double settling_time(const geometry::Instrument& instrument, const Fluid& fluid, double from_speed,
                     double to_speed, double accuracy) {
    const std::array speeds{from_speed, to_speed};
    SteadyCurve curve(instrument, fluid, speeds);
    return settling_times(curve, from_speed, std::span(speeds).last(1), accuracy).front();
}

} // namespace searle::solvers
