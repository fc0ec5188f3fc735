#include "rheometry/tables/measured_data.hpp"

#include "rheometry/tables/file_kind.hpp"
#include "rheometry/tables/open_workbook.hpp"
#include "rheometry/tables/sheet_text.hpp"
#include "rheometry/tables/trios_json.hpp"

#include <fmt/format.h>

namespace searle::rheometry {
namespace {

/// A workbook of plain tables: each sheet that holds anything.
MeasuredData from_plain_sheets(const std::vector<Sheet>& sheets, const std::filesystem::path& file,
                               DriveMotion motion) {
    MeasuredData data;
    for (const Sheet& sheet : sheets) {
        if (sheet.rows == 0)
            continue;
        const CsvTable table = CsvTable::parse(
            tab_delimited(sheet), fmt::format("{}, sheet \"{}\"", file.string(), sheet.name));
        MeasuredData read = measured_from_table(table, motion);
        read.steps.front().name = sheet.name;
        data.steps.push_back(std::move(read.steps.front()));
    }
    if (data.steps.empty())
        throw TableError(file.string(), {{0, {}, "the workbook's sheets are empty"}});
    if (data.steps.size() == 1)
        data.steps.front().name.clear();
    return data;
}

} // namespace

std::vector<Sheet> sheets_of(const std::filesystem::path& file) {
    switch (kind_of(file)) {
    case FileKind::binary_workbook:
        return read_spreadsheet(file);
    case FileKind::open_workbook:
        return read_open_workbook(file);
    case FileKind::json:
        return read_trios_json(file);
    case FileKind::text:
        break;
    }
    return {};
}

MeasuredData read_measured_data(const std::filesystem::path& file, DriveMotion motion) {
    const std::vector<Sheet> sheets = sheets_of(file);
    if (sheets.empty())
        return measured_from_table(CsvTable::read(file), motion);
    if (!is_trios_layout(sheets))
        return from_plain_sheets(sheets, file, motion);
    if (motion == DriveMotion::sliding)
        throw TableError(file.string(), {{0,
                                          {},
                                          "an export of TRIOS is of a turning instrument, but the "
                                          "case's is a box; give a case of the instrument used"}});
    return measured_from_trios(sheets, file.string());
}

} // namespace searle::rheometry
