// Format: OpenFOAM user guide, "Mesh description": points, faces, owner, neighbour, boundary.

#include "geometry/mesh_error.hpp"
#include "geometry/mesh_faces.hpp"
#include "geometry/mesh_format/text_stream.hpp"
#include "geometry/mesh_format/write_mesh.hpp"

#include <fmt/format.h>

#include <unistd.h>

namespace searle::geometry {
namespace {

std::string header(const char* kind, const char* object, const std::string& note = "") {
    return fmt::format("FoamFile\n{{\n    version     2.0;\n    format      ascii;\n"
                       "    class       {};\n{}    location    \"constant/polyMesh\";\n"
                       "    object      {};\n}}\n\n",
                       kind, note, object);
}

const char* type_of(PatchKind kind) {
    switch (kind) {
    case PatchKind::wall:
        return "wall";
    case PatchKind::wedge:
        return "wedge";
    case PatchKind::periodic:
        return "cyclic";
    case PatchKind::flat:
        return "empty";
    case PatchKind::free_surface:
    case PatchKind::end_face:
    case PatchKind::axis:
        break;
    }
    return "patch";
}

std::string transform_of(const Mesh& mesh, const Patch& patch) {
    const PeriodicMap& map = mesh.periodic_map;
    const double sign = patch.name.ends_with("front") ? 1.0 : -1.0;
    if (map.angle != 0.0)
        return "        transform       rotational;\n        rotationAxis    (0 0 1);\n"
               "        rotationCentre  (0 0 0);\n";
    return fmt::format("        transform       translational;\n"
                       "        separationVector ({} {} {});\n",
                       sign * map.shift.x, sign * map.shift.y, sign * map.shift.z);
}

void write_boundary(const Mesh& mesh, std::size_t inner_faces, const std::filesystem::path& file) {
    TextStream out{file};
    out << header("polyBoundaryMesh", "boundary") << mesh.patches.size() << "\n(\n";
    for (const Patch& patch : mesh.patches) {
        out << "    " << patch.name << "\n    {\n        type            " << type_of(patch.kind)
            << ";\n";
        const bool is_one_of_two = patch.name == "bob_inner" || patch.name == "bob_outer";
        if (is_one_of_two) // a condition for bob is then one for both walls
            out << "        inGroups        2(wall bob);\n";
        else if (patch.kind == PatchKind::wall)
            out << "        inGroups        1(wall);\n";
        if (patch.kind == PatchKind::periodic)
            out << "        neighbourPatch  " << patch.partner << ";\n"
                << "        matchTolerance  0.0001;\n"
                << transform_of(mesh, patch);
        out << "        nFaces          " << patch.count << ";\n        startFace       "
            << inner_faces + patch.first << ";\n    }\n";
    }
    out << ")\n";
    out.close();
}

void write_points(const Mesh& mesh, const std::filesystem::path& file) {
    TextStream out{file};
    out << header("vectorField", "points") << mesh.points.size() << "\n(\n";
    for (const Point& point : mesh.points)
        out << '(' << point.x << ' ' << point.y << ' ' << point.z << ")\n";
    out << ")\n";
    out.close();
}

template <class Use>
void for_each_face(const MeshFaces& faces, Use use) {
    for (const auto* list : {&faces.inside, &faces.boundary})
        for (const MeshFace& face : *list)
            use(face);
}

/// The five files of a mesh, in a folder that is there.
void write_files(const Mesh& mesh, const std::filesystem::path& target) {
    const MeshFaces faces = faces_of_cells(mesh);
    write_points(mesh, target / "points");
    const std::size_t count = faces.inside.size() + faces.boundary.size();
    {
        TextStream out{target / "faces"};
        out << header("faceList", "faces") << count << "\n(\n";
        for_each_face(faces, [&out](const MeshFace& face) {
            const std::size_t corners = face.corner_count();
            out << corners << '(';
            for (std::size_t at = 0; at < corners; ++at)
                out << face.corners[at] << (at + 1 < corners ? ' ' : ')');
            out << '\n';
        });
        out << ")\n";
        out.close();
    }
    const std::string note =
        fmt::format("    note        \"nPoints:{}  nCells:{}  nFaces:{}  nInternalFaces:{}\";\n",
                    mesh.points.size(), mesh.cells.size(), count, faces.inside.size());
    {
        TextStream out{target / "owner"};
        out << header("labelList", "owner", note) << count << "\n(\n";
        for_each_face(faces, [&out](const MeshFace& face) { out << face.owner << '\n'; });
        out << ")\n";
        out.close();
    }
    {
        TextStream out{target / "neighbour"};
        out << header("labelList", "neighbour", note) << faces.inside.size() << "\n(\n";
        for (const MeshFace& face : faces.inside)
            out << face.neighbour << '\n';
        out << ")\n";
        out.close();
    }
    write_boundary(mesh, faces.inside.size(), target / "boundary");
}

/// Makes the folders that are missing; gives the first of them, empty where none was.
std::filesystem::path make_folders(const std::filesystem::path& folder) {
    std::filesystem::path first;
    for (std::filesystem::path at = folder; !at.empty() && !std::filesystem::exists(at);
         at = at.parent_path())
        first = at;
    std::filesystem::create_directories(folder);
    return first;
}

} // namespace

void write_openfoam(const Mesh& mesh, const std::filesystem::path& folder) {
    if (mesh.dimension != 3)
        throw MeshError("OpenFOAM has no plane meshes; mesh.extent = \"wedge\" is the section with "
                        "one cell in angle");
    if (mesh.is_second_order())
        throw MeshError("OpenFOAM's cells have straight edges; mesh.order = 1 is needed");
    namespace fs = std::filesystem;
    const fs::path constant = folder / "constant";
    const fs::path target = constant / "polyMesh";
    const fs::path made = make_folders(constant);
    // Beside the target, so that no reader ever meets half a mesh.
    const fs::path part = constant / fmt::format("polyMesh.part-{}", getpid());
    std::error_code ignored;
    try {
        fs::create_directory(part);
        write_files(mesh, part);
        fs::remove_all(target);
        fs::rename(part, target);
    } catch (const fs::filesystem_error& error) {
        fs::remove_all(made.empty() ? part : made, ignored);
        throw fs::filesystem_error("the mesh cannot be written", target, error.code());
    } catch (...) {
        fs::remove_all(made.empty() ? part : made, ignored);
        throw;
    }
}

} // namespace searle::geometry
