#include "app/stored_columns.hpp"

#include "rheometry/tables/byte_stream.hpp"
#include "rheometry/tables/isolated_call.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <dlfcn.h>
#include <string_view>
#include <unistd.h>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

/// The module's function; it is opened once, from beside the program or where it was built.
void* module_function(const char* name) {
    static void* const module = []() -> void* {
        std::error_code ignored;
        const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
        for (const fs::path& path :
             {program.parent_path() / "searle_hdf5.so", fs::path{SEARLE_HDF5_MODULE}})
            if (fs::exists(path, ignored))
                if (void* const opened = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL))
                    return opened;
        return nullptr;
    }();
    void* const function = module == nullptr ? nullptr : dlsym(module, name);
    if (function == nullptr)
        throw CheckpointError("checkpoints need searle_hdf5.so, which is built beside the program, "
                              "and HDF5; one of them is missing");
    return function;
}

std::string as_bytes(const StoredColumns& stored) {
    rheometry::ByteWriter bytes;
    bytes.put_text(stored.identity);
    bytes.put(static_cast<std::uint64_t>(stored.columns.size()));
    for (const auto& [name, column] : stored.columns) {
        bytes.put_text(name);
        bytes.put_column(column);
    }
    return bytes.take();
}

StoredColumns columns_from(std::string_view sent) {
    rheometry::ByteReader bytes(sent);
    StoredColumns stored;
    stored.identity = bytes.get_text();
    const auto count = bytes.get<std::uint64_t>();
    for (std::uint64_t k = 0; k < count; ++k) {
        const std::string name = bytes.get_text();
        stored.columns[name] = bytes.get_column();
    }
    return stored;
}

} // namespace

bool write_columns(const fs::path& file, const StoredColumns& columns) {
    const auto write =
        reinterpret_cast<decltype(&searle_hdf5_write)>(module_function("searle_hdf5_write"));
    return write(file.c_str(), &columns);
}

std::optional<StoredColumns> read_columns(const fs::path& file) {
    const auto read =
        reinterpret_cast<decltype(&searle_hdf5_read)>(module_function("searle_hdf5_read"));
    std::error_code missing;
    const std::uintmax_t size = fs::file_size(file, missing);
    if (missing)
        return std::nullopt;
    // Generous: the columns, their bytes twice while these grow, and 20 MB a second.
    const rheometry::IsolationLimits limits{.processor_seconds =
                                                20 + static_cast<unsigned>(size / 20'000'000),
                                            .memory = 4 * size + (std::size_t{1} << 30U)};
    const rheometry::IsolatedResult result = rheometry::call_isolated(
        [&] {
            StoredColumns stored;
            return read(file.c_str(), &stored) ? as_bytes(stored) : std::string();
        },
        limits);
    if (result.outcome == rheometry::IsolatedResult::Outcome::no_process)
        throw CheckpointError(fmt::format(
            "{}: the system would not start a process to read the checkpoint with", file.string()));
    if (result.outcome != rheometry::IsolatedResult::Outcome::finished || result.output.empty())
        return std::nullopt;
    return columns_from(result.output);
}

} // namespace searle::app
