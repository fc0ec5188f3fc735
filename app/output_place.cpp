#include "app/output_place.hpp"

#include "app/summary_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& folder, std::string_view reason) {
    throw OutputPlaceError(fmt::format("{}: {}", folder.string(), reason));
}

/// Files of a folder, relative to it; a link or an empty subfolder counts as a file.
std::vector<std::string> files_below(const fs::path& folder) {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_symlink() || !entry.is_directory() || fs::is_empty(entry.path()))
            files.push_back(entry.path().lexically_relative(folder).string());
    std::sort(files.begin(), files.end());
    return files;
}

/// The first of the folder's files that its summary.json does not list; empty: none.
std::string foreign_file(const fs::path& folder) {
    std::ifstream stream(folder / "summary.json", std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const std::vector<std::string> listed = files_listed(text);
    const std::set<std::string> own(listed.begin(), listed.end());
    const std::vector<std::string> files = files_below(folder);
    const auto foreign = std::find_if(files.begin(), files.end(), [&own](const std::string& file) {
        return !own.contains(file);
    });
    return foreign == files.end() ? "" : *foreign;
}

void check_writable(const fs::path& asked, const fs::path& folder) {
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        refuse(asked, fmt::format("cannot be written, because {} cannot ({})", folder.string(),
                                  std::generic_category().message(errno)));
}

/// The folder that a path's missing part would be made in must be there and take new entries.
void check_parent(const fs::path& asked, const fs::path& folder) {
    fs::path parent = folder.parent_path();
    while (!fs::exists(parent) && parent.has_relative_path())
        parent = parent.parent_path();
    if (!fs::is_directory(parent))
        refuse(asked, fmt::format("cannot be made, because {} is a file", parent.string()));
    check_writable(asked, parent);
}

} // namespace

fs::path settled_path(const fs::path& folder) {
    fs::path settled = fs::weakly_canonical(fs::absolute(folder));
    return settled.has_filename() ? settled : settled.parent_path();
}

Occupant check_output_place(const fs::path& folder, bool replace) try {
    const fs::path settled = settled_path(folder);
    const fs::file_status status = fs::status(settled);
    if (!fs::exists(status)) {
        if (fs::is_symlink(fs::symlink_status(settled)))
            refuse(folder, "is a link to something that does not exist");
        check_parent(folder, settled);
        return Occupant::nothing;
    }
    if (!fs::is_directory(status))
        refuse(folder, "is a file; results need a folder (choose another with -o)");
    if (fs::is_empty(settled)) {
        check_writable(folder, settled);
        return Occupant::empty_folder;
    }
    const std::string foreign = foreign_file(settled);
    if (!foreign.empty())
        refuse(folder,
               fmt::format("holds {}, which is not part of a Searle result; it is left as it "
                           "is (choose another folder with -o)",
                           foreign));
    if (!replace)
        refuse(folder, "holds results already; --force replaces them, -o chooses another folder");
    check_writable(folder, settled);
    return Occupant::results;
} catch (const fs::filesystem_error& error) {
    refuse(folder, error.code().message());
}

} // namespace searle::app
