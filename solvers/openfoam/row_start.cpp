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
    return !coarser.empty() && fs::exists(coarser / end() / "U", missing) &&
           std::ranges::all_of(places, [&](const fs::path& place) {
               const std::vector<std::string> times = times_in(place);
               return !times.empty() && times.back() == before();
           });
}

void RowStart::prepare() const {
    // mapFields writes to the latest time of the whole case, of which parts may have lost theirs.
    for (const std::string& time : times_in(folder))
        if (std::stod(time) > start_of_row(plan, row))
            fs::remove_all(folder / time);
    fs::create_directories(folder / mapped());
    for (const char* field : {"U", "p"})
        fs::copy_file(folder / "0" / field, folder / mapped() / field,
                      fs::copy_options::overwrite_existing);
}

std::vector<std::string> RowStart::command() const {
    return {"mapFields", coarser.string(), "-consistent", "-sourceTime", end()};
}

std::vector<std::string> RowStart::distribution() const {
    return {"decomposePar", "-fields", "-time", mapped()};
}

void RowStart::clear() const {
    std::error_code ignored;
    fs::remove_all(folder / mapped(), ignored);
    for (const fs::path& place : places)
        fs::remove_all(place / mapped(), ignored);
}

} // namespace searle::solvers::openfoam
