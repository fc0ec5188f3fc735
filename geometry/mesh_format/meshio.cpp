#include "geometry/mesh_error.hpp"
#include "geometry/mesh_format/meshio_script.hpp"
#include "geometry/mesh_format/text_stream.hpp"
#include "geometry/mesh_format/vtk_numbers.hpp"
#include "geometry/mesh_format/write_mesh.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace searle::geometry {
namespace {

namespace fs = std::filesystem;

struct TemporaryFolder {
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "searle-mesh-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw fs::filesystem_error("no temporary folder", name,
                                       std::error_code(errno, std::generic_category()));
        path = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    fs::path path;
};

/// Runs a program; its stdout and stderr go to `log` and `errors`. 127: it is not there.
int run(const std::vector<std::string>& words, const fs::path& log, const fs::path& errors) {
    std::vector<char*> pointers;
    for (const std::string& word : words)
        pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        dup2(open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 1);
        dup2(open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 2);
        execvp(pointers[0], pointers.data());
        _exit(127);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child)
        throw std::system_error(errno, std::generic_category(), words.front());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::vector<std::string> lines_of(const fs::path& file) {
    std::ifstream stream(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        if (line.find_first_not_of(" \t\r") != std::string::npos)
            lines.push_back(line);
    return lines;
}

/// meshio's name of a shape.
constexpr const char* meshio_type(CellShape shape) {
    switch (shape) {
    case CellShape::line2:
        return "line";
    case CellShape::triangle3:
        return "triangle";
    case CellShape::quadrangle4:
        return "quad";
    case CellShape::tetrahedron4:
        return "tetra";
    case CellShape::pyramid5:
        return "pyramid";
    case CellShape::prism6:
        return "wedge";
    case CellShape::hexahedron8:
        return "hexahedron";
    case CellShape::line3:
        return "line3";
    case CellShape::triangle6:
        return "triangle6";
    case CellShape::quadrangle8:
        return "quad8";
    case CellShape::tetrahedron10:
        return "tetra10";
    case CellShape::pyramid13:
        return "pyramid13";
    case CellShape::prism15:
        return "wedge15";
    case CellShape::hexahedron20:
        return "hexahedron20";
    }
    return "";
}

/// Writes what the script reads: one block a shape, since some formats allow no more.
void write_exchange(const Mesh& mesh, const fs::path& folder) {
    struct Block {
        std::size_t nodes{};
        std::vector<std::uint32_t> connectivity{};
        std::vector<std::int32_t> numbers{};
    };
    std::map<CellShape, Block> blocks;
    const auto fluid = static_cast<std::int32_t>(mesh.patches.size() + 1);
    for_each_vtk_cell(mesh, [&](CellShape shape, std::span<const std::uint32_t> nodes, int patch) {
        Block& block = blocks[shape];
        block.nodes = nodes.size();
        // meshio has VTK's order but for the straight prism, which it turns itself.
        const std::vector<std::uint32_t> ordered =
            shape == CellShape::prism6 ? std::vector<std::uint32_t>{nodes.begin(), nodes.end()}
                                       : vtk_nodes(shape, nodes);
        block.connectivity.insert(block.connectivity.end(), ordered.begin(), ordered.end());
        block.numbers.push_back(patch == 0 ? fluid : patch);
    });
    TextStream text{folder / "mesh.txt"};
    TextStream cells{folder / "cells.bin"};
    TextStream numbers{folder / "numbers.bin"};
    text << "points " << mesh.points.size() << '\n';
    for (const auto& [shape, block] : blocks) {
        text << "block " << meshio_type(shape) << ' ' << block.nodes << ' ' << block.numbers.size()
             << '\n';
        cells.raw(std::span<const std::uint32_t>{block.connectivity});
        numbers.raw(std::span<const std::int32_t>{block.numbers});
    }
    for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch)
        text << "name " << patch + 1 << ' ' << mesh.dimension - 1 << ' ' << mesh.patches[patch].name
             << '\n';
    text << "name " << fluid << ' ' << mesh.dimension << " fluid\n";
    TextStream points{folder / "points.bin"};
    points.raw(std::span<const Point>{mesh.points});
    for (TextStream* const stream : {&text, &cells, &numbers, &points})
        stream->close();
}

/// Moves the files that were made (an .xdmf has its data beside it) to the target's folder, each as
/// a whole.
void move_all(const fs::path& from, const fs::path& to) {
    for (const fs::directory_entry& made : fs::directory_iterator(from)) {
        const fs::path target = to / made.path().filename();
        fs::path part = target;
        part += fmt::format(".part-{}", getpid());
        try {
            fs::copy_file(made.path(), part, fs::copy_options::overwrite_existing);
            fs::rename(part, target);
        } catch (const fs::filesystem_error& error) {
            std::error_code ignored;
            fs::remove(part, ignored);
            throw fs::filesystem_error("the mesh cannot be written", target, error.code());
        }
    }
}

} // namespace

std::vector<std::string> write_by_meshio(const Mesh& mesh, const fs::path& file) {
    const TemporaryFolder folder;
    write_exchange(mesh, folder.path);
    const fs::path made = folder.path / "made";
    fs::create_directory(made);
    const fs::path target = made / file.filename();
    const fs::path log = folder.path / "log";
    const fs::path errors = folder.path / "errors";
    // Debian's meshio belongs to Debian's Python; another one may stand before it in PATH.
    constexpr int not_there = 127;
    constexpr int no_meshio = 7;
    constexpr int no_module = 8;
    for (const char* python : {"/usr/bin/python3", "python3"}) {
        const int code = run({python, "-c", meshio_script, folder.path.string(), target.string(),
                              std::to_string(mesh.dimension)},
                             log, errors);
        std::vector<std::string> said = lines_of(log);
        if (said.empty() && code != 0)
            said = lines_of(errors);
        const std::string last = said.empty() ? "" : said.back();
        if (code == 0) {
            move_all(made, fs::absolute(file).parent_path());
            return said;
        }
        if (code == no_module)
            throw MeshToolMissing(
                fmt::format("meshio could not write {}: {}", file.string(), last));
        if (code != not_there && code != no_meshio)
            throw MeshError(fmt::format("{}: {}", file.string(), last));
    }
    throw MeshToolMissing(
        fmt::format("{} files are written by meshio, which is not here; to get it: "
                    "apt-get install python3-meshio",
                    file.extension().string()));
}

} // namespace searle::geometry
