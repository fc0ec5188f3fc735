#include "app/verb_mesh.hpp"

#include "app/case_reader.hpp"
#include "app/exit_code.hpp"
#include "app/mesh_table.hpp"
#include "app/no_size_signal.hpp"
#include "app/picture_file.hpp"
#include "casefile/nearest_name.hpp"
#include "geometry/mesh_error.hpp"
#include "geometry/mesh_format/write_mesh.hpp"
#include "geometry/mesh_picture.hpp"
#include "geometry/slice_plan.hpp"
#include "rheometry/report/geometry_drawing.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

geometry::MeshFormat settled_format(const MeshOptions& options) {
    const auto format = geometry::format_of(options.output);
    if (!format) {
        const std::string ending = options.output.extension().string();
        const auto meant = casefile::nearest_name(ending, geometry::known_endings());
        throw geometry::MeshError(fmt::format(
            "{}: the ending '{}' stands for no known format{}; known are {}, and a path that ends "
            "in / for OpenFOAM",
            options.output.string(), ending,
            meant ? fmt::format(" (did you mean {}?)", *meant) : "",
            fmt::join(geometry::known_endings(), " ")));
    }
    if (options.format.empty())
        return *format;
    if (options.format != "msh22" && options.format != "msh41")
        throw geometry::MeshError(
            fmt::format("--format {}: msh22 or msh41 is allowed", options.format));
    if (*format != geometry::MeshFormat::msh41)
        throw geometry::MeshError(
            fmt::format("--format {} is for a path that ends in .msh", options.format));
    return options.format == "msh22" ? geometry::MeshFormat::msh22 : geometry::MeshFormat::msh41;
}

/// Says that a place cannot be written before the mesh is made.
void check_place(const fs::path& file) {
    fs::path folder = fs::absolute(file).parent_path();
    const bool is_folder = !file.has_filename();
    while (is_folder && !fs::exists(folder) && folder.has_relative_path())
        folder = folder.parent_path();
    if (!fs::is_directory(folder))
        throw geometry::MeshError(
            fmt::format("{}: there is no folder {}", file.string(), folder.string()));
    if (!is_folder && fs::is_directory(file))
        return check_place(file / "");
    // The superuser may write everywhere, but not every folder takes files: only trying tells.
    const fs::path probe = folder / fmt::format(".searle-{}", getpid());
    errno = 0;
    const int opened = open(probe.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0600);
    if (opened < 0)
        throw geometry::MeshError(fmt::format("{}: the folder {} cannot be written ({})",
                                              file.string(), folder.string(),
                                              std::generic_category().message(errno)));
    close(opened);
    std::error_code ignored;
    fs::remove(probe, ignored);
    if (!is_folder && fs::exists(file) && access(file.c_str(), W_OK) != 0)
        throw geometry::MeshError(fmt::format("{}: cannot be written ({})", file.string(),
                                              std::generic_category().message(errno)));
}

/// The section by itself, for the picture.
geometry::BuiltMesh section_of(const geometry::MeshSubject& subject,
                               geometry::MeshSettings settings) {
    settings.extent = geometry::MeshExtent::section;
    settings.wedge_angle.reset();
    settings.angular_cells.reset();
    settings.vertices.reset();
    settings.order.reset();
    return geometry::build_mesh(subject, settings);
}

/// The section in r and z; around an eccentric bob, where none stands for the others, the slice as
/// seen along the axis, magnified where the gap is narrowest.
std::string preview_of(const MeshCase& scene, const geometry::MeshSubject& subject,
                       const geometry::BuiltMesh& built) {
    const std::string& title = scene.title.empty() ? scene.name : scene.title;
    if (!geometry::is_eccentric(scene.instrument))
        return geometry::mesh_picture(section_of(subject, scene.mesh).mesh, built.domain.gap,
                                      title);
    const auto& gap = std::get<geometry::ConcentricCylinders>(scene.instrument);
    const double narrowest = gap.gap() - gap.offset;
    return geometry::mesh_picture(geometry::slice_plan(built.mesh), narrowest, title,
                                  geometry::Point{gap.bob_radius + 0.5 * narrowest, 0.0, 0.0});
}

} // namespace

int mesh(const MeshOptions& options) {
    const geometry::MeshFormat format = settled_format(options);
    for (const auto& picture : {options.preview, options.drawing})
        if (picture) {
            check_picture_ending(*picture);
            check_place(*picture);
        }
    check_place(options.output);
    const MeshCase scene = read_mesh_case(options.case_file, options.overrides);
    const geometry::MeshSubject subject =
        scene.profile ? geometry::MeshSubject{*scene.profile} : subject_of(scene.instrument);
    if (options.drawing && scene.profile)
        throw geometry::MeshError("--drawing is for instruments; the --preview of a profile shows "
                                  "its outline");
    const geometry::BuiltMesh built = geometry::build_mesh(subject, scene.mesh);
    const NoSizeSignal no_signal;
    const std::vector<std::string> losses =
        geometry::write_mesh(built.mesh, options.output, format);
    if (!options.quiet)
        for (const std::string& loss : losses)
            std::fputs(fmt::format("searle: {}: note: {}\n", options.output.string(), loss).c_str(),
                       stderr);
    if (options.preview)
        write_picture(preview_of(scene, subject, built), *options.preview);
    if (options.drawing)
        write_picture(rheometry::report::geometry_drawing(scene.instrument), *options.drawing);
    const geometry::MeshQuality quality = geometry::quality_of(built);
    if (options.json)
        std::fputs(mesh_json(built, quality).c_str(), stdout);
    else if (!options.quiet)
        std::fputs(mesh_table(built, quality).c_str(), stdout);
    for (const std::string& fault : quality.faults)
        std::fputs(fmt::format("searle: {}: {}\n", options.output.string(), fault).c_str(), stderr);
    return quality.faults.empty() ? ExitCode::done : ExitCode::not_reached;
}

} // namespace searle::app
