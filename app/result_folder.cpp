#include "app/result_folder.hpp"

#include "app/no_size_signal.hpp"

#include "app/interrupt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, int error) {
    throw OutputWriteError(
        fmt::format("{} could not be written: {}; what was begun has been removed", path.string(),
                    std::generic_category().message(error)));
}

/// Makes what is missing of a folder's path; removes it again unless kept.
class MissingFolders {
public:
    explicit MissingFolders(const fs::path& folder) {
        std::vector<fs::path> missing;
        for (fs::path at = folder; !fs::exists(at); at = at.parent_path())
            missing.push_back(at);
        for (auto path = missing.rbegin(); path != missing.rend(); ++path) {
            if (mkdir(path->c_str(), 0777) != 0 && errno != EEXIST)
                fail(*path, errno);
            made_.push_back(*path);
        }
    }
    ~MissingFolders() {
        for (auto path = made_.rbegin(); path != made_.rend(); ++path)
            rmdir(path->c_str()); // leaves a folder that someone else has put something into
    }
    MissingFolders(const MissingFolders&) = delete;
    MissingFolders& operator=(const MissingFolders&) = delete;
    void keep() { made_.clear(); }

private:
    std::vector<fs::path> made_;
};

/// A hidden folder with a name of its own, removed with all that is in it.
class StagingFolder {
public:
    StagingFolder(const fs::path& parent, std::string_view name) {
        for (int attempt = 0;; ++attempt) {
            path_ = parent / fmt::format(".{}.partial-{}-{}", name, getpid(), attempt);
            if (mkdir(path_.c_str(), 0777) == 0)
                return;
            if (errno != EEXIST || attempt == 1000)
                fail(parent / name, errno);
        }
    }
    ~StagingFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    StagingFolder(const StagingFolder&) = delete;
    StagingFolder& operator=(const StagingFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// @param final_path  where the file will be in the end, for messages
void write_file(const fs::path& path, const fs::path& final_path, std::string_view content) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0)
        fail(final_path, errno);
    int error = 0;
    while (!content.empty() && error == 0) {
        const ssize_t written = write(file, content.data(), content.size());
        if (written > 0)
            content.remove_prefix(static_cast<std::size_t>(written));
        else if (errno != EINTR)
            error = written == 0 ? ENOSPC : errno;
    }
    // On some file systems a full disk shows only here.
    if (error == 0 && fsync(file) != 0)
        error = errno;
    if (close(file) != 0 && error == 0)
        error = errno;
    if (error != 0)
        fail(final_path, error);
}

void write_all(const fs::path& folder, const fs::path& final_folder,
               const std::vector<ResultFile>& files) {
    for (const ResultFile& file : files) {
        const fs::path path = folder / file.name;
        std::error_code error;
        fs::create_directories(path.parent_path(), error);
        if (error)
            fail(final_folder / file.name, error.value());
        write_file(path, final_folder / file.name, file.content);
    }
}

/// A folder that no other can be put in the place of.
bool is_fixed(const fs::path& folder) {
    struct stat own {};
    struct stat parent {};
    if (stat(folder.c_str(), &own) != 0 || stat(folder.parent_path().c_str(), &parent) != 0)
        return false;
    return own.st_dev != parent.st_dev || fs::equivalent(folder, fs::current_path()) ||
           access(folder.parent_path().c_str(), W_OK | X_OK) != 0;
}

/// Moves the entries of `from` into `to`, in place of those of the same name; summary.json last.
void move_entries(const fs::path& from, const fs::path& to) {
    std::vector<fs::path> names;
    for (const auto& entry : fs::directory_iterator(from))
        names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end(), [](const fs::path& left, const fs::path& right) {
        const bool left_last = left == "summary.json";
        const bool right_last = right == "summary.json";
        return left_last != right_last ? right_last : left < right;
    });
    for (const fs::path& name : names)
        fs::rename(from / name, to / name);
}

void fill_fixed(const fs::path& folder, const std::vector<ResultFile>& files) {
    const StagingFolder staging(folder, "new");
    write_all(staging.path(), folder, files);
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path() != staging.path())
            old.push_back(entry.path());
    for (const fs::path& path : old)
        fs::remove_all(path);
    move_entries(staging.path(), folder);
}

void put_in_place(const fs::path& folder, const std::vector<ResultFile>& files, Occupant occupant) {
    MissingFolders parents(folder.parent_path());
    const StagingFolder staging(folder.parent_path(), folder.filename().string());
    write_all(staging.path(), folder, files);
    const unsigned how = occupant == Occupant::nothing   ? RENAME_NOREPLACE
                         : occupant == Occupant::results ? RENAME_EXCHANGE
                                                         : 0U;
    // An exchange leaves the old results in the staging folder, which goes away with them.
    int failed = renameat2(AT_FDCWD, staging.path().c_str(), AT_FDCWD, folder.c_str(), how);
    if (failed != 0 && errno == EINVAL && how != 0U) { // a file system without such renames
        if (occupant == Occupant::results) {
            const StagingFolder old(folder.parent_path(), folder.filename().string());
            fs::rename(folder, old.path());
            fs::rename(staging.path(), folder);
            failed = 0;
        } else {
            failed = std::rename(staging.path().c_str(), folder.c_str());
        }
    }
    if (failed != 0 && (errno == EEXIST || errno == ENOTEMPTY))
        throw OutputPlaceError(
            fmt::format("{}: another program has put something there meanwhile", folder.string()));
    if (failed != 0)
        fail(folder, errno);
    parents.keep();
}

} // namespace

void write_result_folder(const fs::path& folder, const std::vector<ResultFile>& files,
                         bool replace) try {
    const SignalsHeld no_interrupt;
    const NoSizeSignal no_size_signal;
    const Occupant occupant = check_output_place(folder, replace);
    const fs::path settled = settled_path(folder);
    if (occupant != Occupant::nothing && is_fixed(settled))
        fill_fixed(settled, files);
    else
        put_in_place(settled, files, occupant);
} catch (const fs::filesystem_error& error) {
    fail(folder, error.code().value());
}

void replace_file(const fs::path& file, const std::string& content) try {
    const SignalsHeld no_interrupt;
    const NoSizeSignal no_size_signal;
    const fs::path target = settled_path(file);
    const StagingFolder staging(target.parent_path(), target.filename().string());
    write_file(staging.path() / "new", file, content);
    fs::rename(staging.path() / "new", target);
} catch (const fs::filesystem_error& error) {
    fail(file, error.code().value());
}

} // namespace searle::app
