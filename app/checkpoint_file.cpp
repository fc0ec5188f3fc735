#include "app/checkpoint_file.hpp"

#include "app/interrupt.hpp"
#include "app/versions.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <hdf5.h>
#include <unistd.h>
#include <utility>

namespace searle::app {
namespace {

namespace fs = std::filesystem;
using solvers::suspension::Checkpoint;

constexpr int format = 1;

/// An HDF5 object that is closed when it goes.
class Handle {
public:
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Handle() { shut(); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    [[nodiscard]] hid_t id() const { return id_; }
    [[nodiscard]] bool is_open() const { return id_ >= 0; }
    /// False when closing, which writes what is left, failed.
    bool shut() {
        const bool done = id_ < 0 || close_(id_) >= 0;
        id_ = -1;
        return done;
    }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// HDF5 prints its errors unless told not to.
void keep_quiet() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

std::string identity(const std::string& case_hash) {
    const auto versions = all_versions();
    const auto program = versions.find("searle");
    return fmt::format("searle {} checkpoint {} case {}",
                       program == versions.end() ? "" : program->second, format, case_hash);
}

bool write_text(hid_t file, const char* name, const std::string& text) {
    const hsize_t size = text.size();
    const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    const Handle set(
        H5Dcreate2(file, name, H5T_NATIVE_CHAR, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose);
    return set.is_open() &&
           H5Dwrite(set.id(), H5T_NATIVE_CHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) >= 0;
}

bool write_column(hid_t file, const std::string& name, const std::vector<double>& values) {
    const hsize_t size = values.size();
    const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    const Handle set(H5Dcreate2(file, name.c_str(), H5T_IEEE_F64LE, space.id(), H5P_DEFAULT,
                                H5P_DEFAULT, H5P_DEFAULT),
                     H5Dclose);
    return set.is_open() && (values.empty() || H5Dwrite(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL,
                                                        H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
}

hssize_t points_in(hid_t set) {
    const Handle space(H5Dget_space(set), H5Sclose);
    return space.is_open() ? H5Sget_simple_extent_npoints(space.id()) : -1;
}

struct Collected {
    Checkpoint checkpoint;
    std::string identity;
    bool damaged = false;
};

herr_t collect(hid_t file, const char* name, const H5L_info_t*, void* into) {
    auto& all = *static_cast<Collected*>(into);
    const Handle set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
    const hssize_t points = set.is_open() ? points_in(set.id()) : -1;
    if (points < 0) {
        all.damaged = true;
        return 0;
    }
    const auto count = static_cast<std::size_t>(points);
    if (std::strcmp(name, "identity") == 0) {
        all.identity.resize(count);
        all.damaged |= H5Dread(set.id(), H5T_NATIVE_CHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                               all.identity.data()) < 0;
        return 0;
    }
    std::vector<double>& column = all.checkpoint.columns()[name];
    column.resize(count);
    if (count > 0)
        all.damaged |=
            H5Dread(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, column.data()) < 0;
    return 0;
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
    keep_quiet();
    const SignalsHeld no_interrupt;
    const fs::path beside = file.string() + ".new";
    bool good = false;
    errno = 0;
    {
        std::error_code ignored;
        if (file.has_parent_path())
            fs::create_directories(file.parent_path(), ignored);
        Handle out(H5Fcreate(beside.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
        good = out.is_open() && write_text(out.id(), "identity", identity(case_hash));
        for (const auto& [name, values] : checkpoint.columns())
            good = good && write_column(out.id(), name, values);
        good = out.shut() && good;
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
    keep_quiet();
    if (!fs::exists(file))
        return std::nullopt;
    const auto refuse = [&](const std::string& why) {
        throw CheckpointError(
            fmt::format("{}: {}. Move it away, or start anew with --force (which leaves it aside)",
                        file.string(), why));
    };
    const Handle in(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (!in.is_open())
        refuse("the checkpoint is damaged, or no checkpoint");
    Collected all;
    hsize_t start = 0;
    if (H5Literate(in.id(), H5_INDEX_NAME, H5_ITER_INC, &start, collect, &all) < 0 || all.damaged)
        refuse("the checkpoint is damaged");
    if (all.identity != identity(case_hash))
        refuse(fmt::format("the checkpoint is of another case or version (\"{}\"; this is \"{}\")",
                           all.identity, identity(case_hash)));
    return std::move(all.checkpoint);
}

CheckpointKeeper::CheckpointKeeper(fs::path file, std::string case_hash, bool anew)
    : file_(std::move(file)), case_hash_(std::move(case_hash)) {
    try {
        checkpointing_.start = read_checkpoint(file_, case_hash_);
    } catch (const CheckpointError&) {
        if (!anew)
            throw;
    }
    checkpointing_.offer = [this](const std::function<Checkpoint()>& make) {
        const auto now = std::chrono::steady_clock::now();
        if (std::chrono::duration<double>(now - last_).count() < checkpoint_interval)
            return;
        last_ = now;
        try {
            write_checkpoint(file_, make(), case_hash_);
            trouble_.clear();
        } catch (const CheckpointError& error) {
            trouble_ = error.what();
        }
    };
}

} // namespace searle::app
