#pragma once

#include "solvers/suspension/checkpoint.hpp"
#include "solvers/suspension/microstructure.hpp"
#include "solvers/suspension/suspension_motion.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace searle::solvers::suspension {

/// The particles at one moment of a run, for a trajectory.
struct Frame {
    const particles::ParticleStore& particles;
    const particles::ShearBox& box;
    std::span<const double> times; ///< of all frames from the start on, this one last, s
};
/// Called for each frame, in order; after a restart again from the first one that the checkpoint
/// does not count, with the same particles.
using FrameSink = std::function<void(const Frame&)>;

/// Looks on while a run moves: frames of the trajectory, and the microstructure row by row.
class RunRecorder {
public:
    /// @param frame_strain  strain from frame to frame; none: no trajectory
    /// @param structure     whether to keep the microstructure
    RunRecorder(std::optional<double> frame_strain, FrameSink frames, bool structure)
        : frame_strain_(frame_strain), frames_(std::move(frames)), keeps_structure_(structure) {}

    /// @param row   of the rheogram, from 0
    /// @param from  time from which its microstructure counts, s
    void begin_row(std::size_t row, double from);

    /// Before the first step.
    void start(const SuspensionMotion& motion);
    /// After each step.
    void see(const SuspensionMotion& motion, const StressSample& step);

    /// By row; rows without a snapshot have none.
    [[nodiscard]] const std::map<std::size_t, Microstructure>& structure() const {
        return structure_;
    }

    void save(Checkpoint& into) const;
    void restore(const Checkpoint& from);

private:
    void write_frame(const SuspensionMotion& motion);

    std::optional<double> frame_strain_;
    FrameSink frames_;
    bool keeps_structure_;
    std::size_t row_ = 0;
    double from_ = 0.0;
    double strain_ = 0.0;
    double next_snapshot_ = 0.0; ///< strain
    std::vector<double> times_;
    std::map<std::size_t, Microstructure> structure_;
};

} // namespace searle::solvers::suspension
