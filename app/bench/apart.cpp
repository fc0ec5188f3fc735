#include "app/bench/apart.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fcntl.h>
#include <poll.h>
#include <string_view>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace searle::app::bench {
namespace {

using Clock = std::chrono::steady_clock;

void write_all(int file, const void* data, std::size_t size) {
    const char* next = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t written = write(file, next, size);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return;
        next += written;
        size -= static_cast<std::size_t>(written);
    }
}

/// Ctrl-C ends a child as it ends any program.
void take_signals_as_usual() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        std::signal(signal, SIG_DFL);
}

/// The first byte says whether a result ('v') or a fault ('f') follows.
[[noreturn]] void work_and_hand_back(const std::function<std::vector<double>()>& work, int pipe) {
    take_signals_as_usual();
    try {
        const std::vector<double> values = work();
        write_all(pipe, "v", 1);
        write_all(pipe, values.data(), values.size() * sizeof(double));
    } catch (const std::exception& error) {
        const std::string text = std::string("f") + error.what();
        write_all(pipe, text.data(), text.size());
    }
    // No destructors and no flushing: the buffers of the standard streams are the parent's.
    _exit(0);
}

/// Waits for a process and, where there is a pipe, takes what it hands back.
struct Watched {
    std::string taken;
    int status{};
    rusage usage{};
    bool timed_out{};
    bool stopped{};
};

Watched watch(pid_t child, int pipe, double limit, const StopQuestion& stop) {
    Watched result;
    const auto end = Clock::now() + std::chrono::duration<double>(limit);
    const auto take = [&] {
        char part[65536];
        for (ssize_t size = 0; (size = read(pipe, part, sizeof part)) > 0;)
            result.taken.append(part, static_cast<std::size_t>(size));
    };
    if (pipe >= 0)
        fcntl(pipe, F_SETFL, O_NONBLOCK);
    int wait_ms = 1;
    while (wait4(child, &result.status, WNOHANG, &result.usage) != child) {
        result.timed_out = Clock::now() > end;
        result.stopped = stop && stop();
        if (result.timed_out || result.stopped) {
            kill(child, SIGKILL);
            while (wait4(child, &result.status, 0, &result.usage) < 0 && errno == EINTR) {
            }
            break;
        }
        pollfd waited{pipe, POLLIN, 0};
        poll(&waited, pipe >= 0 ? 1 : 0, wait_ms);
        if (pipe >= 0)
            take();
        if (pipe >= 0 && (waited.revents & POLLHUP) != 0)
            usleep(500);
        wait_ms = std::min(10, wait_ms + 1);
    }
    if (pipe >= 0)
        take();
    return result;
}

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

Ended ended(const Watched& watched) {
    Ended end;
    end.cpu = seconds(watched.usage.ru_utime) + seconds(watched.usage.ru_stime);
    end.peak_MiB = static_cast<double>(watched.usage.ru_maxrss) / 1024.0;
    end.timed_out = watched.timed_out;
    if (watched.timed_out)
        end.fault = fmt::format("ended after {:.0f} CPU s: no time left", end.cpu);
    else if (watched.stopped)
        end.fault = "interrupted";
    else if (WIFSIGNALED(watched.status))
        end.fault = fmt::format("ended by signal {}", WTERMSIG(watched.status));
    else if (WEXITSTATUS(watched.status) != 0)
        end.fault = fmt::format("exit code {}", WEXITSTATUS(watched.status));
    return end;
}

} // namespace

double process_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Ended work_apart(const std::function<std::vector<double>()>& work, double limit,
                 const StopQuestion& stop) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        return {.fault = "no pipe to a process of its own"};
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        work_and_hand_back(work, ends[1]);
    }
    close(ends[1]);
    if (child < 0) {
        close(ends[0]);
        return {.fault = "no process of its own"};
    }
    const Watched watched = watch(child, ends[0], limit, stop);
    close(ends[0]);
    Ended end = ended(watched);
    if (!end.fault.empty())
        return end;
    const std::string_view taken = watched.taken;
    if (taken.empty() || taken.front() == 'f') {
        end.fault = taken.empty() ? "no result" : std::string(taken.substr(1));
        return end;
    }
    end.values.resize((taken.size() - 1) / sizeof(double));
    taken.copy(reinterpret_cast<char*>(end.values.data()), end.values.size() * sizeof(double), 1);
    return end;
}

Ended run_program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                  const std::vector<std::string>& environment, double limit,
                  const StopQuestion& stop) {
    std::vector<std::string> own = words;
    std::vector<char*> pointers;
    for (std::string& word : own)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const std::string log = (folder / "log").string();
    const pid_t child = fork();
    if (child == 0) {
        take_signals_as_usual();
        const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        const int in = open("/dev/null", O_RDONLY);
        if (out < 0 || in < 0 || chdir(folder.c_str()) != 0)
            _exit(126);
        dup2(in, 0);
        dup2(out, 1);
        dup2(out, 2);
        setenv("PWD", folder.c_str(), 1);
        for (const std::string& variable : environment)
            if (const std::size_t equals = variable.find('='); equals != std::string::npos)
                setenv(variable.substr(0, equals).c_str(), variable.c_str() + equals + 1, 1);
        execvp(pointers[0], pointers.data());
        _exit(127);
    }
    if (child < 0)
        return {.fault = "no process of its own"};
    Ended end = ended(watch(child, -1, limit, stop));
    if (!end.fault.empty())
        end.fault = words.front() + ": " + end.fault;
    return end;
}

bool is_installed(const std::string& program) {
    const char* variable = std::getenv("PATH");
    std::string_view rest = variable == nullptr ? "" : variable;
    while (!rest.empty()) {
        const std::size_t colon = rest.find(':');
        const auto candidate = std::filesystem::path(rest.substr(0, colon)) / program;
        if (access(candidate.c_str(), X_OK) == 0)
            return true;
        rest = colon == std::string_view::npos ? "" : rest.substr(colon + 1);
    }
    return false;
}

} // namespace searle::app::bench
