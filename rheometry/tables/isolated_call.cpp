#include "rheometry/tables/isolated_call.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <string_view>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace searle::rheometry {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

void write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            ::_exit(2);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

std::string read_all(int descriptor) {
    std::string bytes;
    std::array<char, 65536> block{};
    while (true) {
        const ssize_t count = ::read(descriptor, block.data(), block.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            return bytes;
        bytes.append(block.data(), static_cast<std::size_t>(count));
    }
}

/// Bytes of addresses in use; 0 where the system does not say.
rlim_t addresses_in_use() {
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

void set_limits(const IsolationLimits& limits) {
    const rlimit no_core{0, 0};
    const rlimit time{limits.processor_seconds, limits.processor_seconds};
    ::setrlimit(RLIMIT_CORE, &no_core);
    ::setrlimit(RLIMIT_CPU, &time);
    // The address sanitizer takes terabytes of addresses, without memory behind them.
    if (const rlim_t used = addresses_in_use(); used > 0 && !sanitized) {
        const rlimit memory{used + limits.memory, used + limits.memory};
        ::setrlimit(RLIMIT_AS, &memory);
    }
}

[[noreturn]] void run_child(const std::function<std::string()>& call, int descriptor,
                            const IsolationLimits& limits) {
    set_limits(limits);
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGXCPU, SIGINT, SIGTERM})
        std::signal(signal, SIG_DFL);
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    try {
        write_all(descriptor, call());
    } catch (...) {
        ::_exit(2);
    }
    ::_exit(0);
}

IsolatedResult::Outcome outcome_of(int status) {
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
        return IsolatedResult::Outcome::finished;
    const bool out_of_time =
        WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
    return out_of_time ? IsolatedResult::Outcome::out_of_time : IsolatedResult::Outcome::crashed;
}

} // namespace

IsolatedResult call_isolated(const std::function<std::string()>& call, IsolationLimits limits) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return {};
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        run_child(call, ends[1], limits);
    }
    ::close(ends[1]);
    IsolatedResult result;
    if (child > 0) {
        result.output = read_all(ends[0]);
        int status = 0;
        while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
        }
        result.outcome = outcome_of(status);
    }
    ::close(ends[0]);
    return result;
}

} // namespace searle::rheometry
