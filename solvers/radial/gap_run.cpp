#include "solvers/radial/gap_run.hpp"

#include "solvers/radial/annular_gap.hpp"
#include "solvers/radial/esdirk.hpp"
#include "solvers/radial/gap_system.hpp"
#include "solvers/steps_before_stop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace searle::solvers::radial {
namespace {

using Piece = rheometry::SpeedHistory::Piece;

constexpr long most_steps = 2'000'000;
constexpr long steps_between_calls = 32;
/// What is left up to a row, over the longest step, that is not stepped over any more.
constexpr double sliver = 1e-10;
/// The same where a yield-stress fluid comes to rest: its torque is that of the yield stress by
/// then, and the smallest steps show rounding alone.
constexpr double sliver_at_rest = 1e-6;
/// Of the one small step after a jump, whose momentum is a tiny share of what the next row sees.
constexpr double jump_tolerance = 1e-3;

template <class Law>
class Run {
public:
    /// @param original  the law as the scene has it, for the steady flow
    Run(const GapShape& shape, const Law& law, const laws::flow::AnyFlowLaw& original,
        const rheometry::SpeedHistory& history, const GapResolution& resolution)
        : shape_(shape), original_(original), history_(history),
          tolerance_(resolution.step_tolerance), steps_per_row_(resolution.steps_per_row),
          first_step_(resolution.first_step), most_assemblies_(resolution.most_assemblies),
          grid_(graded_grid(shape, resolution.layer, resolution.elements)),
          system_(shape, grid_, law) {
        const std::size_t count = system_.elements();
        flux_ = FluxField{std::vector<double>(count + 1), std::vector<double>(count)};
        velocity_.resize(count);
        start_.resize(count);
        error_.resize(count);
        for (VelocityField& slope : slope_) {
            slope.resize(count);
        }
        const double fastest = history.fastest_speed();
        typical_flux_ = fastest > 0.0 ? std::abs(steady_flux(fastest)) : 1.0;
    }

    GapRun operator()(const RowSink& at_row, const std::function<void()>& between_steps) {
        between_steps_ = between_steps;
        if (history_.initial_speed != 0.0) {
            if (!settle(history_.initial_speed)) {
                return std::move(run_);
            }
        }
        initial_momentum_ = system_.momentum(velocity_);
        std::size_t row = 0;
        double speed_before = history_.initial_speed;
        bool alive = true;
        for (const Piece& piece : history_.pieces) {
            if (!alive || row == history_.row_times.size()) {
                break;
            }
            time_ = piece.start_time;
            const double first_target = std::min(piece.end_time, history_.row_times[row]);
            // A kink or a jump starts a new momentum layer: begin with steps that can see it.
            // A row that rounding puts beside the kink sets no scale.
            step_ = first_step_ * std::max(first_target - time_, 1e-12 * (piece.end_time - time_));
            if (piece.start_speed != speed_before) {
                const double wait = first_target - time_;
                const double smallest = wait * std::min(1e-4, 1e-2 * tolerance_);
                alive =
                    jump(piece, std::min(1e-2 * wait,
                                         std::max(smallest, 0.05 * filling_time(piece.start_speed -
                                                                                speed_before))));
            }
            while (alive && row < history_.row_times.size() &&
                   history_.row_times[row] <= piece.end_time) {
                next_row_ = history_.row_times[row];
                alive = advance_to(piece, next_row_);
                if (alive) {
                    at_row(row++, {wall_flux(), system_.rounding(), &flux_});
                }
            }
            if (alive && row < history_.row_times.size()) {
                next_row_ = history_.row_times[row];
                alive = advance_to(piece, piece.end_time);
            }
            speed_before = piece.end_speed;
        }
        run_.finished = alive;
        run_.linear_solves = system_.linear_solves();
        run_.assemblies = system_.assemblies();
        const double gained = system_.momentum(velocity_) - initial_momentum_;
        run_.momentum_defect =
            transported_ > 0.0 ? std::abs(gained - delivered_) / transported_ : 0.0;
        return std::move(run_);
    }

private:
    /// What a step's error may be: no less than rounding leaves it.
    [[nodiscard]] double allowed() const { return std::max(tolerance_, system_.step_rounding()); }
    [[nodiscard]] std::array<double, 2> walls(double speed) const {
        return shape_.outer_wall_moves ? std::array{0.0, speed} : std::array{speed, 0.0};
    }
    [[nodiscard]] double wall_flux() const {
        return shape_.outer_wall_moves ? flux_.node.back() : flux_.node.front();
    }
    [[nodiscard]] static double speed_in(const Piece& piece, double time) {
        const double fraction = (time - piece.start_time) / (piece.end_time - piece.start_time);
        return piece.start_speed + fraction * (piece.end_speed - piece.start_speed);
    }

    /// The flux of the steady flow at a speed, with its sign: the same all over the gap.
    [[nodiscard]] double steady_flux(double speed) const {
        const double sign = (speed > 0.0) == shape_.outer_wall_moves ? 1.0 : -1.0;
        return sign * steady_flux_size(shape_, original_, std::abs(speed));
    }
    void guess_steady(double speed) {
        std::fill(flux_.node.begin(), flux_.node.end(), steady_flux(speed));
        std::fill(flux_.bubble.begin(), flux_.bubble.end(), 0.0);
    }

    /// The discrete steady flow: implicit Euler with steps far longer than any time of the gap.
    [[nodiscard]] bool settle(double speed) {
        guess_steady(speed);
        const double viscosity =
            std::abs(flux_.node.front()) * shape_.width() /
            (std::abs(speed) * (shape_.planar ? 1.0 : std::pow(shape_.inner, 3)));
        const double diffusion = shape_.density * shape_.width() * shape_.width() / viscosity;
        bool converged = false;
        for (int k = 0; k < 12; ++k) {
            start_ = velocity_;
            converged = system_
                            .solve(start_, 1e3 * diffusion, walls(speed),
                                   std::clamp(1e-3 * tolerance_, 1e-12, 1e-8), typical_flux_, flux_)
                            .converged;
            system_.acceleration(flux_, slope_[0]);
            for (std::size_t e = 0; e < velocity_.size(); ++e) {
                velocity_[e][0] = start_[e][0] + 1e3 * diffusion * slope_[0][e][0];
                velocity_[e][1] = start_[e][1] + 1e3 * diffusion * slope_[0][e][1];
            }
        }
        return converged;
    }

    /// Time in which a jump of the wall's speed brings the element at the wall up to speed. What
    /// happens sooner the grid cannot show.
    [[nodiscard]] double filling_time(double speed_jump) const {
        const auto& grid = grid_;
        const double size =
            shape_.outer_wall_moves ? grid.back() - grid[grid.size() - 2] : grid[1] - grid[0];
        const double radius =
            shape_.planar ? 1.0 : (shape_.outer_wall_moves ? shape_.outer : shape_.inner);
        const double velocity = std::abs(speed_jump) * radius;
        const double stress = system_.law().stress(velocity / size);
        return shape_.density * size * velocity / stress;
    }

    bool jump(const Piece& piece, double step) {
        guess_if_at_rest(speed_in(piece, time_ + step));
        start_ = velocity_;
        const auto outcome = system_.solve(start_, step, walls(speed_in(piece, time_ + step)),
                                           jump_tolerance, typical_flux_, flux_);
        if (!outcome.converged) {
            return false;
        }
        system_.acceleration(flux_, slope_[0]);
        for (std::size_t e = 0; e < velocity_.size(); ++e) {
            velocity_[e][0] += step * slope_[0][e][0];
            velocity_[e][1] += step * slope_[0][e][1];
        }
        account(step, 1.0);
        time_ += step;
        step_ = step;
        return true;
    }

    /// The last sliver before the wall stands still, by implicit Euler where that can be solved.
    void finish_stop(const Piece& piece, double left) {
        saved_flux_ = flux_;
        const double next = step_;
        if (!jump(piece, left)) {
            flux_ = saved_flux_;
        }
        step_ = next;
    }

    void guess_if_at_rest(double speed) {
        if (flux_.largest() == 0.0 && speed != 0.0) {
            guess_steady(speed);
        }
    }

    /// Books what the walls deliver in `step` at the present flux.
    void account(double step, double weight) {
        delivered_ += step * weight * (flux_.node.back() - flux_.node.front());
        transported_ +=
            step * std::abs(weight) * (std::abs(flux_.node.back()) + std::abs(flux_.node.front()));
    }

    bool advance_to(const Piece& piece, double target) {
        const double longest = (target - time_) / steps_per_row_;
        const bool stops = piece.end_speed == 0.0 && piece.start_speed != 0.0 &&
                           target == piece.end_time &&
                           !std::holds_alternative<laws::flow::Newtonian>(original_);
        const bool comes_to_rest = stops && laws::flow::yield_stress(original_) > 0.0;
        while (time_ < target) {
            const double left = target - time_;
            // Towards a stop steps shrink with what is left: the last of it is no time at all. But
            // a power of the wall's speed there may be seen yet.
            if (left <=
                std::max(1e-13 * target, (comes_to_rest ? sliver_at_rest : sliver) * longest)) {
                if (stops && !comes_to_rest) {
                    finish_stop(piece, left);
                }
                break;
            }
            const double most = stops ? longest_before_stop(left, longest, longest) : longest;
            // Equal steps up to the target rather than a short one at its end.
            const double steps_left = std::ceil(left / std::min(step_, most) * (1.0 - 1e-12));
            const double step =
                steps_left > 1e9 ? std::min(step_, most) : left / std::max(1.0, steps_left);
            if (run_.steps + run_.rejected > most_steps || step < 1e-15 * left ||
                time_ + step == time_ || system_.assemblies() > most_assemblies_) {
                return false;
            }
            if (between_steps_ && (run_.steps + run_.rejected) % steps_between_calls == 0) {
                between_steps_();
            }
            const double error = attempt(piece, step);
            const double factor = std::isfinite(error)
                                      ? 0.9 * std::pow(std::max(error, 1e-12) / allowed(), -0.25)
                                      : 0.1;
            if (error <= allowed()) {
                ++run_.steps;
                time_ = steps_left <= 1.0 ? target : time_ + step;
                const double next = step * std::clamp(factor, 0.3, 5.0);
                // A step cut short to land on the target must not shrink the next one.
                step_ = step < 0.99 * step_ ? std::max(step_, next) : next;
            } else {
                ++run_.rejected;
                step_ = step * std::clamp(factor, 0.1, 0.8);
            }
        }
        time_ = target;
        return true;
    }

    /// Tries one step. Accepted (result <= tolerance) it has moved flux_ and velocity_; else both
    /// are as before. Result: error of the flux relative to the largest flux; infinite if a stage
    /// failed.
    double attempt(const Piece& piece, double step) {
        const double theta = step * Esdirk::diagonal;
        // What the solves leave over is a momentum error too, and may be larger far from the next
        // row.
        const double left = std::max(0.0, next_row_ - time_ - step);
        const double solve_tolerance =
            std::clamp(1e-2 * tolerance_ * std::max(1.0, 0.1 * left / step), 1e-13, 1e-4);
        saved_flux_ = flux_;
        guess_if_at_rest(speed_in(piece, time_ + step));
        system_.acceleration(saved_flux_, slope_[0]);
        const double saved_delivered = delivered_;
        const double saved_transported = transported_;
        {
            const FluxField stage_flux = flux_;
            flux_ = saved_flux_;
            account(step, Esdirk::weight[5][0]);
            flux_ = stage_flux;
        }
        const auto undo = [&] {
            flux_ = saved_flux_;
            delivered_ = saved_delivered;
            transported_ = saved_transported;
        };
        for (std::size_t s = 1; s < Esdirk::stages; ++s) {
            const auto& weight = Esdirk::weight[s];
            for (std::size_t e = 0; e < velocity_.size(); ++e) {
                double w0 = 0.0;
                double w1 = 0.0;
                for (std::size_t j = 0; j < s; ++j) {
                    w0 += weight[j] * slope_[j][e][0];
                    w1 += weight[j] * slope_[j][e][1];
                }
                start_[e] = {velocity_[e][0] + step * w0, velocity_[e][1] + step * w1};
            }
            const double stage_time = time_ + Esdirk::time[s] * step;
            const auto outcome = system_.solve(start_, theta, walls(speed_in(piece, stage_time)),
                                               solve_tolerance, typical_flux_, flux_);
            if (!outcome.converged) {
                undo();
                return std::numeric_limits<double>::infinity();
            }
            system_.acceleration(flux_, slope_[s]);
            account(step, Esdirk::weight[5][s]);
        }
        for (std::size_t e = 0; e < velocity_.size(); ++e) {
            double error0 = 0.0;
            double error1 = 0.0;
            for (std::size_t j = 0; j < Esdirk::stages; ++j) {
                const double difference = Esdirk::weight[5][j] - Esdirk::embedded[j];
                error0 += difference * slope_[j][e][0];
                error1 += difference * slope_[j][e][1];
            }
            error_[e] = {step * error0, step * error1};
        }
        const double largest = std::max(flux_.largest(), saved_flux_.largest());
        if (!std::isfinite(largest)) {
            undo();
            return std::numeric_limits<double>::infinity();
        }
        // An error of momentum long before the next row reaches that row's stress spread over the
        // time in between; so near a start, where the stress is singular in time, it may be larger.
        const double delayed = left > 0.0 ? 2.0 * system_.momentum_size(error_) / left
                                          : std::numeric_limits<double>::infinity();
        const double error =
            largest == 0.0 ? 0.0 : std::min(system_.flux_change(error_), delayed) / largest;
        if (!(error <= allowed())) {
            undo();
            return error;
        }
        for (std::size_t e = 0; e < velocity_.size(); ++e) {
            velocity_[e][0] = start_[e][0] + theta * slope_[5][e][0];
            velocity_[e][1] = start_[e][1] + theta * slope_[5][e][1];
        }
        return error;
    }

    GapShape shape_;
    const laws::flow::AnyFlowLaw& original_;
    const rheometry::SpeedHistory& history_;
    double tolerance_;
    int steps_per_row_;
    double first_step_;
    long most_assemblies_;
    std::vector<double> grid_;
    GapSystem<Law> system_;
    GapRun run_;
    std::function<void()> between_steps_;

    double time_ = 0.0;
    double step_ = 0.0;
    double next_row_ = 0.0;
    double typical_flux_ = 1.0; ///< of steady flow at the fastest speed
    FluxField flux_, saved_flux_;
    VelocityField velocity_, start_, error_;
    std::array<VelocityField, Esdirk::stages> slope_;
    double initial_momentum_ = 0.0;
    double delivered_ = 0.0;
    double transported_ = 0.0;
};

/// Stress at the fastest wall speed, spread over the gap.
double typical_stress(const GapShape& shape, const laws::flow::AnyFlowLaw& law,
                      const rheometry::SpeedHistory& history) {
    const double fastest = history.fastest_speed();
    const double radius = shape.planar ? 1.0 : shape.inner;
    return fastest > 0.0 ? laws::flow::stress(law, fastest * radius / shape.width()) : 1.0;
}

} // namespace

double steady_flux_size(const GapShape& shape, const laws::flow::AnyFlowLaw& law, double speed) {
    if (shape.planar) {
        return laws::flow::stress(law, speed / shape.width());
    }
    return steady_gap_flow({shape.inner, shape.outer}, law, speed).torque_per_length /
           (2.0 * std::numbers::pi);
}

GapRun run_gap(const GapShape& shape, const laws::flow::AnyFlowLaw& law,
               const rheometry::SpeedHistory& history, const GapResolution& resolution,
               const RowSink& at_row, const std::function<void()>& between_steps) {
    return std::visit(
        [&](const auto& chosen) {
            const auto run = [&](const auto& used) {
                return Run(shape, used, law, history, resolution)(at_row, between_steps);
            };
            using Law = std::decay_t<decltype(chosen)>;
            if constexpr (std::is_same_v<Law, laws::flow::CarreauYasuda> ||
                          std::is_same_v<Law, laws::flow::Cross>) {
                return run(TabulatedLaw(chosen, typical_stress(shape, law, history)));
            } else {
                return run(chosen);
            }
        },
        law);
}

} // namespace searle::solvers::radial
