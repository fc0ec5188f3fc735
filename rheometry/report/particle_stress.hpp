#pragma once

#include "rheometry/report/report_input.hpp"

#include <string>
#include <vector>

namespace searle::rheometry::report {

/// What the stress of a suspension is made of at one point, each over the stress of the fluid alone
/// at that rate. The parts are those of the bulk; what the wall shows beyond the bulk's mean is
/// momentum on its way into or out of the fluid.
struct ParticleShares {
    double whole{};       ///< stress over that of the fluid alone
    double whole_error{}; ///< numerical and statistical, >= 0
    double hydrodynamic{};
    double contact{};
    double dlvo{};
    double brownian{};
    double inertia{};
};

/// Of a point with or without particles; all NaN where the fluid alone has no stress.
[[nodiscard]] ParticleShares particle_shares(const RheogramPoint& point, const StressOfRate& law);

/// Sentences on the point of the highest rate: what the stress is made of, and what drag alone
/// misses. Empty for a fluid without particles.
[[nodiscard]] std::vector<std::string>
particle_remarks(const ParticlesNote& particles, const Rheogram& rheogram, const StressOfRate& law);

/// Sentences on where the runs differ at the highest rate that they share, by how much, and whether
/// their errors can tell; how far each curve steepens; what drag alone misses. Empty when no run
/// has particles.
[[nodiscard]] std::vector<std::string> particle_remarks(const OverlayInput& input);

/// The parts at every point of a run, as a table.
[[nodiscard]] std::string particle_table(const ReportInput& input, int number);

/// The parts of every run at its highest rate, as a table.
[[nodiscard]] std::string particle_table(const OverlayInput& input, int number);

} // namespace searle::rheometry::report
