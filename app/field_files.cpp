#include "app/field_files.hpp"

#include "app/run_files.hpp"
#include "rheometry/fields/vtu_text.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace searle::app {
namespace {

namespace fields = rheometry::fields;

constexpr std::string_view subfolder = "fields/";
constexpr std::string_view ending = ".vtu";

std::string file_name(const fields::SectionFields& section) {
    return fmt::format("row-{:04}{}", section.row, ending);
}

} // namespace

std::vector<ResultFile> field_files(const std::vector<fields::SectionFields>& fields) {
    std::vector<ResultFile> files;
    std::vector<fields::TimedFile> list;
    for (const fields::SectionFields& section : fields) {
        files.push_back({std::string{subfolder} + file_name(section), fields::vtu_text(section)});
        list.push_back({section.time, file_name(section)});
    }
    if (!list.empty())
        files.push_back({std::string{subfolder} + "rows.pvd", fields::pvd_text(list)});
    return files;
}

std::vector<std::string> field_file_names(const std::vector<fields::SectionFields>& fields) {
    std::vector<std::string> names;
    for (const fields::SectionFields& section : fields)
        names.push_back(std::string{subfolder} + file_name(section));
    if (!names.empty())
        names.push_back(std::string{subfolder} + "rows.pvd");
    return names;
}

std::vector<fields::SectionFields> read_field_files(const std::filesystem::path& folder,
                                                    const std::vector<std::string>& listed) {
    std::vector<fields::SectionFields> sections;
    for (const std::string& name : listed)
        if (name.starts_with(subfolder) && name.ends_with(ending)) {
            const std::filesystem::path file = folder / name;
            try {
                sections.push_back(fields::read_vtu_text(text_of_file(file)));
            } catch (const std::exception& error) {
                throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
            }
        }
    return sections;
}

} // namespace searle::app
