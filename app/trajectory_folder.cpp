#include "app/trajectory_folder.hpp"

#include "app/result_folder.hpp"
#include "rheometry/fields/vtu_text.hpp"
#include "solvers/particles/local_volumes.hpp"

#include <fmt/format.h>

#include <iterator>
#include <vector>

namespace searle::app {
namespace {

namespace fs = std::filesystem;
using solvers::particles::Column;

constexpr std::string_view list_name = "trajectory.pvd";

std::string frame_name(std::size_t index) { return fmt::format("frame-{:06}.vtp", index); }

bool is_ours(const fs::path& file) {
    const std::string name = file.filename().string();
    return name == list_name || (name.starts_with("frame-") && name.ends_with(".vtp"));
}

} // namespace

TrajectoryFolder::TrajectoryFolder(fs::path folder, bool goes_on, bool replace)
    : folder_(std::move(folder)) {
    if (fs::exists(folder_) && !fs::is_directory(folder_))
        throw OutputPlaceError(folder_.string() + " is a file; the trajectory goes to a folder");
    std::vector<fs::path> earlier;
    if (fs::exists(folder_))
        for (const auto& entry : fs::directory_iterator(folder_)) {
            if (!is_ours(entry.path()))
                throw OutputPlaceError(fmt::format("{}: holds {}, which is no trajectory; it is "
                                                   "left as it is (choose another folder with -o)",
                                                   folder_.string(),
                                                   entry.path().filename().string()));
            earlier.push_back(entry.path());
        }
    if (!goes_on && !replace && !earlier.empty())
        throw OutputPlaceError(fmt::format(
            "{}: holds the trajectory of an earlier run; --force replaces it", folder_.string()));
    if (!goes_on)
        for (const fs::path& file : earlier)
            fs::remove(file);
    fs::create_directories(folder_);
}

void TrajectoryFolder::write(const solvers::suspension::Frame& frame) {
    const std::size_t index = frame.times.size() - 1;
    try {
        replace_file(folder_ / frame_name(index), frame_text(frame.particles, frame.box));
        std::vector<rheometry::fields::TimedFile> list;
        for (std::size_t k = 0; k <= index; ++k)
            if (fs::exists(folder_ / frame_name(k)))
                list.push_back({frame.times[k], frame_name(k)});
        replace_file(folder_ / std::string(list_name), rheometry::fields::pvd_text(list));
    } catch (const OutputWriteError& error) {
        trouble_ = fmt::format("The trajectory lacks frames: {}.", error.what());
    }
}

std::string frame_text(const solvers::particles::ParticleStore& particles,
                       const solvers::particles::ShearBox& box) {
    const std::size_t count = particles.size();
    std::vector<std::size_t> place(count);
    for (std::size_t i = 0; i < count; ++i)
        place[static_cast<std::size_t>(particles.id[i])] = i;
    std::string text = fmt::format("<?xml version=\"1.0\"?>\n"
                                   "<VTKFile type=\"PolyData\" version=\"0.1\" "
                                   "byte_order=\"LittleEndian\">\n<PolyData>\n"
                                   "<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\" "
                                   "NumberOfLines=\"0\" NumberOfStrips=\"0\" "
                                   "NumberOfPolys=\"0\">\n",
                                   count);
    const auto into = std::back_inserter(text);
    const auto open = [&](std::string_view type, std::string_view name, int components) {
        fmt::format_to(into,
                       "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" "
                       "format=\"ascii\">\n",
                       type, name, components);
    };
    const auto close = [&] { text += "</DataArray>\n"; };
    const auto vectors = [&](std::string_view name, const Column& x, const Column& y,
                             const Column& z) {
        open("Float64", name, 3);
        for (const std::size_t i : place)
            fmt::format_to(into, "{:.9g} {:.9g} {:.9g}\n", x[i], y[i], z[i]);
        close();
    };
    const auto counted_from = [&](std::size_t first, std::string_view name) {
        open("Int64", name, 1);
        for (std::size_t k = 0; k < count; ++k)
            fmt::format_to(into, "{}\n", first + k);
        close();
    };
    text += "<PointData>\n";
    counted_from(0, "id");
    const auto scalars = [&](std::string_view name, const auto& values) {
        open("Float64", name, 1);
        for (const std::size_t i : place)
            fmt::format_to(into, "{:.9g}\n", values[i]);
        close();
    };
    scalars("radius", particles.radius);
    scalars("local_volume", solvers::particles::local_volumes(particles, box));
    vectors("v", particles.vx, particles.vy, particles.vz);
    vectors("omega", particles.wx, particles.wy, particles.wz);
    text += "</PointData>\n<Points>\n";
    vectors("points", particles.x, particles.y, particles.z);
    text += "</Points>\n<Verts>\n";
    counted_from(0, "connectivity");
    counted_from(1, "offsets");
    text += "</Verts>\n</Piece>\n</PolyData>\n</VTKFile>\n";
    return text;
}

} // namespace searle::app
