#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <unistd.h>

namespace searle::fuzz {

/// Of this process: each input takes the place of the one before.
inline std::filesystem::path temporary_folder() {
    return std::filesystem::temp_directory_path() / ("searle-fuzz-" + std::to_string(getpid()));
}

/// A file with the given bytes, for readers that take a path.
inline std::filesystem::path file_of(std::string_view bytes, const std::filesystem::path& name) {
    std::filesystem::path file = temporary_folder() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return file;
}

} // namespace searle::fuzz
