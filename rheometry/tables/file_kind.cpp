#include "rheometry/tables/file_kind.hpp"

#include "rheometry/tables/table_error.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <system_error>
#include <vector>

namespace searle::rheometry {
namespace {

constexpr std::size_t largest_file = std::size_t{1} << 30U;

[[noreturn]] void fail(const std::filesystem::path& file, const char* message) {
    throw TableError(file.string(), {{.line = 0, .column = {}, .message = message}});
}

} // namespace

FileKind kind_of(const std::filesystem::path& file) {
    constexpr std::string_view compound_file = "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1";
    constexpr std::string_view zip_archive = "PK\x03\x04";
    std::array<char, 64> bytes{};
    std::ifstream stream(file, std::ios::binary);
    stream.read(bytes.data(), bytes.size());
    std::string_view start(bytes.data(), static_cast<std::size_t>(stream.gcount()));
    if (start.starts_with(compound_file))
        return FileKind::binary_workbook;
    if (start.starts_with(zip_archive))
        return FileKind::open_workbook;
    if (start.starts_with("\xEF\xBB\xBF"))
        start.remove_prefix(3);
    start.remove_prefix(std::min(start.size(), start.find_first_not_of(" \t\r\n")));
    return start.starts_with('{') ? FileKind::json : FileKind::text;
}

std::string bytes_of(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        fail(file, "this is a directory; a file is needed");
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        fail(file, std::filesystem::exists(file, ignored) ? "the file cannot be opened"
                                                          : "there is no such file");
    std::string bytes;
    std::vector<char> block(std::size_t{1} << 20U);
    while (stream.read(block.data(), static_cast<std::streamsize>(block.size())) ||
           stream.gcount() > 0) {
        bytes.append(block.data(), static_cast<std::size_t>(stream.gcount()));
        if (bytes.size() > largest_file)
            fail(file, "the file is larger than 1 GiB; convert it in parts");
    }
    if (stream.bad())
        fail(file, "the file cannot be read to its end");
    return bytes;
}

} // namespace searle::rheometry
