#include "app/bench/peers.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

namespace searle::app::bench {
namespace {

namespace fs = std::filesystem;

// The paper's case: 3310 spheres of 1.5 um in a cube of 50 um, 180 1/s, steps of 1e-9 s.
constexpr int spheres = 3310;
constexpr double side = 50e-6;
constexpr double diameter = 1.5e-6;
constexpr double paper_step = 1e-9;
constexpr double shear_rate = 180.0;
constexpr int steps = 20000;

/// The same places for every peer: at random, apart by a tenth of a radius.
std::string places() {
    std::mt19937_64 generator(1);
    std::uniform_real_distribution<double> chance(diameter, side - diameter);
    std::vector<std::array<double, 3>> placed;
    std::string text;
    while (placed.size() < spheres) {
        const std::array<double, 3> place{chance(generator), chance(generator), chance(generator)};
        bool free = true;
        for (const auto& other : placed)
            free = free && std::hypot(place[0] - other[0], place[1] - other[1],
                                      place[2] - other[2]) > 1.05 * diameter;
        if (!free)
            continue;
        placed.push_back(place);
        text += fmt::format("create_atoms 1 single {:.9e} {:.9e} {:.9e} units box\n", place[0],
                            place[1], place[2]);
    }
    return text;
}

std::string script(const char* style, const char* velocities, const std::string& forces) {
    return fmt::format("units si\natom_style {}\nboundary p p p\nnewton off\n{}\n"
                       "region box block 0 {side} 0 {side} 0 {side} units box\ncreate_box 1 box\n"
                       "neighbor 0.225e-6 bin\nneigh_modify delay 0\n{}"
                       "set group all density 5700 diameter {diameter}\n{}timestep {step}\n"
                       "variable vx atom 0.005*sin(1e6*y)+0.002*sin(7e6*z)\n"
                       "velocity all set v_vx NULL NULL\nfix integrate all nve/sphere\n"
                       "thermo 1000000\nrun {steps}\n",
                       style, velocities, places(), forces, fmt::arg("side", side),
                       fmt::arg("diameter", diameter), fmt::arg("step", paper_step),
                       fmt::arg("steps", steps));
}

constexpr const char* liggghts_forces =
    "fix m1 all property/global youngsModulus peratomtype 5e6\n"
    "fix m2 all property/global poissonsRatio peratomtype 0.3\n"
    "fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9\n"
    "fix m4 all property/global coefficientFriction peratomtypepair 1 0.3\n"
    "fix m5 all property/global characteristicVelocity scalar 1e-2\n"
    "pair_style gran model hooke tangential history\npair_coeff * *\n";

constexpr const char* lammps_hooke = "pair_style gran/hooke/history 1e-2 NULL 0.0 NULL 0.3 1\n"
                                     "pair_coeff * *\n";

/// Hamaker 6e-20 J and weak overlap at 32 mV and 10 nm: kappa 2 pi eps eps0 a psi^2 = 3.42e-10 N.
constexpr const char* lammps_dlvo =
    "pair_style hybrid/overlay gran/hooke/history 1e-2 NULL 0.0 NULL 0.3 1 colloid 1.6e-6 "
    "yukawa/colloid 1e8 1.6e-6\npair_coeff 1 1 gran/hooke/history\n"
    "pair_coeff 1 1 colloid 6e-20 1e-12 1.5e-6 1.5e-6 1.6e-6\n"
    "pair_coeff 1 1 yukawa/colloid 3.42e-10 1.6e-6\n";

Peer granular(const char* code, const char* program, const std::string& text,
              const std::string& setting) {
    return {code, setting, 1.5,
            [=](const fs::path& folder, double limit, const StopQuestion& stop) {
                fs::create_directories(folder);
                std::ofstream(folder / "in") << text;
                const Ended ended =
                    run_program({program, "-in", "in"}, folder, {"OMP_NUM_THREADS=1"}, limit, stop);
                PeerRun run;
                run.fault = ended.fault;
                run.peak_MiB = ended.peak_MiB;
                run.unknowns = 6.0 * spheres;
                // The strain that so many steps of the paper's make, and what a strain of 1 takes.
                run.cpu = ended.cpu / (steps * paper_step * shear_rate);
                run.remark = fmt::format("particles alone, no fluid; {} steps measured ({:.0f} M "
                                         "particle-steps per CPU s)",
                                         steps, 1e-6 * spheres * steps / ended.cpu);
                return run;
            }};
}

} // namespace

std::vector<Peer> particle_peers(const BenchScene& scene) {
    const bool coupled = scene.name == "suspension-coupled";
    const bool dlvo = scene.name == "suspension-dlvo";
    std::vector<Peer> peers;
    if (coupled && is_installed("liggghts"))
        peers.push_back(granular("LIGGGHTS", "liggghts",
                                 script("granular", "communicate single vel yes", liggghts_forces),
                                 "Hooke, step 1e-9 s as the paper's"));
    if ((coupled || dlvo) && is_installed("lmp"))
        peers.push_back(
            granular("LAMMPS", "lmp",
                     script("sphere", "comm_modify vel yes", coupled ? lammps_hooke : lammps_dlvo),
                     coupled ? "Hooke, step 1e-9 s as the paper's"
                             : "Hooke and DLVO, step 1e-9 s as the paper's"));
    return peers;
}

} // namespace searle::app::bench
