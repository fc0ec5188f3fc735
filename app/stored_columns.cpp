#include "app/stored_columns.hpp"

#include <dlfcn.h>
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

} // namespace

bool write_columns(const fs::path& file, const StoredColumns& columns) {
    const auto write =
        reinterpret_cast<decltype(&searle_hdf5_write)>(module_function("searle_hdf5_write"));
    return write(file.c_str(), &columns);
}

std::optional<StoredColumns> read_columns(const fs::path& file) {
    const auto read =
        reinterpret_cast<decltype(&searle_hdf5_read)>(module_function("searle_hdf5_read"));
    StoredColumns stored;
    if (!read(file.c_str(), &stored))
        return std::nullopt;
    return stored;
}

} // namespace searle::app
