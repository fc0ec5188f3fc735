#include "geometry/mesh_error.hpp"
#include "geometry/mesh_format/write_mesh.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace searle::geometry {
namespace {

namespace fs = std::filesystem;

/// Reads the .msh and writes the other format. Names go where the format has a place for them:
/// sets of cells (Abaqus), markers (SU2), families (MED), an Information element (XDMF); everywhere
/// else the numbers of the patches go as the cell data "gmsh:physical".
constexpr const char* script = R"(
import sys
try:
    import meshio, numpy
except ImportError:
    sys.exit(7)
# Some writers of meshio 5.0 take a block of cells for a pair.
meshio.CellBlock.__iter__ = lambda block: iter((block.type, block.data))
source, target, dimension = sys.argv[1], sys.argv[2], int(sys.argv[3])
mesh = meshio.read(source, file_format="gmsh")
names = {int(v[0]): k for k, v in mesh.field_data.items()}
physical = mesh.cell_data["gmsh:physical"]
mesh.cell_data = {"gmsh:physical": physical}
mesh.cell_sets = {}
mesh.point_data = {}
if dimension == 2:
    mesh.points = mesh.points[:, :2]
ending = target[target.rfind("."):].lower()
if ending == ".inp":
    mesh.cell_sets = {n: [numpy.where(p == i)[0] for p in physical] for i, n in names.items()}
elif ending == ".med":
    mesh.cell_data = {"cell_tags": [-p for p in physical]}
    mesh.cell_tags = {-i: [n] for i, n in names.items()}
    mesh.field_data = {}
elif ending == ".xml" or ending == ".cgns":
    mesh.field_data = {}
options = {}
if ending in (".xdmf", ".xmf"):
    try:
        import h5py
    except ImportError:
        options["data_format"] = "XML"
try:
    meshio.write(target, mesh, **options)
except ImportError as error:
    print("the Python module %s is missing; to get it: apt-get install python3-%s"
          % (error.name, error.name))
    sys.exit(8)
if ending == ".su2":
    text = open(target).read()
    for i, n in names.items():
        text = text.replace("MARKER_TAG= %d\n" % i, "MARKER_TAG= %s\n" % n)
    open(target, "w").write(text)
if ending in (".xdmf", ".xmf"):
    text = open(target).read()
    keys = "".join('<map key="%s" dim="%d">%d</map>' % (n, mesh.field_data[n][1], i)
                   for i, n in names.items())
    place = text.index("<Grid") + text[text.index("<Grid"):].index(">") + 1
    text = (text[:place] + '<Information Name="patches" Value="%d"><![CDATA[<main>%s</main>]]>'
            '</Information>' % (len(names), keys) + text[place:])
    open(target, "w").write(text)
)";

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

/// Runs a program; its stdout and stderr go to `log`. 127: it is not there.
int run(const std::vector<std::string>& words, const fs::path& log) {
    std::vector<char*> pointers;
    for (const std::string& word : words)
        pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        dup2(file, 1);
        dup2(file, 2);
        execvp(pointers[0], pointers.data());
        _exit(127);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child)
        throw std::system_error(errno, std::generic_category(), words.front());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string last_line(const fs::path& file) {
    std::ifstream stream(file);
    std::string line;
    std::string last;
    while (std::getline(stream, line))
        if (line.find_first_not_of(" \t\r") != std::string::npos)
            last = line;
    return last;
}

} // namespace

void write_by_meshio(const Mesh& mesh, const fs::path& file) {
    {
        // An unwritable place is said before the work, and in the same words as everywhere.
        const bool was_there = fs::exists(file);
        std::ofstream probe(file, std::ios::app);
        if (!probe)
            throw fs::filesystem_error("the mesh cannot be written", file,
                                       std::error_code(errno, std::generic_category()));
        probe.close();
        if (!was_there)
            fs::remove(file);
    }
    const TemporaryFolder folder;
    const fs::path source = folder.path / "mesh.msh";
    const fs::path log = folder.path / "log";
    write_msh22(mesh, source);
    // Debian's meshio belongs to Debian's Python; another one may stand before it in PATH.
    constexpr int not_there = 127;
    constexpr int no_meshio = 7;
    constexpr int no_module = 8;
    for (const char* python : {"/usr/bin/python3", "python3"}) {
        const int code = run({python, "-c", script, source.string(), fs::absolute(file).string(),
                              std::to_string(mesh.dimension)},
                             log);
        if (code == 0)
            return;
        if (code == no_module)
            throw MeshToolMissing(
                fmt::format("meshio could not write {}: {}", file.string(), last_line(log)));
        if (code != not_there && code != no_meshio)
            throw MeshError(
                fmt::format("meshio could not write {}: {}", file.string(), last_line(log)));
    }
    throw MeshToolMissing(
        fmt::format("{} files are written by meshio, which is not here; to get it: "
                    "apt-get install python3-meshio",
                    file.extension().string()));
}

} // namespace searle::geometry
