#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <unistd.h>

namespace searle::fuzz {

/// Reads one input as a user's file; the reader's own messages are no findings, everything else is.
void read_case_file(std::string_view bytes);
void read_measured_csv(std::string_view bytes);
void read_measured_json(std::string_view bytes);
void read_rheogram(std::string_view bytes);
void read_moments(std::string_view bytes);
void read_checkpoint_file(std::string_view bytes);

struct Reader {
    const char* name; ///< of its folder under tests/fuzz/inputs
    void (*read)(std::string_view bytes);
};
inline constexpr Reader readers[] = {
    {"case", read_case_file},    {"csv", read_measured_csv}, {"json", read_measured_json},
    {"rheogram", read_rheogram}, {"moments", read_moments},  {"checkpoint", read_checkpoint_file}};

/// A file of this process with the given bytes, for readers that take a path.
inline std::filesystem::path file_of(std::string_view bytes, const std::string& name) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("searle-fuzz-" + std::to_string(getpid()));
    const std::filesystem::path file = folder / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return file;
}

} // namespace searle::fuzz
