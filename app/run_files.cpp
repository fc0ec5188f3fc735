#include "app/run_files.hpp"

#include "app/field_files.hpp"
#include "app/run_summary.hpp"
#include "app/structure_files.hpp"
#include "rheometry/rheogram_csv.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

std::string csv_of(const SolvedCase& solved) {
    std::ostringstream stream;
    rheometry::write_rheogram_csv(stream, solved.rheogram,
                                  rheometry::drive_columns(solved.source.scene.instrument));
    return std::move(stream).str();
}

} // namespace

RunRecord record_of(const SolvedCase& solved, const std::string& created) {
    RunRecord record{.summary = run_summary(solved, created),
                     .source = solved.source,
                     .rheogram = solved.rheogram,
                     .csv = csv_of(solved),
                     .ends = solved.ends,
                     .fields = solved.solution.fields,
                     .structure = structure_files(
                         solved.structure, solved.rheogram.points.size(),
                         static_cast<std::size_t>(solved.source.scene.output.field_rows))};
    for (const ResultFile& file : record.structure)
        record.summary.files.push_back(file.name);
    std::ranges::sort(record.summary.files);
    record.summary.remarks = remarks_on(record);
    return record;
}

std::vector<ResultFile> files_of(const RunRecord& record, const std::string& prefix) {
    std::vector<ResultFile> files{{prefix + "case.toml", record.source.resolved_toml},
                                  {prefix + "report.html", report_page(record)},
                                  {prefix + "rheogram.csv", record.csv},
                                  {prefix + "summary.json", summary_json(record.summary)}};
    if (!record.ends.empty())
        files.push_back({prefix + "end_factor.csv", rheometry::end_effect_csv(record.ends)});
    for (ResultFile& file : field_files(record.fields))
        files.push_back({prefix + file.name, std::move(file.content)});
    for (const ResultFile& file : record.structure)
        files.push_back({prefix + file.name, file.content});
    return files;
}

std::string text_of_file(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream.is_open() || stream.bad() || fs::is_directory(file))
        throw std::runtime_error(file.string() + ": cannot be read");
    return text;
}

RunRecord read_record(const fs::path& folder) {
    RunRecord record;
    record.summary = read_run_summary(text_of_file(folder / "summary.json"));
    const fs::path case_file = folder / "case.toml";
    record.source = read_case(case_file);
    const fs::path csv_file = folder / "rheogram.csv";
    record.csv = text_of_file(csv_file);
    record.rheogram = rheometry::read_rheogram_csv(csv_file).rheogram;
    if (std::ranges::count(record.summary.files, "end_factor.csv") > 0)
        record.ends = rheometry::read_end_effect_csv(folder / "end_factor.csv");
    record.fields = read_field_files(folder, record.summary.files);
    return record;
}

} // namespace searle::app
