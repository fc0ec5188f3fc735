#pragma once

#include <array>
#include <csignal>

namespace searle::app {

/// While it lives, SIGINT (Ctrl-C), SIGTERM and SIGHUP only set a mark; the second one of a kind
/// ends the program at once. One at a time.
class InterruptWatch {
public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    /// A signal has come since the watch began.
    [[nodiscard]] bool requested() const;

private:
    struct sigaction before_[3]{};
};

/// While it lives, no signal of those ends the program: for writes that must be all or nothing.
class SignalsHeld {
public:
    SignalsHeld();
    ~SignalsHeld();
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

private:
    sigset_t before_{};
};

} // namespace searle::app
