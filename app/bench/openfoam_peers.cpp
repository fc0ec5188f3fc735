#include "app/bench/native_run.hpp"
#include "app/bench/openfoam_case.hpp"
#include "app/bench/peers.hpp"

#include "solvers/plan.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <variant>

namespace searle::app::bench {
namespace {

namespace fs = std::filesystem;

constexpr double slice = 1e-3;

FoamCase start_of(const std::string& solver, const solvers::Scene& scene, int cells) {
    FoamCase foam;
    foam.solver = solver;
    foam.instrument = scene.instrument;
    foam.law = scene.fluid.law;
    foam.density = scene.fluid.density;
    foam.mesh.cells_across_gap = cells;
    return foam;
}

/// One run of OpenFOAM; the torques as it wrote them.
PeerRun run_foam(const FoamCase& foam, const fs::path& folder, double limit,
                 const StopQuestion& stop, std::vector<FoamTorque>& torques) {
    fs::create_directories(folder);
    PeerRun run;
    run.unknowns = 4.0 * static_cast<double>(write_foam_case(foam, folder));
    const Ended ended = run_program({foam.solver}, folder, foam_environment(), limit, stop);
    run.cpu = ended.cpu;
    run.peak_MiB = ended.peak_MiB;
    run.fault = ended.fault;
    torques = foam_torques(folder);
    if (run.fault.empty() && torques.empty())
        run.fault = foam.solver + " wrote no torque";
    return run;
}

void slice_of(FoamCase& foam) {
    foam.mesh.slice_height = slice;
    foam.mesh.axial_cells = 1;
    foam.mesh.growth = 1.0;
}

/// A ramp from rest in an endless gap, a row a second.
/// @param corrections  of pimpleFoam on the swirl alone, in each step; 0: pisoFoam
Peer ramp_peer(const BenchScene& scene, int cells, double step, int corrections, double cost) {
    const std::string solver = corrections > 0 ? "pimpleFoam" : "pisoFoam";
    return {"OpenFOAM " + solver,
            fmt::format("1 deg, {} cells across, step {} s{}", cells, step,
                        corrections > 0 ? ", swirl alone" : ""),
            cost, [=](const fs::path& folder, double limit, const StopQuestion& stop) {
                const Case source = case_of(scene, 1e-3);
                const auto rows = solvers::make_plan(source.scene).rows;
                FoamCase foam = start_of(solver, source.scene, cells);
                foam.swirl_corrections = corrections;
                slice_of(foam);
                foam.step = step;
                foam.end_time = rows.back().time;
                foam.torque_interval = rows.front().time;
                // A speed of 0 stops the program's balance of fluxes.
                foam.speeds = {{0.0, 1e-9}, {rows.back().time, rows.back().speed}};
                std::vector<FoamTorque> torques;
                PeerRun run = run_foam(foam, folder, limit, stop, torques);
                const double height = std::visit(
                    [](const auto& shape) {
                        if constexpr (requires { shape.height; })
                            return shape.height;
                        else
                            return slice;
                    },
                    source.scene.instrument);
                for (const FoamTorque& each : torques)
                    run.torques.push_back(each.torque * height / slice);
                return run;
            }};
}

/// Steady flow of the slurry at each rate, from rest in so many steps over twenty diffusion times.
/// @param corrections  of pimpleFoam on the swirl alone, in each step; 0: with the pressure
Peer steady_gap_peer(const BenchScene& scene, const std::string& solver, int cells, int steps,
                     int corrections, double cost) {
    return {fmt::format("OpenFOAM {}", solver),
            fmt::format("1 deg, {} cells across, {} steps a rate{}", cells, steps,
                        corrections > 0 ? ", swirl alone" : ""),
            cost, [=](const fs::path& folder, double limit, const StopQuestion& stop) {
                const Case source = case_of(scene, 1e-3);
                const auto& gap = std::get<geometry::ConcentricCylinders>(source.scene.instrument);
                const double width = gap.cup_radius - gap.bob_radius;
                PeerRun all;
                for (const auto& row : solvers::make_plan(source.scene).rows) {
                    FoamCase foam = start_of(solver, source.scene, cells);
                    foam.swirl_corrections = corrections;
                    slice_of(foam);
                    const double viscosity =
                        std::abs(row.steady_stress / row.shear_rate) / source.scene.fluid.density;
                    foam.end_time = 20.0 * width * width / viscosity;
                    foam.step = foam.end_time / steps;
                    foam.torque_interval = foam.end_time;
                    foam.speeds = {{0.0, row.speed}, {foam.end_time, row.speed}};
                    std::vector<FoamTorque> torques;
                    const PeerRun run =
                        run_foam(foam, folder / fmt::format("rate-{}", all.torques.size()), limit,
                                 stop, torques);
                    all.cpu += run.cpu;
                    all.unknowns = run.unknowns;
                    all.peak_MiB = std::max(all.peak_MiB, run.peak_MiB);
                    if (!run.fault.empty()) {
                        all.fault = run.fault;
                        return all;
                    }
                    all.torques.push_back(torques.back().torque * gap.height / slice);
                }
                return all;
            }};
}

/// How a steady flow around a bob is found.
struct BobSettings {
    const char* solver;
    const char* words;
    double most_iterations;
    bool cautious{};     ///< FoamCase's
    bool steady_swirl{}; ///< FoamCase's
};
constexpr BobSettings simplec{
    .solver = "simpleFoam", .words = "SIMPLEC", .most_iterations = 10'000};
constexpr BobSettings relaxed_simplec{.solver = "simpleFoam",
                                      .words = "SIMPLEC, pressure relaxed",
                                      .most_iterations = 10'000,
                                      .cautious = true};
/// Of creeping flow: as many iterations as bring the cells that are not orthogonal to 1e-6.
constexpr BobSettings swirl_alone{
    .solver = "pimpleFoam", .words = "swirl alone", .most_iterations = 8, .steady_swirl = true};

/// Steady flow around a bob.
Peer bob_peer(const BenchScene& scene, int cells, const BobSettings& settings, double cost) {
    return {fmt::format("OpenFOAM {}", settings.solver),
            fmt::format("1 deg, {} cells across the gap, {}", cells, settings.words), cost,
            [=](const fs::path& folder, double limit, const StopQuestion& stop) {
                const Case source = case_of(scene, 1e-3);
                FoamCase foam = start_of(settings.solver, source.scene, cells);
                const double speed = solvers::make_plan(source.scene).rows.front().speed;
                foam.step = 1.0;
                foam.cautious = settings.cautious;
                foam.steady_swirl = settings.steady_swirl;
                foam.swirl_corrections = settings.steady_swirl ? 1 : 0;
                foam.end_time = settings.most_iterations;
                foam.speeds = {{0.0, speed}, {1e9, speed}};
                std::vector<FoamTorque> torques;
                PeerRun run = run_foam(foam, folder, limit, stop, torques);
                if (!torques.empty())
                    run.torques = {torques.back().torque};
                if (!settings.steady_swirl) // as many as it needs
                    run.remark = fmt::format("{} iterations", torques.size());
                return run;
            }};
}

/// Vortices that grow from a small disturbance at a steady speed, for 20 s.
Peer vortex_peer(const BenchScene& scene, int cells, double step, double cost) {
    return {"OpenFOAM pisoFoam",
            fmt::format("1 deg, {0} x {0} cells, step {1} s, 20 s", cells, step), cost,
            [=](const fs::path& folder, double limit, const StopQuestion& stop) {
                const Case source = case_of(scene, 1e-3);
                const solvers::Plan plan = solvers::make_plan(source.scene);
                const auto& gap = std::get<geometry::ConcentricCylinders>(source.scene.instrument);
                FoamCase foam = start_of("pisoFoam", source.scene, cells);
                // Half an axial period of the most unstable vortices, between planes of symmetry.
                const double half =
                    std::numbers::pi * (gap.cup_radius - gap.bob_radius) / plan.taylor->wave_number;
                foam.mesh.slice_height = half;
                foam.mesh.axial_cells = cells;
                foam.mesh.growth = 1.0;
                foam.step = step;
                foam.end_time = 20.0;
                foam.torque_interval = 20.0;
                const double speed = plan.rows.front().speed;
                foam.speeds = {{0.0, speed}, {1e9, speed}};
                foam.disturbance = 1e-3 * speed * gap.bob_radius;
                std::vector<FoamTorque> torques;
                PeerRun run = run_foam(foam, folder, limit, stop, torques);
                for (const FoamTorque& each : torques)
                    run.torques = {each.torque * gap.height / half};
                return run;
            }};
}

} // namespace

std::vector<Peer> openfoam_peers(const BenchScene& scene) {
    if (foam_environment().empty() || !is_installed("pisoFoam") || !is_installed("simpleFoam"))
        return {};
    if (scene.name == "single-gap-ramp")
        return {ramp_peer(scene, 20, 0.05, 0, 0.4), ramp_peer(scene, 40, 0.02, 0, 0.8),
                ramp_peer(scene, 20, 0.1, 2, 0.2), ramp_peer(scene, 40, 0.05, 2, 0.4)};
    if (scene.name == "double-gap-ramp")
        return {ramp_peer(scene, 20, 0.05, 0, 0.5), ramp_peer(scene, 40, 0.05, 2, 0.5)};
    if (scene.name == "slurry-ramp")
        return {ramp_peer(scene, 40, 0.01, 0, 3.0), ramp_peer(scene, 20, 0.1, 6, 0.4),
                ramp_peer(scene, 40, 0.05, 6, 0.8)};
    if (scene.name == "slurry-steady")
        return {steady_gap_peer(scene, "pimpleFoam", 40, 800, 0, 4.0),
                steady_gap_peer(scene, "pimpleFoam", 40, 800, 1, 2.0)};
    if (scene.name == "din-creeping")
        return {bob_peer(scene, 5, simplec, 0.3),      bob_peer(scene, 10, simplec, 0.8),
                bob_peer(scene, 20, simplec, 6.0),     bob_peer(scene, 5, swirl_alone, 0.2),
                bob_peer(scene, 10, swirl_alone, 0.3), bob_peer(scene, 20, swirl_alone, 0.6),
                bob_peer(scene, 40, swirl_alone, 2.0)};
    if (scene.name == "din-secondary-10")
        return {bob_peer(scene, 5, relaxed_simplec, 1.5), bob_peer(scene, 10, relaxed_simplec, 4.0),
                bob_peer(scene, 20, relaxed_simplec, 40.0)};
    if (scene.name == "din-secondary-100")
        return {bob_peer(scene, 5, relaxed_simplec, 4.0),
                bob_peer(scene, 10, relaxed_simplec, 20.0),
                bob_peer(scene, 20, relaxed_simplec, 100.0)};
    if (scene.name == "taylor-vortices")
        return {vortex_peer(scene, 16, 0.02, 5.0), vortex_peer(scene, 32, 0.01, 40.0)};
    return {};
}

} // namespace searle::app::bench
