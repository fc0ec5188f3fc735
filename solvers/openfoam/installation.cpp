#include "solvers/openfoam/installation.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <unistd.h>

namespace searle::solvers::openfoam {
namespace {

namespace fs = std::filesystem;

/// The value of `export WM_PROJECT_VERSION=...` in etc/bashrc.
std::string version_of(const fs::path& project) {
    std::ifstream settings(project / "etc" / "bashrc");
    constexpr std::string_view name = "WM_PROJECT_VERSION=";
    for (std::string line; std::getline(settings, line);) {
        const std::size_t at = line.find(name);
        if (at == std::string::npos || line.find('#') < at)
            continue;
        const std::string value = line.substr(at + name.size());
        return value.substr(0, value.find_first_of(" \t;#"));
    }
    return "";
}

} // namespace

std::optional<fs::path> program_in_path(std::string_view program) {
    const char* variable = std::getenv("PATH");
    std::string_view rest = variable == nullptr ? "" : variable;
    while (!rest.empty()) {
        const std::size_t colon = rest.find(':');
        fs::path candidate = fs::path(rest.substr(0, colon)) / program;
        if (access(candidate.c_str(), X_OK) == 0)
            return candidate;
        rest = colon == std::string_view::npos ? "" : rest.substr(colon + 1);
    }
    return std::nullopt;
}

std::string doubt_about(const Installation& installation) {
    if (installation.version == supported_version)
        return "";
    return fmt::format(
        "OpenFOAM {} is here (WM_PROJECT_DIR {}); the cases are written for {}, and other versions "
        "read some of their entries differently or not at all. Debian's package {} has it.",
        installation.version.empty() ? "of an unknown version" : installation.version,
        installation.project.string(), supported_version, package);
}

std::optional<Installation> find_installation() {
    if (!program_in_path("pimpleFoam"))
        return std::nullopt;
    std::array<fs::path, 2> candidates{"", "/usr/share/openfoam"};
    if (const char* given = std::getenv("WM_PROJECT_DIR"))
        candidates[0] = given;
    for (const fs::path& project : candidates) {
        std::error_code ignored;
        if (!project.empty() && fs::is_regular_file(project / "etc" / "controlDict", ignored))
            return Installation{project, version_of(project)};
    }
    return std::nullopt;
}

} // namespace searle::solvers::openfoam
