#pragma once

#include <filesystem>
#include <string>

namespace searle::rheometry {

/// What a data file is by its first bytes, whatever its name ends with.
enum class FileKind {
    text,
    binary_workbook, ///< .xls: an OLE compound file
    open_workbook,   ///< .xlsx: a zip archive
    json
};

/// A file that cannot be opened counts as text: whoever reads it says why.
[[nodiscard]] FileKind kind_of(const std::filesystem::path& file);

/// All bytes of a file. Throws TableError for a folder, a file that is missing or cannot be read,
/// and one of more than 1 GiB.
[[nodiscard]] std::string bytes_of(const std::filesystem::path& file);

} // namespace searle::rheometry
