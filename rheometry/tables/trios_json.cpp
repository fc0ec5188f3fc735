#include "rheometry/tables/trios_json.hpp"

#include "rheometry/tables/file_kind.hpp"
#include "rheometry/tables/number_text.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>

namespace searle::rheometry {
namespace {

// Order of columns and steps as in the file.
using Json = nlohmann::ordered_json;

[[noreturn]] void fail(const std::filesystem::path& file, std::string message) {
    throw TableError(file.string(), {{.line = 0, .column = {}, .message = std::move(message)}});
}

/// A member that may be missing; null then.
const Json& member(const Json& object, const char* name) {
    static const Json null;
    const auto found = object.is_object() ? object.find(name) : object.end();
    return object.is_object() && found != object.end() ? *found : null;
}

std::string text_of(const Json& value) {
    return value.is_string() ? value.get<std::string>() : std::string();
}

/// "BobDiameter" as the spreadsheets have it: "Bob diameter".
std::string words_of(std::string_view name) {
    std::string words;
    for (const char character : name) {
        const auto letter = static_cast<unsigned char>(character);
        if (std::isupper(letter) != 0 && !words.empty()) {
            words += ' ';
            words += static_cast<char>(std::tolower(letter));
        } else {
            words += character;
        }
    }
    return words;
}

void add_row(Sheet& sheet, std::vector<SheetCell> cells) {
    cells.resize(sheet.columns);
    std::move(cells.begin(), cells.end(), std::back_inserter(sheet.cells));
    ++sheet.rows;
}

/// The geometry's values as texts with units; those without a unit as numbers.
Sheet details_of(const Json& document) {
    Sheet details{.name = "Details", .rows = 0, .columns = 2, .cells = {}};
    const Json& instruments =
        member(member(member(document, "Procedure"), "Configuration"), "InstrumentConfigurations");
    if (!instruments.is_array() || instruments.empty())
        return details;
    const Json& geometry = member(instruments.front(), "Geometry");
    for (const auto& [key, value] : geometry.items()) {
        const std::string name = key == "Name" ? "Geometry name" : words_of(key);
        const Json& number = member(value, "Value");
        const std::string unit = text_of(member(member(value, "Unit"), "Name"));
        if (value.is_string())
            add_row(details, {name, value.get<std::string>()});
        else if (number.is_number() && unit.empty())
            add_row(details, {name, number.get<double>()});
        else if (number.is_number())
            add_row(details, {name, fmt::format("{} {}", number_text(number.get<double>()), unit)});
    }
    return details;
}

struct Column {
    std::string key;
    std::string heading;
    std::string unit;
};

/// Columns of numbers, each heading once.
std::vector<Column> columns_of(const Json& headers) {
    std::vector<Column> columns;
    for (const auto& [key, header] : headers.items()) {
        const std::string kind = text_of(member(header, "ValueType"));
        if (kind != "Number" && kind != "Integer")
            continue;
        const std::string heading = text_of(member(header, "DisplayName"));
        const bool known = std::ranges::any_of(
            columns, [&](const Column& column) { return column.heading == heading; });
        if (!known)
            columns.push_back({key, heading, text_of(member(member(header, "Unit"), "Name"))});
    }
    return columns;
}

bool is_oscillation(std::string_view name) {
    std::string words(name);
    std::ranges::transform(words, words.begin(), [](unsigned char letter) {
        return static_cast<char>(std::tolower(letter));
    });
    return words.find("oscillation") != std::string::npos ||
           words.find("amplitude") != std::string::npos ||
           words.find("frequency") != std::string::npos;
}

/// Of steps in oscillation these are amplitudes or leftovers.
bool belongs_to_flow(const Column& column) {
    return column.heading == "Torque" || column.heading == "Velocity" ||
           column.heading == "Shear rate" || column.heading == "Stress" ||
           column.heading == "Displacement";
}

/// @param count  of the file's sheets so far; this one's are added
Sheet step_sheet(const std::string& name, const std::vector<Column>& all,
                 const std::vector<const Json*>& rows, CellCount& count) {
    std::vector<const Column*> columns;
    for (const Column& column : all) {
        if (is_oscillation(name) && belongs_to_flow(column))
            continue;
        const bool any = std::ranges::any_of(
            rows, [&](const Json* row) { return member(*row, column.key.c_str()).is_number(); });
        if (any)
            columns.push_back(&column);
    }
    Sheet sheet{.name = name, .rows = 0, .columns = columns.size(), .cells = {}};
    if (columns.empty())
        return sheet;
    add_row(sheet, {name});
    std::vector<SheetCell> headings;
    std::vector<SheetCell> units;
    for (const Column* column : columns) {
        headings.emplace_back(column->heading);
        units.emplace_back();
        if (!column->unit.empty())
            units.back() = column->unit;
    }
    add_row(sheet, std::move(headings));
    add_row(sheet, std::move(units));
    for (const Json* row : rows) {
        std::vector<SheetCell> cells;
        count.all += columns.size();
        for (const Column* column : columns) {
            const Json& value = member(*row, column->key.c_str());
            cells.emplace_back();
            if (value.is_number()) {
                cells.back() = value.get<double>();
                ++count.filled;
            }
        }
        if (is_too_sparse(count))
            break; // the caller says so
        add_row(sheet, std::move(cells));
    }
    return sheet;
}

/// Refuses objects of so many members that looking each up among the others takes for ever.
class MemberLimit {
public:
    explicit MemberLimit(const std::filesystem::path& file) : file_(file) {}
    bool operator()(Json::parse_event_t event) {
        constexpr std::size_t most_members = 2000;
        if (event == Json::parse_event_t::object_start)
            members_.push_back(0);
        else if (event == Json::parse_event_t::object_end)
            members_.pop_back();
        else if (event == Json::parse_event_t::key && ++members_.back() > most_members)
            fail(file_,
                 fmt::format("this JSON is no export of TRIOS: it has an object of more than "
                             "{} members",
                             most_members));
        return true;
    }

private:
    const std::filesystem::path& file_;
    std::vector<std::size_t> members_; ///< so far, of each object that is open
};

Json parsed(const std::filesystem::path& file) {
    MemberLimit limit(file);
    try {
        return Json::parse(bytes_of(file), [&limit](int, Json::parse_event_t event, const Json&) {
            return limit(event);
        });
    } catch (const nlohmann::json::exception& error) {
        fail(file, fmt::format("this begins like JSON, but is none: {}", error.what()));
    }
}

} // namespace

std::vector<Sheet> read_trios_json(const std::filesystem::path& file) {
    const Json document = parsed(file);
    const Json& results = member(document, "Results");
    const Json& processed = member(results, "Processed");
    const Json& set = processed.is_object() ? processed : member(results, "Original");
    const Json& headers = member(set, "ColumnHeaders");
    const Json& rows = member(set, "Rows");
    if (!headers.is_object() || !rows.is_array())
        fail(file,
             "this JSON is no export of TRIOS: it has no Results with ColumnHeaders and Rows");

    std::string step_key = "Results Step Id";
    for (const auto& [key, header] : headers.items())
        if (text_of(member(header, "DisplayName")) == "Results Step Id")
            step_key = key;
    std::map<std::string, std::vector<const Json*>> rows_of;
    for (const Json& row : rows)
        rows_of[text_of(member(row, step_key.c_str()))].push_back(&row);

    const std::vector<Column> columns = columns_of(headers);
    std::vector<Sheet> sheets{details_of(document)};
    CellCount count;
    const Json& steps = member(set, "ResultsSteps");
    if (steps.is_array() && !steps.empty()) {
        for (const Json& step : steps) {
            // Taken out: a second step of the same id has no rows of its own.
            const auto own = rows_of.extract(text_of(member(step, "Id")));
            if (!own.empty())
                sheets.push_back(
                    step_sheet(text_of(member(step, "Name")), columns, own.mapped(), count));
        }
    }
    // A file without a list of steps is one step.
    if (sheets.size() == 1 && !rows.empty()) {
        std::vector<const Json*> all;
        for (const Json& row : rows)
            all.push_back(&row);
        sheets.push_back(step_sheet(file.stem().string(), columns, all, count));
    }
    if (is_too_sparse(count))
        fail(file, "this export of TRIOS is damaged: nearly all of its cells are empty");
    if (sheets.size() == 1)
        fail(file, "this export of TRIOS holds no rows");
    return sheets;
}

} // namespace searle::rheometry
