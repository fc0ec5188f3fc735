#include "rheometry/tables/measured_data.hpp"

#include "rheometry/tables/spreadsheet.hpp"

#include <array>
#include <fstream>
#include <string_view>

namespace searle::rheometry {
namespace {

bool is_zip_archive(const std::filesystem::path& file) {
    constexpr std::string_view zip = "PK\x03\x04";
    std::array<char, zip.size()> start{};
    std::ifstream stream(file, std::ios::binary);
    return stream.read(start.data(), start.size()) &&
           std::string_view(start.data(), start.size()) == zip;
}

} // namespace

MeasuredData read_measured_data(const std::filesystem::path& file, DriveMotion motion) {
    if (is_zip_archive(file))
        throw TableError(file.string(),
                         {{0,
                           {},
                           "this is an .xlsx workbook (or another zip archive); save it as .xls "
                           "(Excel 97-2003) or as CSV"}});
    if (!looks_like_spreadsheet(file))
        return read_measured_csv(file, motion);
    if (motion == DriveMotion::sliding)
        throw TableError(file.string(), {{0,
                                          {},
                                          "an export of TRIOS is of a turning instrument, but the "
                                          "case's is a box; give a case of the instrument used"}});
    return read_trios_spreadsheet(file);
}

} // namespace searle::rheometry
