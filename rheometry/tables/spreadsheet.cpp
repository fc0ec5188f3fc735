#include "rheometry/tables/spreadsheet.hpp"

#include "rheometry/tables/byte_stream.hpp"
#include "rheometry/tables/file_kind.hpp"
#include "rheometry/tables/isolated_call.hpp"

#include <cstdint>
#include <fmt/format.h>
#include <freexl.h>
#include <fstream>
#include <system_error>

namespace searle::rheometry {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, std::string message) {
    throw TableError(file.string(), {{.line = 0, .column = {}, .message = std::move(message)}});
}

// Limits of the format itself (BIFF8).
constexpr unsigned most_rows = 65'536;
constexpr unsigned most_columns = 256;

enum class Kind : std::uint8_t { empty, number, text };
enum class Status : std::uint8_t { read, library_error, password, too_sparse };

class Workbook {
public:
    explicit Workbook(const std::string& path) : code_(freexl_open(path.c_str(), &handle_)) {}
    Workbook(const Workbook&) = delete;
    Workbook& operator=(const Workbook&) = delete;
    ~Workbook() {
        if (handle_ != nullptr)
            freexl_close(handle_);
    }
    [[nodiscard]] int code() const { return code_; }
    [[nodiscard]] const void* handle() const { return handle_; }
    [[nodiscard]] unsigned info(unsigned short what) const {
        unsigned value = 0;
        return freexl_get_info(handle_, what, &value) == FREEXL_OK ? value : 0;
    }

private:
    const void* handle_ = nullptr;
    int code_;
};

/// False for an empty cell.
bool put_cell(ByteWriter& bytes, const FreeXL_CellValue& value) {
    switch (value.type) {
    case FREEXL_CELL_INT:
        bytes.put(Kind::number);
        bytes.put(static_cast<double>(value.value.int_value));
        return true;
    case FREEXL_CELL_DOUBLE:
        bytes.put(Kind::number);
        bytes.put(value.value.double_value);
        return true;
    case FREEXL_CELL_TEXT:
    case FREEXL_CELL_SST_TEXT:
    case FREEXL_CELL_DATE:
    case FREEXL_CELL_DATETIME:
    case FREEXL_CELL_TIME:
        bytes.put(Kind::text);
        bytes.put_text(value.value.text_value != nullptr ? value.value.text_value : "");
        return true;
    default:
        bytes.put(Kind::empty);
        return false;
    }
}

int put_sheet(ByteWriter& bytes, const Workbook& workbook, unsigned index, CellCount& count) {
    const char* name = nullptr;
    unsigned rows = 0;
    unsigned short columns = 0;
    for (const int code :
         {freexl_get_worksheet_name(workbook.handle(), static_cast<unsigned short>(index), &name),
          freexl_select_active_worksheet(workbook.handle(), static_cast<unsigned short>(index)),
          freexl_worksheet_dimensions(workbook.handle(), &rows, &columns)})
        if (code != FREEXL_OK)
            return code;
    // A damaged file may claim billions of rows of no columns.
    if (rows > most_rows || columns > most_columns)
        return FREEXL_CRAFTED_FILE;
    if (columns == 0)
        rows = 0;
    bytes.put_text(name != nullptr ? name : "");
    bytes.put(static_cast<std::uint64_t>(rows));
    bytes.put(static_cast<std::uint64_t>(columns));
    count.all += std::size_t{rows} * columns;
    for (unsigned row = 0; row < rows; ++row) {
        for (unsigned short column = 0; column < columns; ++column) {
            FreeXL_CellValue value{};
            const int code = freexl_get_cell_value(workbook.handle(), row, column, &value);
            if (code != FREEXL_OK)
                return code;
            count.filled += put_cell(bytes, value) ? 1 : 0;
        }
    }
    return FREEXL_OK;
}

std::string status_bytes(Status status, int code) {
    ByteWriter bytes;
    bytes.put(status);
    bytes.put(code);
    return bytes.take();
}

/// Runs in the reading process.
std::string sheets_as_bytes(const std::string& path) {
    const Workbook workbook(path);
    if (workbook.code() != FREEXL_OK)
        return status_bytes(Status::library_error, workbook.code());
    if (workbook.info(FREEXL_BIFF_PASSWORD) == FREEXL_BIFF_OBFUSCATED)
        return status_bytes(Status::password, FREEXL_OK);
    ByteWriter bytes;
    bytes.put(Status::read);
    const unsigned count = workbook.info(FREEXL_BIFF_SHEET_COUNT);
    bytes.put(static_cast<std::uint64_t>(count));
    CellCount cells;
    for (unsigned index = 0; index < count; ++index) {
        const int code = put_sheet(bytes, workbook, index, cells);
        if (code != FREEXL_OK)
            return status_bytes(Status::library_error, code);
        if (is_too_sparse(cells))
            return status_bytes(Status::too_sparse, FREEXL_OK);
    }
    return bytes.take();
}

SheetCell get_cell(ByteReader& bytes) {
    switch (bytes.get<Kind>()) {
    case Kind::number:
        return bytes.get<double>();
    case Kind::text:
        return bytes.get_text();
    case Kind::empty:
        break;
    }
    return std::monostate{};
}

std::vector<Sheet> sheets_from(ByteReader& bytes) {
    std::vector<Sheet> sheets(bytes.get<std::uint64_t>());
    for (Sheet& sheet : sheets) {
        sheet.name = bytes.get_text();
        sheet.rows = bytes.get<std::uint64_t>();
        sheet.columns = bytes.get<std::uint64_t>();
        sheet.cells.resize(sheet.rows * sheet.columns);
        for (SheetCell& cell : sheet.cells)
            cell = get_cell(bytes);
    }
    return sheets;
}

} // namespace

std::string_view Sheet::text(std::size_t row, std::size_t column) const {
    if (row >= rows || column >= columns)
        return {};
    const auto* const found = std::get_if<std::string>(&cell(row, column));
    return found == nullptr ? std::string_view{} : std::string_view(*found);
}

std::vector<Sheet> read_spreadsheet(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        fail(file,
             std::filesystem::exists(file, error) ? "this is not a file" : "there is no such file");
    if (!std::ifstream(file))
        fail(file, "the file cannot be opened");
    if (kind_of(file) != FileKind::binary_workbook)
        fail(file, "this is not a binary workbook (.xls)");
    const std::string path = file.string();
    const IsolatedResult result = call_isolated([&path] { return sheets_as_bytes(path); });
    switch (result.outcome) {
    case IsolatedResult::Outcome::finished:
        break;
    case IsolatedResult::Outcome::crashed:
    case IsolatedResult::Outcome::out_of_time:
        fail(file,
             "the workbook is damaged: its reader could not make sense of it; export it again");
    case IsolatedResult::Outcome::no_process:
        fail(file, "the system would not start a process to read the workbook with");
    }
    ByteReader bytes(result.output);
    const auto status = bytes.get<Status>();
    if (status == Status::password)
        fail(file, "the workbook is protected by a password; save it without one");
    if (status == Status::too_sparse)
        fail(file, "the workbook is damaged: nearly all of its cells are empty; export it again");
    if (status == Status::library_error)
        fail(file, fmt::format("the workbook is damaged or not in the Excel 97-2003 format "
                               "(FreeXL's code {}); export it again, or as CSV",
                               bytes.get<int>()));
    return sheets_from(bytes);
}

std::string spreadsheet_library_version() { return freexl_version(); }

} // namespace searle::rheometry
