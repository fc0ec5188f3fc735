#include "solvers/openfoam/child_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

extern char** environ;

namespace searle::solvers::openfoam {
namespace {

using namespace std::chrono_literals;

/// The present environment with OpenFOAM's own variables in it.
std::vector<std::string> environment_for(const ChildProgram& program) {
    const std::vector<std::string> own{
        "WM_PROJECT_DIR=" + program.project.string(), "PWD=" + program.folder.string(),
        "FOAM_SIGFPE=true",         // a division by zero ends the run rather than spreading
        "OMPI_ALLOW_RUN_AS_ROOT=1", // Open MPI's own guard, which says nothing of this machine
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"};
    std::vector<std::string> all = own;
    for (char** at = environ; *at != nullptr; ++at) {
        const std::string_view entry = *at;
        const std::string_view name = entry.substr(0, entry.find('='));
        const bool is_own = std::any_of(own.begin(), own.end(), [&name](const std::string& mine) {
            return std::string_view(mine).substr(0, mine.find('=')) == name;
        });
        if (!is_own)
            all.emplace_back(entry);
    }
    return all;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts)
        pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// In the child: what is between fork and exec may only be calls that are safe after a fork.
[[noreturn]] void become(const ChildProgram& program, char** arguments, char** variables, int log,
                         int report) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM); // a killed parent leaves no solver behind
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, 0);
    dup2(log, 1);
    dup2(log, 2);
    if (chdir(program.folder.c_str()) == 0)
        execvpe(arguments[0], arguments, variables);
    const int cause = errno;
    [[maybe_unused]] const ssize_t written = write(report, &cause, sizeof cause);
    _exit(127);
}

int exit_code_of(int status) {
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

/// Wakes up when a child ends, or after a while; without the kernel's help (before Linux 5.3)
/// always after the while.
class EndSignal {
public:
    explicit EndSignal(pid_t child)
        : handle_(static_cast<int>(syscall(SYS_pidfd_open, child, 0))) {}
    ~EndSignal() {
        if (handle_ >= 0)
            close(handle_);
    }
    EndSignal(const EndSignal&) = delete;
    EndSignal& operator=(const EndSignal&) = delete;

    void wait_for(std::chrono::milliseconds while_) const {
        pollfd watched{handle_, POLLIN, 0};
        if (handle_ < 0)
            std::this_thread::sleep_for(while_);
        else
            (void)poll(&watched, 1, static_cast<int>(while_.count()));
    }

private:
    int handle_;
};

void end_group(pid_t child) {
    kill(-child, SIGTERM);
    for (int i = 0; i < 250; ++i) {
        if (waitpid(child, nullptr, WNOHANG) != 0)
            return;
        std::this_thread::sleep_for(20ms);
    }
    kill(-child, SIGKILL);
    waitpid(child, nullptr, 0);
}

} // namespace

int run_program(const ChildProgram& program, const std::function<void()>& watch) {
    std::vector<std::string> command = program.command;
    std::vector<std::string> environment = environment_for(program);
    std::vector<char*> arguments = pointers_to(command);
    std::vector<char*> variables = pointers_to(environment);
    const int log = open(program.log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (log < 0)
        throw StartFailure(fmt::format("{}: {}", program.log.string(), std::strerror(errno)));
    int report[2];
    if (pipe2(report, O_CLOEXEC) != 0) {
        close(log);
        throw StartFailure(fmt::format("{}: {}", command.front(), std::strerror(errno)));
    }
    const pid_t child = fork();
    if (child == 0)
        become(program, arguments.data(), variables.data(), log, report[1]);
    const int fork_cause = errno;
    close(log);
    close(report[1]);
    int cause = child < 0 ? fork_cause : 0;
    if (child > 0 && read(report[0], &cause, sizeof cause) != static_cast<ssize_t>(sizeof cause))
        cause = 0;
    close(report[0]);
    if (cause != 0) {
        if (child > 0)
            waitpid(child, nullptr, 0);
        throw StartFailure(fmt::format("{}: {}", command.front(), std::strerror(cause)));
    }
    const EndSignal end(child);
    for (;;) {
        int status = 0;
        const pid_t ended = waitpid(child, &status, WNOHANG);
        if (ended == child)
            return exit_code_of(status);
        if (ended < 0 && errno != EINTR)
            throw StartFailure(fmt::format("{}: {}", command.front(), std::strerror(errno)));
        try {
            watch();
        } catch (...) {
            end_group(child);
            throw;
        }
        end.wait_for(50ms);
    }
}

} // namespace searle::solvers::openfoam
