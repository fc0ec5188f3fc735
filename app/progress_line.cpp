#include "app/progress_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace searle::app {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds patience{1000};
constexpr milliseconds between_updates{100};
constexpr milliseconds between_lines{10000};

} // namespace

ProgressLine::ProgressLine(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1), next_(Clock::now() + patience) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::set_prefix(std::string prefix) { prefix_ = std::move(prefix); }

void ProgressLine::show(double fraction, std::string_view stage) {
    if (quiet_)
        return;
    const auto now = Clock::now();
    if (now < next_)
        return;
    next_ = now + (terminal_ ? between_updates : between_lines);
    const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
    const std::string line = fmt::format("searle: {}{} % ({})", prefix_, percent, stage);
    if (terminal_) {
        std::fputs(fmt::format("\r{}\033[K", line).c_str(), stderr);
        visible_ = true;
    } else {
        std::fputs((line + '\n').c_str(), stderr);
    }
    std::fflush(stderr);
}

void ProgressLine::clear() {
    if (visible_)
        std::fputs("\r\033[K", stderr);
    visible_ = false;
}

} // namespace searle::app
