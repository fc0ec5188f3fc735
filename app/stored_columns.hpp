#pragma once

#include "app/hdf5_module/module.hpp"

#include <filesystem>
#include <optional>
#include <stdexcept>

namespace searle::app {

/// A checkpoint that cannot be gone on from: of another case or version, or damaged.
struct CheckpointError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// False when the HDF5 file cannot be written; `errno` may say why. Throws CheckpointError when
/// HDF5 is not there.
[[nodiscard]] bool write_columns(const std::filesystem::path& file, const StoredColumns& columns);

/// No value when the file is damaged or none of HDF5. Throws CheckpointError when HDF5 is not
/// there.
[[nodiscard]] std::optional<StoredColumns> read_columns(const std::filesystem::path& file);

} // namespace searle::app
