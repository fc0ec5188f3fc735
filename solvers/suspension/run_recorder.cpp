#include "solvers/suspension/run_recorder.hpp"

#include <cmath>
#include <fmt/format.h>

namespace searle::solvers::suspension {
namespace {

/// Strain between snapshots: in less the particles hardly change places.
constexpr double snapshot_strain = 0.05;

std::string column_of(std::size_t row) { return fmt::format("structure_{:06}", row); }

} // namespace

void RunRecorder::begin_row(std::size_t row, double from) {
    row_ = row;
    from_ = from;
}

void RunRecorder::write_frame(const SuspensionMotion& motion) {
    times_.push_back(motion.time());
    frames_({motion.particles(), motion.box(), times_});
}

void RunRecorder::start(const SuspensionMotion& motion) {
    if (frame_strain_ && frames_ && times_.empty())
        write_frame(motion);
}

void RunRecorder::see(const SuspensionMotion& motion, const StressSample& step) {
    strain_ += std::abs(step.shear_rate) * step.duration;
    // The frames so far, the one at the start included, are as many as multiples were passed.
    if (frame_strain_ && frames_ &&
        strain_ >= *frame_strain_ * static_cast<double>(times_.size()) * (1.0 - 1e-12))
        write_frame(motion);
    if (!keeps_structure_ || motion.time() < from_)
        return;
    if (strain_ < next_snapshot_ && structure_.contains(row_))
        return;
    structure_[row_].add(motion.particles(), motion.box(), motion.fluid_velocity());
    next_snapshot_ = strain_ + snapshot_strain;
}

void RunRecorder::save(Checkpoint& into) const {
    into.put("frame_times", times_);
    into.put("recorded", std::vector<double>{strain_, next_snapshot_});
    std::vector<double> rows;
    for (const auto& [row, structure] : structure_) {
        rows.push_back(static_cast<double>(row));
        into.put(column_of(row), structure.numbers());
    }
    into.put("structure_rows", rows);
}

void RunRecorder::restore(const Checkpoint& from) {
    from.get("frame_times", times_);
    const std::vector<double>& recorded = from.column("recorded");
    strain_ = recorded.at(0);
    next_snapshot_ = recorded.at(1);
    for (const double row : from.column("structure_rows")) {
        const auto index = static_cast<std::size_t>(row);
        structure_[index] = Microstructure::from(from.column(column_of(index)));
    }
}

} // namespace searle::solvers::suspension
