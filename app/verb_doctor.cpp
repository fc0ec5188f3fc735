#include "app/verb_doctor.hpp"

#include "app/exit_code.hpp"
#include "app/versions.hpp"
#include "casefile/unit.hpp"
#include "geometry/unstructured/triangulation.hpp"
#include "solvers/openfoam/installation.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <unistd.h>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

/// Something outside the program that a case may ask for.
struct OptionalTool {
    std::string_view name;
    std::string_view program; ///< found in PATH when the tool is there
    std::string_view package; ///< Debian's
    std::string_view use;
};

constexpr std::array optional_tools{
    OptionalTool{"OpenFOAM", "pimpleFoam", solvers::openfoam::package,
                 "solver.engine = \"openfoam\", searle compare"},
    OptionalTool{"mpirun", "mpirun", solvers::openfoam::mpi_package, "solver.processors above 1"},
    OptionalTool{"rsvg-convert", "rsvg-convert", "librsvg2-bin", "pictures of meshes as .png"}};

/// Version of an installed Debian package; empty where it is not known.
std::string package_version(std::string_view package) {
    const std::string command =
        fmt::format("dpkg-query --show --showformat='${{Version}}' {} 2>/dev/null", package);
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::string version;
    std::array<char, 128> part{};
    while (pipe && std::fgets(part.data(), part.size(), pipe.get()) != nullptr)
        version += part.data();
    return version;
}

std::string line_for(const OptionalTool& tool) {
    if (const auto program = solvers::openfoam::program_in_path(tool.program)) {
        const std::string version = package_version(tool.package);
        return fmt::format("  {:<14} {} at {} ({})\n", tool.name,
                           version.empty() ? "unknown version" : version, program->string(),
                           tool.use);
    }
    return fmt::format("  {:<14} missing; to get it: apt-get install {} ({})\n", tool.name,
                       tool.package, tool.use);
}

/// What a shell command prints in its first line; empty when it fails.
std::string first_line_of(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::array<char, 256> part{};
    if (!pipe || std::fgets(part.data(), part.size(), pipe.get()) == nullptr)
        return "";
    std::string line = part.data();
    while (!line.empty() && line.back() == '\n')
        line.pop_back();
    return line;
}

/// meshio is a module of Python, with modules of its own for some formats.
std::string line_for_meshio() {
    constexpr std::string_view use = "meshes as .xdmf .inp .su2 .med and others";
    for (const char* python : {"/usr/bin/python3", "python3"}) {
        const std::string version = first_line_of(
            fmt::format("{} -c 'import meshio; print(meshio.__version__)' 2>/dev/null", python));
        if (version.empty())
            continue;
        std::string text = fmt::format("  {:<14} {} of {} ({})\n", "meshio", version, python, use);
        for (const auto& [module, package, format] :
             {std::array<const char*, 3>{"h5py", "python3-h5py", ".med, and .xdmf without text"},
              std::array<const char*, 3>{"netCDF4", "python3-netcdf4", ".e .exo .ex2"}})
            if (first_line_of(
                    fmt::format("{} -c 'import {}; print(1)' 2>/dev/null", python, module))
                    .empty())
                text += fmt::format("  {:<14} missing; to get it: apt-get install {} ({})\n",
                                    module, package, format);
        return text;
    }
    return fmt::format("  {:<14} missing; to get it: apt-get install python3-meshio python3-h5py "
                       "({})\n",
                       "meshio", use);
}

std::string line_for_gmsh() {
    constexpr std::string_view use = "triangles and tetrahedra";
    if (!geometry::can_triangulate())
        return fmt::format("  {:<14} missing; to get it: apt-get install libgmsh-dev, and build "
                           "Searle again ({})\n",
                           "gmsh", use);
    const std::string version = package_version("libgmsh-dev");
    return fmt::format("  {:<14} {} ({})\n", "gmsh", version.empty() ? "is there" : version, use);
}

/// The file of units is read when the program runs, so it can be missing although all was built.
bool units_can_be_read() {
    try {
        (void)casefile::unit_of_database("mm");
        return true;
    } catch (const std::runtime_error&) {
        return false;
    }
}

} // namespace

int doctor() {
    std::string text =
        fmt::format("searle {} ({})\n\nEngines and tools\n", program_version(), compiler());
    text += fmt::format(
        "  {:<14} {}: single gap, double gap, box, DIN bob with its ends; {} processors\n",
        "native", program_version(), std::thread::hardware_concurrency());
    for (const OptionalTool& tool : optional_tools)
        text += line_for(tool);
    text += line_for_gmsh() + line_for_meshio();
    text += "\nLibraries (built in)\n";
    for (const auto& [name, version] : library_versions())
        text += fmt::format("  {:<14} {}\n", name, version);
    const bool has_units = units_can_be_read();
    text += fmt::format("\nData\n  {:<14} {}\n", "units",
                        has_units ? "the database of UDUNITS-2 is there"
                                  : "missing; to get it: apt-get install libudunits2-data");
    std::fputs(text.c_str(), stdout);
    return has_units ? ExitCode::done : ExitCode::engine_missing;
}

} // namespace searle::app
