// Every kind of mesh, extent and three resolutions: what OpenFOAM's checkMesh says of it, and its
// volume against the closed forms; then random requests, valid and not. Prints docs/mesh.md's
// table. Without OpenFOAM the column says so. `--quick`: the coarsest resolution, fewer requests.

#include "geometry/mesh_error.hpp"
#include "geometry/mesh_format/write_mesh.hpp"
#include "geometry/mesh_quality.hpp"
#include "tests/geometry/mesh_readers.hpp"
#include "tests/geometry/mesh_subjects.hpp"
#include "tests/geometry/random_meshes.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>

namespace {

using namespace searle::geometry;
using namespace searle::geometry::testing;

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// The number that stands after a phrase of checkMesh's.
std::string number_after(const std::string& text, const std::string& phrase) {
    const std::size_t at = text.find(phrase);
    if (at == std::string::npos)
        return "-";
    const std::size_t start = at + phrase.size();
    return text.substr(start, text.find_first_of(" \n,", start) - start);
}

struct Count {
    int meshes{};
    int good{};
    int checked{};
    int accepted{};
};

void print_row(const std::string& name, const char* extent, const MeshSubject& subject,
               const MeshSettings& settings, const Folder& folder, bool has_foam, Count& count) {
    const double start = seconds();
    const BuiltMesh built = build_mesh(subject, settings);
    const MeshQuality quality = quality_of(built);
    const double took = seconds() - start;
    std::string verdict = "no OpenFOAM here";
    std::string skewness = "-";
    if (has_foam) {
        write_mesh(built.mesh, folder.path / "", MeshFormat::openfoam);
        const std::string said = check_mesh(folder.path);
        const bool is_fine = said.find("Mesh OK.") != std::string::npos;
        verdict = is_fine ? "Mesh OK" : "FAILED";
        skewness = number_after(said, "Max skewness = ");
        ++count.checked;
        count.accepted += is_fine;
    }
    ++count.meshes;
    count.good += quality.faults.empty();
    std::printf("| %s | %s | %d | %zu | %s | %.1f | %s | %.1e | %.1e | %.2f |\n", name.c_str(),
                extent, settings.cells_across_gap.value_or(0), quality.cells, verdict.c_str(),
                quality.largest_non_orthogonality, skewness.c_str(), quality.volume.error(),
                quality.volume.value / quality.volume.exact - 1.0, took);
    std::fflush(stdout);
}

void print_table(bool quick) {
    const bool has_foam = is_there("checkMesh");
    const Folder folder;
    prepare_check_mesh(folder.path);
    std::puts(
        "| mesh | extent | cells across | cells | checkMesh | non-orthogonality, deg | skewness "
        "| volume, error | volume, to arcs | s |\n|---|---|---|---|---|---|---|---|---|---|");
    Count count;
    auto subjects = laboratory_subjects();
    const std::vector<std::pair<const char*, MeshExtent>> extents{
        {"wedge", MeshExtent::wedge}, {"sector", MeshExtent::sector}, {"full", MeshExtent::full}};
    const std::vector<int> resolutions = quick ? std::vector{5} : std::vector{5, 10, 20};
    for (const auto& [name, subject] : subjects)
        for (const auto& [extent_name, extent] : extents)
            for (const int across : resolutions)
                print_row(name, extent_name, subject,
                          {.cells_across_gap = across, .extent = extent}, folder, has_foam, count);
    for (const auto& [extent_name, extent] : extents)
        for (const int across : resolutions)
            print_row("double-gap, joined", extent_name, subjects[1].second,
                      {.cells_across_gap = across, .extent = extent, .floor_clearance = 3e-3},
                      folder, has_foam, count);
    for (const auto& [name, subject] : subjects)
        for (const auto& [extent_name, extent] : extents) {
            // Isotropic cells in the double gap's thin gaps go into the millions.
            if (std::holds_alternative<DoubleGap>(subject) && extent != MeshExtent::wedge)
                continue;
            print_row(name + ", tetrahedra", extent_name, subject,
                      {.cells_across_gap = 2, .extent = extent, .cells = CellStyle::tetrahedra},
                      folder, has_foam, count);
        }
    std::printf("\n%d of %d meshes pass Searle's checks, %d of %d checkMesh.\n", count.good,
                count.meshes, count.accepted, count.checked);
}

void print_random(int valid, int invalid) {
    Dice dice{20260101};
    int good = 0;
    double largest = 0.0;
    const double start = seconds();
    for (int draw = 0; draw < valid; ++draw) {
        const MeshSubject subject = dice.subject();
        const MeshQuality quality = quality_of(build_mesh(subject, dice.settings()));
        good += quality.faults.empty();
        largest = std::max(largest, std::abs(quality.volume.error()));
    }
    std::printf("%d of %d random requests mesh and pass (%.1f s); largest volume error %.1e.\n",
                good, valid, seconds() - start, largest);
    const std::vector<Spoiled> ways = ways_to_spoil();
    Dice other{7};
    int refused = 0;
    for (int draw = 0; draw < invalid; ++draw) {
        const Spoiled& spoiled = ways[static_cast<std::size_t>(draw) % ways.size()];
        MeshSubject subject = other.subject();
        MeshSettings settings = other.settings();
        settings.slice_height.reset();
        spoiled.how(subject, settings, other);
        try {
            (void)build_mesh(subject, settings);
        } catch (const MeshError& error) {
            refused += std::string_view{error.what()}.find(spoiled.word) != std::string_view::npos;
        }
    }
    std::printf("%d of %d invalid requests are refused with their cause.\n", refused, invalid);
}

} // namespace

int main(int count, char** arguments) {
    const bool quick = count > 1 && std::string_view{arguments[1]} == "--quick";
    print_random(quick ? 100 : 1000, quick ? 40 : 200);
    print_table(quick);
}
