#include "rheometry/tables/open_workbook.hpp"

#include "rheometry/tables/number_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <pugixml.hpp>
#include <zip.h>

namespace searle::rheometry {
namespace {

constexpr zip_uint64_t largest_part = zip_uint64_t{512} << 20U;
constexpr std::size_t most_cells = 20'000'000;
// Sheets of numbers are packed to a tenth or so; what unpacks to far more is made to fill the
// memory.
constexpr zip_uint64_t most_unpacked = 200;
constexpr zip_uint64_t always_unpacked = zip_uint64_t{4} << 20U;
// Limits of the format itself.
constexpr std::size_t most_rows = 1'048'576;
constexpr std::size_t most_columns = 16'384;
constexpr std::size_t longest_text = 4 * std::size_t{32'767}; // in bytes of UTF-8

[[noreturn]] void fail(const std::filesystem::path& file, std::string message) {
    throw TableError(file.string(), {{.line = 0, .column = {}, .message = std::move(message)}});
}

/// The parts of the archive, by name.
class Archive {
public:
    explicit Archive(const std::filesystem::path& file) : file_(file) {
        int error = 0;
        archive_.reset(zip_open(file.c_str(), ZIP_RDONLY, &error));
        if (!archive_)
            fail(file, fmt::format("the workbook cannot be opened: it is missing or a damaged zip "
                                   "archive (libzip's code {})",
                                   error));
    }

    [[nodiscard]] bool holds(const std::string& name) const {
        return zip_name_locate(archive_.get(), name.c_str(), ZIP_FL_NOCASE) >= 0;
    }

    /// A part as a tree; an empty one where there is no such part and it may be missing.
    [[nodiscard]] pugi::xml_document part(const std::string& name, bool may_be_missing) const {
        pugi::xml_document document;
        zip_stat_t facts{};
        const zip_int64_t place = zip_name_locate(archive_.get(), name.c_str(), ZIP_FL_NOCASE);
        if (place < 0 && may_be_missing)
            return document;
        const auto index = static_cast<zip_uint64_t>(place);
        if (place < 0 || zip_stat_index(archive_.get(), index, 0, &facts) != 0)
            fail(file_, fmt::format("this is no .xlsx workbook: the archive holds no {}", name));
        if (facts.size > largest_part)
            fail(file_, fmt::format("{} is larger than 512 MiB; export the data in parts", name));
        if (facts.size > always_unpacked + most_unpacked * facts.comp_size)
            fail(file_, fmt::format("{} is packed beyond belief: the workbook is damaged; save it "
                                    "anew",
                                    name));
        const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> stream(
            zip_fopen_index(archive_.get(), index, 0), zip_fclose);
        std::string text(facts.size, '\0');
        if (!stream || zip_fread(stream.get(), text.data(), facts.size) !=
                           static_cast<zip_int64_t>(facts.size))
            fail(file_, fmt::format("{} cannot be read: the workbook is damaged or protected by a "
                                    "password",
                                    name));
        const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
        if (!parsed)
            fail(file_, fmt::format("{} is damaged at byte {}: {}", name, parsed.offset,
                                    parsed.description()));
        return document;
    }

private:
    std::filesystem::path file_;
    struct Discard {
        void operator()(zip_t* archive) const { zip_discard(archive); }
    };
    std::unique_ptr<zip_t, Discard> archive_;
};

/// A name without its namespace's prefix.
std::string_view local_name(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

pugi::xml_node child_named(const pugi::xml_node& parent, std::string_view name) {
    return parent.find_child(
        [name](const pugi::xml_node& node) { return local_name(node) == name; });
}

/// The text of a string item: its own, or that of its runs in different fonts.
std::string text_of(const pugi::xml_node& item) {
    std::string text = child_named(item, "t").text().get();
    for (const pugi::xml_node& run : item.children())
        if (local_name(run) == "r")
            text += child_named(run, "t").text().get();
    return text;
}

/// Texts that cells share; a cell that says a long one is short.
std::vector<std::string> shared_texts(const Archive& archive, const std::filesystem::path& file) {
    std::vector<std::string> texts;
    const pugi::xml_document document = archive.part("xl/sharedStrings.xml", true);
    for (const pugi::xml_node& item : document.document_element().children())
        if (local_name(item) == "si")
            texts.push_back(text_of(item));
    if (std::ranges::any_of(texts, [](const auto& text) { return text.size() > longest_text; }))
        fail(file, "a text is longer than a cell can hold; the workbook is damaged");
    return texts;
}

/// "BC12": column 54, row 11 (from 0).
struct Place {
    std::size_t row{};
    std::size_t column{};
};

bool read_place(std::string_view reference, Place& place) {
    std::size_t column = 0;
    std::size_t k = 0;
    for (; k < reference.size() && reference[k] >= 'A' && reference[k] <= 'Z'; ++k)
        column = std::min(26 * column + static_cast<std::size_t>(reference[k] - 'A' + 1),
                          most_columns + 1);
    std::size_t row = 0;
    const std::size_t letters = k;
    for (; k < reference.size() && reference[k] >= '0' && reference[k] <= '9'; ++k)
        row = std::min(10 * row + static_cast<std::size_t>(reference[k] - '0'), most_rows + 1);
    if (letters == 0 || k == letters || k != reference.size() || row == 0 || row > most_rows ||
        column > most_columns)
        return false;
    place = {row - 1, column - 1};
    return true;
}

class SheetReader {
public:
    /// @param count  of the workbook's sheets so far; this one's are added
    SheetReader(const std::filesystem::path& file, const std::vector<std::string>& texts,
                std::string name, CellCount& count)
        : file_(file), texts_(texts), count_(count) {
        sheet_.name = std::move(name);
    }

    Sheet read(const pugi::xml_document& document) {
        std::vector<std::pair<Place, SheetCell>> found;
        Place next;
        for (const pugi::xml_node& row : child_named(document.document_element(), "sheetData")) {
            // Rows and cells say where they are, or else follow the one before.
            next.column = 0;
            if (const auto number = row.attribute("r").as_ullong(); number > 0)
                next.row = std::min<std::size_t>(number, most_rows) - 1;
            for (const pugi::xml_node& cell : row.children()) {
                if (local_name(cell) != "c")
                    continue;
                if (const pugi::xml_attribute reference = cell.attribute("r");
                    reference && !read_place(reference.value(), next))
                    fail(file_, fmt::format("sheet \"{}\": \"{}\" is no cell; the workbook is "
                                            "damaged",
                                            sheet_.name, reference.value()));
                SheetCell content = content_of(cell);
                if (!std::holds_alternative<std::monostate>(content))
                    found.emplace_back(next, std::move(content));
                ++next.column;
            }
            ++next.row;
        }
        for (const auto& [place, content] : found) {
            sheet_.rows = std::max(sheet_.rows, place.row + 1);
            sheet_.columns = std::max(sheet_.columns, place.column + 1);
        }
        if (sheet_.rows > 0 && sheet_.columns > most_cells / sheet_.rows)
            fail(file_,
                 fmt::format("sheet \"{}\" has more than {} cells", sheet_.name, most_cells));
        count_.all += sheet_.rows * sheet_.columns;
        count_.filled += found.size();
        if (is_too_sparse(count_))
            fail(file_,
                 fmt::format("sheet \"{}\" has {} rows and {} columns, but {} cells that hold "
                             "anything; the workbook is damaged",
                             sheet_.name, sheet_.rows, sheet_.columns, found.size()));
        sheet_.cells.resize(sheet_.rows * sheet_.columns);
        for (auto& [place, content] : found)
            sheet_.cells[place.row * sheet_.columns + place.column] = std::move(content);
        return std::move(sheet_);
    }

private:
    [[nodiscard]] SheetCell content_of(const pugi::xml_node& cell) const {
        const std::string_view kind = cell.attribute("t").value();
        const std::string value = child_named(cell, "v").text().get();
        if (kind == "inlineStr")
            return text_cell(text_of(child_named(cell, "is")));
        if (kind == "str" || kind == "e" || kind == "d")
            return text_cell(value);
        if (value.empty())
            return {};
        const NumberText number = read_number(value);
        if (number.outcome != NumberText::Outcome::number || number.mark == DecimalMark::comma)
            fail(file_, fmt::format("sheet \"{}\", cell {}: \"{}\" is stored as a number, but is "
                                    "none; the workbook is damaged",
                                    sheet_.name, cell.attribute("r").value(), value));
        if (kind != "s")
            return number.value;
        if (!(number.value >= 0.0 && number.value < static_cast<double>(texts_.size())))
            fail(file_, fmt::format("sheet \"{}\", cell {}: its text is missing; the workbook is "
                                    "damaged",
                                    sheet_.name, cell.attribute("r").value()));
        return text_cell(texts_[static_cast<std::size_t>(number.value)]);
    }
    static SheetCell text_cell(std::string text) {
        return text.empty() ? SheetCell{} : SheetCell{std::move(text)};
    }

    const std::filesystem::path& file_;
    const std::vector<std::string>& texts_;
    CellCount& count_;
    Sheet sheet_;
};

/// Where the parts of the sheets lie, by the ids that the workbook calls them by.
std::map<std::string, std::string> targets_of(const Archive& archive) {
    std::map<std::string, std::string> targets;
    const pugi::xml_document relations = archive.part("xl/_rels/workbook.xml.rels", false);
    for (const pugi::xml_node& relation : relations.document_element().children()) {
        const std::string target = relation.attribute("Target").value();
        targets[relation.attribute("Id").value()] =
            target.starts_with('/') ? target.substr(1) : "xl/" + target;
    }
    return targets;
}

} // namespace

std::vector<Sheet> read_open_workbook(const std::filesystem::path& file) {
    const Archive archive(file);
    if (!archive.holds("xl/workbook.xml"))
        fail(file, "this is a zip archive, but no .xlsx workbook; unpack it first");
    const std::map<std::string, std::string> targets = targets_of(archive);
    const std::vector<std::string> texts = shared_texts(archive, file);
    const pugi::xml_document workbook = archive.part("xl/workbook.xml", false);
    std::vector<Sheet> sheets;
    CellCount count;
    for (const pugi::xml_node& entry :
         child_named(workbook.document_element(), "sheets").children()) {
        std::string id;
        for (const pugi::xml_attribute& attribute : entry.attributes())
            if (std::string_view(attribute.name()).ends_with(":id"))
                id = attribute.value();
        const auto target = targets.find(id);
        // Sheets that are charts have no cells.
        if (target == targets.end() || target->second.find("worksheets/") == std::string::npos)
            continue;
        SheetReader reader(file, texts, entry.attribute("name").value(), count);
        sheets.push_back(reader.read(archive.part(target->second, false)));
    }
    if (sheets.empty())
        fail(file, "the workbook holds no sheet with cells");
    return sheets;
}

} // namespace searle::rheometry
