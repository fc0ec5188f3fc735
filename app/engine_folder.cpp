#include "app/engine_folder.hpp"

#include "app/result_folder.hpp"
#include "app/run_files.hpp"

#include <fmt/format.h>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view suffix = ".openfoam";

/// Whether all that the folder holds is an engine's: case.toml and levels.
bool holds_engine_files(const fs::path& folder) {
    bool has_case = false;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        has_case |= name == "case.toml";
        if (name != "case.toml" && !name.starts_with("level-"))
            return false;
    }
    return has_case;
}

} // namespace

fs::path engine_folder_for(const Case& source, const fs::path& result_folder, bool sweeps) {
    fs::path folder = result_folder;
    if (!folder.has_filename())
        folder = folder.parent_path(); // "results/water/"
    // A run that is named after the engine, as `compare` names it, says so once.
    const bool is_named = sweeps && "." + source.name != suffix;
    return settled_path(folder).string() + (is_named ? "." + source.name : "") +
           std::string(suffix);
}

void check_engine_can_run_in(const fs::path& folder) {
    if (folder.string().find_first_of(" \t\n\"'") != std::string::npos)
        throw OutputPlaceError(fmt::format("{}: OpenFOAM cannot run in a folder whose path has a "
                                           "blank or a quote in it; -o takes another",
                                           folder.string()));
}

bool open_engine_folder(const fs::path& folder, const Case& source, bool anew) {
    const fs::path case_file = folder / "case.toml";
    if (fs::exists(folder) && !fs::is_directory(folder))
        throw OutputPlaceError(folder.string() + " is a file; OpenFOAM's cases go to a folder");
    if (fs::exists(folder) && !fs::is_empty(folder)) {
        if (!holds_engine_files(folder))
            throw OutputPlaceError(
                fmt::format("{}: holds other things than the cases of an earlier run; move it away",
                            folder.string()));
        const bool is_same = text_of_file(case_file) == source.resolved_toml;
        if (is_same && !anew)
            return true;
        if (!anew)
            throw OutputPlaceError(fmt::format("{}: holds the run of another case, or of other "
                                               "settings; --force replaces it",
                                               folder.string()));
        fs::remove_all(folder);
    }
    fs::create_directories(folder);
    replace_file(case_file, source.resolved_toml);
    return false;
}

void remove_unused_engine_folder(const fs::path& folder) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().filename() != "case.toml")
            return;
    fs::remove_all(folder, ignored);
}

} // namespace searle::app
