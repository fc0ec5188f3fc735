#include "app/checkpoint_file.hpp"

#include "app/interrupt.hpp"
#include "app/versions.hpp"

#include <fmt/format.h>

#include <bit>
#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <map>
#include <unistd.h>
#include <utility>
#include <vector>

namespace searle::app {
namespace {

namespace fs = std::filesystem;
using solvers::suspension::Checkpoint;

constexpr int format = 6;
constexpr const char* checksum_column = "checksum";

std::string identity(const std::string& case_hash) {
    const auto versions = all_versions();
    const auto program = versions.find("searle");
    return fmt::format("searle {} checkpoint {} case {}",
                       program == versions.end() ? "" : program->second, format, case_hash);
}

/// Of names and values, as two whole numbers of 32 bits: HDF5 hands out what a damaged disk holds,
/// and a run would go on from it.
std::vector<double> checksum_of(const std::map<std::string, std::vector<double>>& columns) {
    constexpr std::uint64_t prime = 0x100000001b3; // of FNV-1a, here on words of 64 bits
    std::uint64_t hash = 0xcbf29ce484222325;
    const auto add = [&hash](std::uint64_t word) { hash = (hash ^ word) * prime ^ hash >> 32U; };
    for (const auto& [name, values] : columns) {
        add(name.size());
        for (const char letter : name)
            add(static_cast<unsigned char>(letter));
        add(values.size());
        for (const double value : values)
            add(std::bit_cast<std::uint64_t>(value));
    }
    return {static_cast<double>(hash >> 32U), static_cast<double>(hash & 0xffffffffU)};
}

/// On the disk for good, not only in the system's memory.
bool synchronised(const fs::path& file) {
    const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        return false;
    const bool done = fsync(descriptor) == 0;
    close(descriptor);
    return done;
}

} // namespace

void write_checkpoint(const fs::path& file, const Checkpoint& checkpoint,
                      const std::string& case_hash) {
    const SignalsHeld no_interrupt;
    const fs::path beside = file.string() + ".new";
    bool good = false;
    errno = 0;
    {
        std::error_code ignored;
        if (file.has_parent_path())
            fs::create_directories(file.parent_path(), ignored);
        StoredColumns stored{identity(case_hash), checkpoint.columns()};
        stored.columns[checksum_column] = checksum_of(checkpoint.columns());
        good = write_columns(beside, stored);
    }
    const int number = errno;
    std::error_code failed;
    if (good && synchronised(beside)) {
        fs::rename(beside, file, failed);
        if (!failed)
            return;
    }
    std::error_code ignored;
    fs::remove(beside, ignored);
    throw CheckpointError(fmt::format(
        "{}: the checkpoint could not be written: {}", file.string(),
        failed ? failed.message() : std::generic_category().message(number == 0 ? EIO : number)));
}

std::optional<Checkpoint> read_checkpoint(const fs::path& file, const std::string& case_hash) {
    if (!fs::exists(file))
        return std::nullopt;
    const auto refuse = [&](const std::string& why) {
        throw CheckpointError(
            fmt::format("{}: {}. Move it away, or start anew with --force (which leaves it aside)",
                        file.string(), why));
    };
    std::optional<StoredColumns> stored = read_columns(file);
    if (!stored)
        refuse("the checkpoint is damaged, or no checkpoint");
    if (stored->identity != identity(case_hash))
        refuse(fmt::format("the checkpoint is of another case or version (\"{}\"; this is \"{}\")",
                           stored->identity, identity(case_hash)));
    const auto checksum = stored->columns.extract(checksum_column);
    if (checksum.empty() || checksum.mapped() != checksum_of(stored->columns))
        refuse("the checkpoint is damaged");
    Checkpoint checkpoint;
    checkpoint.columns() = std::move(stored->columns);
    return checkpoint;
}

CheckpointKeeper::CheckpointKeeper(fs::path file, std::string case_hash, bool anew,
                                   bool keep_finished)
    : file_(std::move(file)), case_hash_(std::move(case_hash)) {
    checkpointing_.keep_finished = keep_finished;
    try {
        checkpointing_.start = read_checkpoint(file_, case_hash_);
    } catch (const CheckpointError&) {
        if (!anew)
            throw;
    }
    checkpointing_.keep = [this](const std::function<Checkpoint()>& make) {
        last_ = std::chrono::steady_clock::now();
        try {
            write_checkpoint(file_, make(), case_hash_);
            trouble_.clear();
        } catch (const CheckpointError& error) {
            trouble_ = error.what();
        }
    };
    checkpointing_.offer = [this](const std::function<Checkpoint()>& make) {
        const auto now = std::chrono::steady_clock::now();
        if (std::chrono::duration<double>(now - last_).count() < checkpoint_interval)
            return;
        checkpointing_.keep(make);
    };
}

} // namespace searle::app
