#include "tests/fuzz/readers.hpp"
#include "tests/fuzz/readers/measured_file.hpp"
#include "tests/fuzz/temporary_file.hpp"
#include "tests/rheometry/small_zip.hpp"

#include <array>

namespace searle::fuzz {
namespace {

/// A change of a part breaks the archive's checksums, so the parts, apart from each other by the
/// byte 0x1E, are archived here.
std::string archive_of(std::string_view bytes) {
    constexpr std::array names{"xl/workbook.xml", "xl/_rels/workbook.xml.rels",
                               "xl/worksheets/sheet1.xml", "xl/sharedStrings.xml",
                               "xl/worksheets/sheet2.xml"};
    std::vector<std::pair<std::string, std::string>> parts;
    for (const char* name : names) {
        const std::size_t end = bytes.find('\x1E');
        parts.emplace_back(name, bytes.substr(0, end));
        if (end == std::string_view::npos)
            break;
        bytes.remove_prefix(end + 1);
    }
    return test::zip_of(parts);
}

} // namespace

void read_xlsx(std::string_view bytes) {
    const bool is_archive = bytes.starts_with("PK");
    read_measured_file(file_of(is_archive ? std::string(bytes) : archive_of(bytes), "book.xlsx"));
}

} // namespace searle::fuzz
