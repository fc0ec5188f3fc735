#include "solvers/openfoam/row_start.hpp"

#include "solvers/openfoam/case_folder.hpp"

#include <algorithm>
#include <system_error>

namespace searle::solvers::openfoam {

namespace fs = std::filesystem;

std::string RowStart::before() const { return name_of_iteration(start_of_row(plan, row)); }

std::string RowStart::mapped() const { return name_of_iteration(start_of_row(plan, row) + 1.0); }

std::string RowStart::end() const { return name_of_iteration(end_of_row(plan, row)); }

bool RowStart::can_be_mapped() const {
    std::error_code missing;
    return !coarser.empty() && std::ranges::all_of(places, [&](const fs::path& place) {
        const fs::path source = coarser / place.lexically_relative(folder) / end() / "U";
        const std::vector<std::string> times = times_in(place);
        return fs::exists(source, missing) && !times.empty() && times.back() == before();
    });
}

void RowStart::prepare() const {
    for (const fs::path& place : places) {
        fs::create_directories(place / mapped());
        for (const char* field : {"U", "p"})
            fs::copy_file(place / before() / field, place / mapped() / field,
                          fs::copy_options::overwrite_existing);
    }
}

std::vector<std::string> RowStart::command() const {
    std::vector<std::string> words = {"mapFields", coarser.string(), "-consistent", "-sourceTime",
                                      end()};
    if (places.size() > 1 || places.front() != folder)
        words.insert(words.end(), {"-parallelSource", "-parallelTarget"});
    return words;
}

void RowStart::clear() const {
    std::error_code ignored;
    for (const fs::path& place : places)
        fs::remove_all(place / mapped(), ignored);
}

} // namespace searle::solvers::openfoam
