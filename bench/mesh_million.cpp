// A million structured hexahedra of a DIN bob's wedge and of a slice, from parameters to file:
// wall time a stage, and the most memory used. Target: 10 s and 1.5 GB.

#include "geometry/mesh_build.hpp"
#include "geometry/mesh_format/write_mesh.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <sys/resource.h>

namespace {

using namespace searle::geometry;

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

void measure(const char* name, const MeshSubject& subject, const MeshSettings& settings) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / "searle-bench-mesh";
    std::filesystem::create_directories(folder);
    const double start = seconds();
    const BuiltMesh built = build_mesh(subject, settings);
    const double made = seconds();
    std::printf("%s: %zu cells made in %.2f s\n", name, built.mesh.cells.size(), made - start);
    for (const char* file : {"mesh.msh", "mesh.vtu", "foam/"}) {
        const double before = seconds();
        write_mesh(built.mesh, folder / file, *format_of(folder / file));
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        std::printf("  %-9s %.2f s; in all %.2f s, %.0f MB\n", file, seconds() - before,
                    made - start + seconds() - before,
                    static_cast<double>(usage.ru_maxrss) / 1024.0);
    }
    std::filesystem::remove_all(folder);
}

} // namespace

int main() {
    const DinBob bob{.bob_radius = 14e-3, .cup_radius = 1.0847 * 14e-3};
    MeshSettings wedge;
    wedge.cells_across_gap = 340;
    measure("DIN bob, wedge", bob, wedge);
    MeshSettings slice;
    slice.cells_across_gap = 100;
    slice.slice_height = 1e-3;
    slice.axial_cells = 10;
    slice.extent = MeshExtent::full;
    slice.angular_cells = 1000;
    measure("DIN bob, slice", bob, slice);
}
