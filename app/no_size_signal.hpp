#pragma once

#include <csignal>

namespace searle::app {

/// While it lives, a write beyond the file size limit is an error and no signal.
class NoSizeSignal {
public:
    NoSizeSignal() { before_ = std::signal(SIGXFSZ, SIG_IGN); }
    ~NoSizeSignal() { std::signal(SIGXFSZ, before_); }
    NoSizeSignal(const NoSizeSignal&) = delete;
    NoSizeSignal& operator=(const NoSizeSignal&) = delete;

private:
    void (*before_)(int) = nullptr;
};

} // namespace searle::app
