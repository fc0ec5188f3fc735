#pragma once

#include "app/stored_columns.hpp"
#include "solvers/suspension/checkpoint.hpp"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace searle::app {

/// Seconds between two checkpoints of a run; what kill -9 loses at most.
inline constexpr double checkpoint_interval = 60.0;

/// Writes an HDF5 file as a whole: beside it first, then renamed. Throws OutputWriteError (a full
/// disk, say); the file that was there before is then still there.
void write_checkpoint(const std::filesystem::path& file,
                      const solvers::suspension::Checkpoint& checkpoint,
                      const std::string& case_hash);

/// No value when there is no such file. Throws CheckpointError.
[[nodiscard]] std::optional<solvers::suspension::Checkpoint>
read_checkpoint(const std::filesystem::path& file, const std::string& case_hash);

/// Keeps a run in `file`: goes on from what is there, and saves every checkpoint_interval. A
/// checkpoint that cannot be written is left out; `trouble` then says why.
class CheckpointKeeper {
public:
    /// @param anew what is there is left aside, whatever it is
    /// @param keep_finished also save a run that is finished: of a sweep
    CheckpointKeeper(std::filesystem::path file, std::string case_hash, bool anew,
                     bool keep_finished = false);
    // The functions that the run calls hold on to this.
    CheckpointKeeper(const CheckpointKeeper&) = delete;
    CheckpointKeeper& operator=(const CheckpointKeeper&) = delete;

    [[nodiscard]] const solvers::suspension::Checkpointing& checkpointing() const {
        return checkpointing_;
    }
    [[nodiscard]] bool goes_on() const { return checkpointing_.start.has_value(); }
    [[nodiscard]] const std::string& trouble() const { return trouble_; }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

private:
    std::filesystem::path file_;
    std::string case_hash_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
    std::string trouble_;
    solvers::suspension::Checkpointing checkpointing_;
};

} // namespace searle::app
