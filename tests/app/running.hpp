#pragma once

#include "places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <vector>

namespace searle::app::testing {

/// A folder of its own for a test, removed at the end.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "searle-test-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw std::filesystem::filesystem_error(
                "mkdtemp", std::error_code(errno, std::generic_category()));
        path_ = std::filesystem::canonical(name);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
        return path_ / name;
    }

private:
    std::filesystem::path path_;
};

inline std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write_text(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
}

/// Names in a folder, hidden ones included, sorted and joined by blanks.
inline std::string names_in(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    std::string joined;
    for (const std::string& name : names)
        joined += (joined.empty() ? "" : " ") + name;
    return joined;
}

/// How to start a program.
struct Start {
    std::vector<std::string> arguments{};
    std::filesystem::path directory = "/";
    std::filesystem::path program = SEARLE_PROGRAM;
    bool close_stdin = false;
    /// Bytes that a file may have; a write beyond it fails, as on a full disk.
    std::optional<rlim_t> file_size_limit{};
    /// Sent once the text `signal_when` has appeared on stderr.
    std::optional<int> signal{};
    std::string signal_when{};
    /// User to run as; only root can ask for another.
    std::optional<uid_t> user{};
};

struct Outcome {
    int exit_code{}; ///< 128 + number when a signal ended it
    std::string out;
    std::string err;
};

/// Runs a program to its end and collects what it printed.
inline Outcome run(const Start& start) {
    const TemporaryFolder streams;
    const std::string out = streams / "out";
    const std::string err = streams / "err";
    std::vector<std::string> words{start.program.string()};
    words.insert(words.end(), start.arguments.begin(), start.arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);

    const int out_file = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int err_file = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const pid_t child = fork();
    if (child == 0) {
        if (chdir(start.directory.c_str()) != 0)
            _exit(126);
        dup2(out_file, 1);
        dup2(err_file, 2);
        if (start.close_stdin)
            close(0);
        else
            dup2(open("/dev/null", O_RDONLY), 0);
        if (start.file_size_limit) {
            const rlimit limit{*start.file_size_limit, *start.file_size_limit};
            setrlimit(RLIMIT_FSIZE, &limit);
        }
        if (start.user && setuid(*start.user) != 0)
            _exit(126);
        execv(pointers[0], pointers.data());
        _exit(127);
    }
    close(out_file);
    close(err_file);
    int status = 0;
    bool ended = false;
    if (start.signal) {
        const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(30);
        while (!ended && text_of(err).find(start.signal_when) == std::string::npos &&
               std::chrono::steady_clock::now() < give_up) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            ended = waitpid(child, &status, WNOHANG) == child;
        }
        if (!ended)
            kill(child, *start.signal);
    }
    if (!ended)
        waitpid(child, &status, 0);
    return {.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            .out = text_of(out),
            .err = text_of(err)};
}

/// Runs the built searle.
inline Outcome searle(std::vector<std::string> arguments, const std::filesystem::path& directory) {
    return run({.arguments = std::move(arguments), .directory = directory});
}

} // namespace searle::app::testing
