#include "rheometry/tables/isolated_call.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <string_view>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace searle::rheometry {
namespace {

constexpr rlim_t processor_seconds = 20;

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

[[noreturn]] void run_child(const std::function<std::string()>& call, int descriptor) {
    const rlimit no_core{0, 0};
    const rlimit time{processor_seconds, processor_seconds};
    ::setrlimit(RLIMIT_CORE, &no_core);
    ::setrlimit(RLIMIT_CPU, &time);
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

IsolatedResult call_isolated(const std::function<std::string()>& call) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return {};
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        run_child(call, ends[1]);
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
