#include "app/stage_clock.hpp"

#include <ctime>
#include <numeric>

namespace searle::app {
namespace {

double seconds(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

StageClock::StageClock()
    : wall_start_(seconds(CLOCK_MONOTONIC)), cpu_start_(seconds(CLOCK_PROCESS_CPUTIME_ID)) {}

void StageClock::end_stage(std::string name) {
    const double wall = seconds(CLOCK_MONOTONIC);
    const double cpu = seconds(CLOCK_PROCESS_CPUTIME_ID);
    stages_.push_back({std::move(name), wall - wall_start_, cpu - cpu_start_});
    wall_start_ = wall;
    cpu_start_ = cpu;
}

double StageClock::wall_seconds() const {
    return std::accumulate(stages_.begin(), stages_.end(), 0.0,
                           [](double sum, const StageSeconds& stage) { return sum + stage.wall; });
}

} // namespace searle::app
