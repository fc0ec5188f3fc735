#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace searle::app {

/// Shows on stderr how far a computation is, once it takes longer than a second: on a terminal one
/// line that is written over, elsewhere a line now and then. Cleared when destroyed.
class ProgressLine {
public:
    /// @param quiet  show nothing at all
    explicit ProgressLine(bool quiet);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// Text in front of the stage: which run of a sweep, for instance.
    void set_prefix(std::string prefix);
    /// @param fraction  done, 0 ... 1
    void show(double fraction, std::string_view stage);
    /// Takes the line off the terminal, so that something else can be written.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    bool quiet_;
    bool terminal_;
    bool visible_ = false;
    std::string prefix_;
    Clock::time_point next_;
};

} // namespace searle::app
