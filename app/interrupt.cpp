#include "app/interrupt.hpp"

#include <array>
#include <cstddef>

namespace searle::app {
namespace {

constexpr std::array watched{SIGINT, SIGTERM, SIGHUP};

// A signal handler can reach nothing but a static.
volatile std::sig_atomic_t signal_came = 0;

} // namespace

InterruptWatch::InterruptWatch() {
    signal_came = 0;
    struct sigaction action {};
    action.sa_handler = [](int) { signal_came = 1; };
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    for (std::size_t i = 0; i < watched.size(); ++i) {
        sigaction(watched[i], nullptr, &before_[i]);
        // nohup and background jobs of a shell have them ignored, and want that kept.
        if (before_[i].sa_handler != SIG_IGN)
            sigaction(watched[i], &action, nullptr);
    }
}

InterruptWatch::~InterruptWatch() {
    for (std::size_t i = 0; i < watched.size(); ++i)
        sigaction(watched[i], &before_[i], nullptr);
}

bool InterruptWatch::requested() const { return signal_came != 0; }

SignalsHeld::SignalsHeld() {
    sigset_t held;
    sigemptyset(&held);
    for (const int signal : watched)
        sigaddset(&held, signal);
    sigaddset(&held, SIGPIPE);
    sigprocmask(SIG_BLOCK, &held, &before_);
}

SignalsHeld::~SignalsHeld() { sigprocmask(SIG_SETMASK, &before_, nullptr); }

} // namespace searle::app
