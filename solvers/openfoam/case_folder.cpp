#include "solvers/openfoam/case_folder.hpp"

#include "geometry/mesh_format/write_mesh.hpp"
#include "solvers/openfoam/file_text.hpp"
#include "solvers/openfoam/run_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <system_error>
#include <unistd.h>

namespace searle::solvers::openfoam {
namespace {

namespace fs = std::filesystem;

void write_text(const fs::path& file, const std::string& text) {
    errno = 0;
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream)
        throw fs::filesystem_error(
            "cannot be written", file,
            std::error_code(errno == 0 ? EIO : errno, std::generic_category()));
}

/// OpenFOAM ends each file that it writes with a line of stars.
bool is_whole(const fs::path& file) {
    constexpr std::streamoff tail = 200;
    std::ifstream stream(file, std::ios::binary);
    stream.seekg(0, std::ios::end);
    const std::streamoff length = stream.tellg();
    if (length <= 0)
        return false;
    stream.seekg(std::max<std::streamoff>(0, length - tail));
    const std::string end{std::istreambuf_iterator<char>(stream), {}};
    return end.find("// ****") != std::string::npos;
}

bool is_whole_time(const fs::path& folder) {
    for (const char* needed : {"U", "p", "phi"})
        if (!fs::exists(folder / needed))
            return false;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file() && !is_whole(entry.path()))
            return false;
    return true;
}

/// Name and value of each folder whose name is a number, in order.
std::vector<std::pair<double, std::string>> time_folders(const fs::path& folder) {
    std::vector<std::pair<double, std::string>> times;
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing)) {
        const std::string name = entry.path().filename().string();
        double value{};
        const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), value);
        // "nan" has no place in an order.
        if (error == std::errc{} && end == name.data() + name.size() && std::isfinite(value) &&
            entry.is_directory())
            times.emplace_back(value, name);
    }
    std::ranges::sort(times);
    return times;
}

} // namespace

void write_case(const fs::path& folder, const CaseFacts& facts) {
    const fs::path part = folder.string() + fmt::format(".part-{}", getpid());
    std::error_code ignored;
    fs::remove_all(part, ignored);
    try {
        fs::create_directories(part / "0");
        fs::create_directories(part / "constant");
        fs::create_directories(part / "system");
        geometry::write_openfoam(facts.mesh, part);
        write_text(part / "0/U", velocity_text(facts));
        write_text(part / "0/p", pressure_text(facts));
        write_text(part / "constant/transportProperties", transport_properties(facts));
        write_text(part / "constant/turbulenceProperties", turbulence_properties());
        write_text(part / "system/controlDict", control_text(facts));
        write_text(part / "system/fvSchemes", schemes_text(facts));
        write_text(part / "system/fvSolution", solution_text(facts));
        if (facts.scene.solver.processors > 1)
            write_text(part / "system/decomposeParDict", decomposition_text(facts));
        write_text(part / "Allrun", run_script(facts));
        fs::permissions(part / "Allrun", fs::perms::owner_exec | fs::perms::group_exec,
                        fs::perm_options::add);
        fs::remove_all(folder);
        fs::rename(part, folder);
    } catch (...) {
        fs::remove_all(part, ignored);
        throw;
    }
}

void set_control(const fs::path& folder, const std::string& key, const std::string& value) {
    const fs::path file = folder / "system/controlDict";
    std::string text = text_of(file);
    const std::size_t line = text.find("\n" + key + " ");
    if (line == std::string::npos)
        throw fs::filesystem_error("has no entry " + key, file,
                                   std::make_error_code(std::errc::invalid_argument));
    const std::size_t end = text.find('\n', line + 1);
    text.replace(line + 1, end - line - 1, fmt::format("{:<15} {};", key, value));
    // As a whole, for OpenFOAM reads it again whenever it changes.
    const fs::path part = file.string() + ".part";
    write_text(part, text);
    fs::rename(part, file);
}

std::string control_entry(const fs::path& folder, const std::string& key) {
    std::ifstream stream(folder / "system/controlDict");
    for (std::string line; std::getline(stream, line);) {
        if (!line.starts_with(key + ' '))
            continue;
        const std::size_t start = line.find_first_not_of(' ', key.size());
        return line.substr(start, line.find(';') - start);
    }
    return "";
}

std::string name_of_iteration(double iteration) { return fmt::format("{:.0f}", iteration); }

std::vector<std::string> times_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& [value, name] : time_folders(folder))
        if (fs::exists(folder / name / "U"))
            names.push_back(name);
    return names;
}

void remove_half_written_times(const std::vector<fs::path>& places) {
    std::set<std::string> broken;
    for (const fs::path& place : places)
        for (const auto& [value, name] : time_folders(place))
            if (value > 0.0 && !is_whole_time(place / name))
                broken.insert(name);
    // What only some processes have written is broken as well.
    for (const fs::path& place : places)
        for (const auto& [value, name] : time_folders(place))
            if (std::ranges::any_of(places, [&time = name](const fs::path& other) {
                    return !fs::exists(other / time);
                }))
                broken.insert(name);
    for (const fs::path& place : places)
        for (const std::string& name : broken)
            fs::remove_all(place / name);
}

} // namespace searle::solvers::openfoam
