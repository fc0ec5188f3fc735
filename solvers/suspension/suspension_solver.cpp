#include "solvers/suspension/suspension_solver.hpp"

#include "rheometry/schedule.hpp"
#include "solvers/particles/packing.hpp"
#include "solvers/suspension/claimed_error.hpp"
#include "solvers/suspension/inertial_motion.hpp"
#include "solvers/suspension/overdamped_motion.hpp"
#include "solvers/suspension/suspension_plan.hpp"
#include "solvers/suspension/suspension_rows.hpp"
#include "solvers/unsuitable_scene.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <thread>

namespace searle::solvers::suspension {
namespace {

constexpr int samples_per_ramp_row = 12;
constexpr int samples_per_hold = 200;
constexpr double samples_per_strain = 20.0;
particles::ParticleStore packed(const ParticleSettings& settings, const particles::ShearBox& box) {
    particles::PackingRequest request;
    if (settings.diameter)
        request.sizes = {{*settings.diameter, 1.0}};
    for (const SizeClass& size : settings.diameters)
        request.sizes.push_back({size.diameter, size.share});
    request.spread = settings.spread;
    request.volume_fraction = settings.volume_fraction;
    request.density = settings.density;
    request.seed = static_cast<std::uint64_t>(settings.seed);
    if (settings.dlvo)
        request.gap = 3.0 * debye_length(*settings.dlvo, settings.temperature);
    try {
        return particles::random_packing(request, box);
    } catch (const particles::PackingError& error) {
        throw UnsuitableScene(fmt::format(
            "particles.volume_fraction = {:.4g}: {}; a smaller fraction, a larger box or "
            "another seed may do",
            settings.volume_fraction, error.what()));
    }
}

SuspensionInput input_for(const Scene& scene, const SuspensionChoice& choice, double initial_speed,
                          double fastest_speed) {
    const auto& box = std::get<geometry::Box>(scene.instrument);
    SuspensionInput input;
    input.box = {.length_x = box.length,
                 .length_y = box.gap,
                 .length_z = box.width,
                 .walls = choice.settings.boundary == ParticleBoundary::walls};
    input.settings = choice.settings;
    input.coupling = scene.coupling;
    input.viscosity = std::get<laws::flow::Newtonian>(scene.fluid.law).viscosity;
    input.density = scene.fluid.density;
    input.accuracy = scene.solver.accuracy;
    input.initial_wall_speed = initial_speed;
    input.fastest_wall_speed = fastest_speed;
    input.particles = packed(choice.settings, input.box);
    input.threads = threads_for(static_cast<double>(input.particles.size()));
    return input;
}

std::unique_ptr<SuspensionMotion> make_motion(SuspensionInput input) {
    if (input.settings.hydrodynamics == Hydrodynamics::lubrication)
        return std::make_unique<OverdampedMotion>(std::move(input));
    return std::make_unique<InertialMotion>(std::move(input));
}

/// Runs a motion and keeps what it gives.
class Run {
public:
    Run(const Scene& scene, SuspensionMotion& motion, const ProgressSink& progress,
        const Checkpointing& checkpointing, const FrameSink& frames, ClaimedError claimed)
        : scene_(scene), motion_(motion), progress_(progress), checkpointing_(checkpointing),
          recorder_(scene.output.trajectory_strain, frames, scene.output.fields),
          walls_(scene.particles->boundary == ParticleBoundary::walls),
          area_(std::get<geometry::Box>(scene.instrument).wall_area()), claimed_(claimed) {
        if (checkpointing.start)
            restore(*checkpointing.start);
    }

    void sample_until(const WallSpeed& speed, double until) {
        // A run that goes on has these samples.
        if (replayed_ < restored_) {
            ++replayed_;
            return;
        }
        recorder_.start(motion_);
        while (motion_.time() < until) {
            const StressSample step = motion_.advance(speed, until);
            mean_.add(step);
            recorder_.see(motion_, step);
            if (++calls_ % 16 == 0) {
                report(motion_.time());
                offer();
            }
        }
        samples_.push_back(mean_.mean());
        mean_.clear();
        sample_start_ = motion_.time();
        replayed_ = restored_ = samples_.size();
        offer();
    }

    /// The state at this moment, for a run that goes on: saved at once.
    void keep() const {
        if (checkpointing_.keep)
            checkpointing_.keep([this] { return save(); });
    }

    void follow(const rheometry::SpeedHistory& history, double discard, bool holds,
                SuspensionReport& report) {
        end_time_ = history.duration();
        const WallSpeed speed = [&](double t) { return history.speed_at(t); };
        std::vector<std::size_t> ends; // of each row's samples
        double before = 0.0;
        const int parts = holds ? samples_per_hold : samples_per_ramp_row;
        const auto finish_row = [&](std::size_t row) {
            const std::size_t first = row == 0 ? 0 : ends[row - 1];
            if (holds)
                return row_of_hold(std::span(samples_).subspan(first, ends[row] - first), walls_,
                                   discard, area_, claimed_);
            // One row further where the same piece goes on, so that the fit is centred.
            const bool goes_on =
                row + 1 < ends.size() &&
                same_piece(history, history.row_times[row], history.row_times[row + 1]);
            const std::size_t last = goes_on ? ends[row + 1] : ends[row];
            return row_of_ramp(std::span(samples_).subspan(first, last - first), walls_,
                               history.row_times[row], area_, claimed_);
        };
        const auto finish_all = [&] {
            for (std::size_t row = report.solution.history.rows.size(); row < ends.size(); ++row) {
                rheometry::TorqueRow done = finish_row(row);
                done.time = history.row_times[row];
                done.speed = history.speed_at(done.time);
                add(done, report);
            }
        };
        try {
            for (const double end : history.row_times) {
                // Of a held step the second half has left the start-up behind in any case.
                recorder_.begin_row(ends.size(), holds ? 0.5 * (before + end) : before);
                for (int part = 1; part <= parts; ++part)
                    sample_until(speed,
                                 part == parts ? end : before + (end - before) * part / parts);
                ends.push_back(replayed_);
                before = end;
            }
        } catch (const Interrupted&) {
            report.solution.interrupted = true;
        } catch (const StepFailure& failure) {
            tell(failure, report);
        }
        finish_all();
        if (!holds)
            widen(history, ends, report);
    }

    /// Each speed until its statistical error is small enough.
    void follow_steady(const rheometry::SteadySpeeds& series, SuspensionReport& report) {
        const double gap = std::get<geometry::Box>(scene_.instrument).gap;
        try {
            for (const double wall_speed : series.speeds) {
                const double rate = std::abs(wall_speed) / gap;
                const std::size_t first = replayed_;
                const double start = time_after(first);
                recorder_.begin_row(report.solution.history.rows.size(), start + 1.0 / rate);
                const WallSpeed speed = [wall_speed](double) { return wall_speed; };
                end_time_ = start + 10.0 / rate *
                                        static_cast<double>(series.speeds.size() -
                                                            report.solution.history.rows.size());
                rheometry::TorqueRow row;
                bool settled = false;
                for (double strain = 2.0; strain <= steady_strain_cap && !settled; strain += 1.0) {
                    while (time_after(replayed_) < start + (strain - 1e-6) / rate)
                        sample_until(speed,
                                     time_after(replayed_) + 1.0 / (samples_per_strain * rate));
                    row = row_of_hold(std::span(samples_).subspan(first, replayed_ - first), walls_,
                                      -1.0, area_, claimed_);
                    settled = row.suspension->statistical_error <=
                              steady_statistical_error * std::abs(row.suspension->total());
                }
                row.time = time_after(replayed_);
                row.speed = wall_speed;
                add(row, report);
                if (!settled) {
                    report.solution.reached = false;
                    report.solution.notes.push_back(fmt::format(
                        "At {:.4g} 1/s the statistical error is still {:.2g} % after a strain of "
                        "{:.0f}, where a hold = \"steady\" ends.",
                        rate,
                        100.0 * row.suspension->statistical_error /
                            std::abs(row.suspension->total()),
                        steady_strain_cap));
                }
            }
        } catch (const Interrupted&) {
            report.solution.interrupted = true;
        } catch (const StepFailure& failure) {
            tell(failure, report);
        }
    }

    std::vector<StressSample> take_samples() { return std::move(samples_); }
    [[nodiscard]] const RunRecorder& recorder() const { return recorder_; }

private:
    /// End of the first `count` samples, s.
    [[nodiscard]] double time_after(std::size_t count) const {
        if (count == 0)
            return 0.0;
        if (count == samples_.size() && replayed_ == restored_)
            return sample_start_;
        const StressSample& last = samples_[count - 1];
        return last.time + 0.5 * last.duration;
    }

    [[nodiscard]] Checkpoint save() const {
        Checkpoint checkpoint;
        motion_.save(checkpoint);
        std::vector<double> numbers;
        for (const StressSample& sample : samples_) {
            const auto values = sample.values();
            numbers.insert(numbers.end(), values.begin(), values.end());
        }
        checkpoint.put("samples", numbers);
        checkpoint.put("sample_under_way", mean_.sums());
        checkpoint.put("sample_start", sample_start_);
        recorder_.save(checkpoint);
        return checkpoint;
    }

    void offer() const {
        if (checkpointing_.offer)
            checkpointing_.offer([this] { return save(); });
    }

    void restore(const Checkpoint& checkpoint) {
        motion_.restore(checkpoint);
        const std::vector<double>& numbers = checkpoint.column("samples");
        for (std::size_t k = 0; k + StressSample::size <= numbers.size(); k += StressSample::size) {
            std::array<double, StressSample::size> values{};
            std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(k), values.size(),
                        values.begin());
            samples_.push_back(StressSample::from(values));
        }
        restored_ = samples_.size();
        std::array<double, StressSample::size> sums{};
        for (std::size_t k = 0; k < sums.size(); ++k)
            sums[k] = checkpoint.column("sample_under_way").at(k);
        mean_.restore(sums);
        sample_start_ = checkpoint.number("sample_start");
        recorder_.restore(checkpoint);
    }

    /// A step that cannot be taken ends the run; the rows before it are kept, if there are any.
    static void tell(const StepFailure& failure, SuspensionReport& report) {
        report.solution.reached = false;
        report.failure = failure.what();
        report.solution.notes.push_back(fmt::format("The run stopped: {}.", failure.what()));
    }

    /// Each piece's rows by what all of its samples tell.
    void widen(const rheometry::SpeedHistory& history, const std::vector<std::size_t>& ends,
               SuspensionReport& report) const {
        auto& rows = report.solution.history.rows;
        std::size_t first = 0;
        for (std::size_t last = 0; last < rows.size(); ++last) {
            const bool goes_on =
                last + 1 < rows.size() &&
                same_piece(history, history.row_times[last], history.row_times[last + 1]);
            if (goes_on)
                continue;
            const std::size_t begin = first == 0 ? 0 : ends[first - 1];
            widen_by_piece(std::span(samples_).subspan(begin, ends[last] - begin), walls_,
                           samples_per_ramp_row, std::span(rows).subspan(first, last + 1 - first));
            first = last + 1;
        }
    }

    static bool same_piece(const rheometry::SpeedHistory& history, double one, double other) {
        for (const auto& piece : history.pieces)
            if (one > piece.start_time && one <= piece.end_time)
                return other > piece.start_time && other <= piece.end_time;
        return false;
    }

    void add(rheometry::TorqueRow row, SuspensionReport& report) const {
        const radial::SteadyInstrumentFlow flow =
            radial::steady_instrument_flow(scene_.instrument, scene_.fluid.law, row.speed);
        row.steady_torque = flow.torque;
        row.rotor_wall_rate = flow.rotor_wall_rate;
        const double size = std::abs(row.torque);
        if (size > 0.0) {
            report.solution.worst_relative_error =
                std::max(report.solution.worst_relative_error, row.torque_error / size);
            const double bulk = row.suspension->bulk_total() * area_;
            report.solution.worst_torque_imbalance = std::max(
                report.solution.worst_torque_imbalance, std::abs(row.torque - bulk) / size);
        }
        if (row.torque_error > scene_.solver.accuracy * size && size > 0.0)
            report.solution.reached = false;
        report.solution.history.rows.push_back(row);
    }

    void report(double time) const {
        if (progress_)
            progress_(end_time_ > 0.0 ? std::clamp(time / end_time_, 0.0, 1.0) : 0.0,
                      fmt::format("particles at t = {:.4g} s", time));
    }

    const Scene& scene_;
    SuspensionMotion& motion_;
    const ProgressSink& progress_;
    const Checkpointing& checkpointing_;
    std::size_t restored_ = 0; ///< samples of a run that goes on
    std::size_t replayed_ = 0; ///< of them, passed again by the loops over the protocol
    RunRecorder recorder_;
    SampleMean mean_;           ///< of the sample under way
    double sample_start_ = 0.0; ///< s
    bool walls_;
    double area_;
    ClaimedError claimed_;
    double end_time_ = 0.0;
    long calls_ = 0;
    std::vector<StressSample> samples_;
};

} // namespace

int threads_for(double particles) {
    // Below this number of them a second thread costs more than it gives.
    constexpr double particles_per_thread = 10000.0;
    const auto most = std::max(1U, std::thread::hardware_concurrency());
    const auto useful = static_cast<unsigned>(particles / particles_per_thread);
    return static_cast<int>(std::clamp(useful, 1U, std::min(most, 16U)));
}

SuspensionReport solve_suspension(const Scene& scene, const Plan& plan,
                                  const ProgressSink& progress, const Checkpointing& checkpointing,
                                  const FrameSink& frames) {
    SuspensionReport report;
    report.solution.transient = true;
    const SuspensionChoice choice = choose(scene);
    const rheometry::Conversion conversion =
        rheometry::conversion_for(scene.instrument, scene.conversion);
    const auto schedule = rheometry::schedule(scene.protocol, conversion);
    const auto* steady = std::get_if<rheometry::SteadySpeeds>(&schedule);
    const auto* history = std::get_if<rheometry::SpeedHistory>(&schedule);
    double initial = 0.0;
    double fastest = 0.0;
    if (steady) {
        initial = steady->speeds.front();
        for (const double speed : steady->speeds)
            fastest = std::max(fastest, std::abs(speed));
    } else {
        // Held steps start in the flow of the first; its start-up is discarded in any case.
        initial = history->initial_speed;
        fastest = history->fastest_speed();
    }
    if (progress)
        progress(0.0, "packing the particles");
    SuspensionInput input = input_for(scene, choice, initial, fastest);
    const ClaimedError claimed = claimed_error(input);
    const std::unique_ptr<SuspensionMotion> motion = make_motion(std::move(input));
    Run run(scene, *motion, progress, checkpointing, frames, claimed);
    const auto* steps = std::get_if<rheometry::Steps>(&scene.protocol.program);
    if (steady)
        run.follow_steady(*steady, report);
    else
        run.follow(*history, steps ? steps->discard_strain.value_or(-1.0) : -1.0, steps != nullptr,
                   report);
    if (report.solution.interrupted || (checkpointing.keep_finished && report.failure.empty()))
        run.keep();
    if (!report.failure.empty() && report.solution.history.rows.empty())
        throw StepFailure(report.failure);
    const StepCounts counts = motion->counts();
    report.solution.refinements = 1;
    report.solution.elements = std::max(0, static_cast<int>(motion->fluid_velocity().size()) - 1);
    report.solution.time_steps = counts.steps;
    report.solution.linear_solves = counts.fluid_steps + counts.solver_iterations;
    report.solution.unknowns = plan.expected_unknowns;
    if (const std::string note =
            note_on_scatter(report.solution.history.rows, scene.solver.accuracy);
        !note.empty())
        report.solution.notes.push_back(note);
    report.structure = run.recorder().structure();
    report.samples = run.take_samples();
    return report;
}

} // namespace searle::solvers::suspension
