#include "app/stage_clock.hpp"

#include <ctime>
#include <numeric>
#include <sys/resource.h>

namespace searle::app {
namespace {

double seconds(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Of this process and of the programs that it ran and waited for.
double processor_seconds() {
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    const auto of = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(CLOCK_PROCESS_CPUTIME_ID) + of(children.ru_utime) + of(children.ru_stime);
}

} // namespace

StageClock::StageClock() : wall_start_(seconds(CLOCK_MONOTONIC)), cpu_start_(processor_seconds()) {}

void StageClock::end_stage(std::string name) {
    const double wall = seconds(CLOCK_MONOTONIC);
    const double cpu = processor_seconds();
    stages_.push_back({std::move(name), wall - wall_start_, cpu - cpu_start_});
    wall_start_ = wall;
    cpu_start_ = cpu;
}

double StageClock::wall_seconds() const {
    return std::accumulate(stages_.begin(), stages_.end(), 0.0,
                           [](double sum, const StageSeconds& stage) { return sum + stage.wall; });
}

} // namespace searle::app
