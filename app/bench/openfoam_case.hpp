#pragma once

#include "geometry/instrument.hpp"
#include "geometry/mesh_settings.hpp"
#include "laws/flow/flow_law.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace searle::app::bench {

/// A case for OpenFOAM, on a wedge of one cell in angle around the instrument: pisoFoam, pimpleFoam
/// or simpleFoam, laminar.
struct FoamCase {
    std::string solver;
    geometry::Instrument instrument;
    geometry::MeshSettings mesh; ///< extent and wedge angle are set here
    laws::flow::AnyFlowLaw law;  ///< Newtonian or Herschel-Bulkley
    double density{};
    /// Speed of the rotor: (s, rad/s), joined by lines.
    std::vector<std::pair<double, double>> speeds;
    double end_time{}; ///< s; of simpleFoam the most iterations
    double step{};     ///< s; of simpleFoam 1
    /// The torque is taken every so many s; of simpleFoam each iteration.
    double torque_interval{};
    /// Horizontal cuts are planes of symmetry, and the flow is disturbed at the start by so many
    /// m/s along the axis: for vortices. 0: the cuts are "empty".
    double disturbance{};
    /// Of pimpleFoam: so many corrections a step of the swirl alone, on which no pressure acts;
    /// none of the pressure. 0: two, with the pressure.
    int swirl_corrections{};
    /// Of pimpleFoam on the swirl alone: steps are iterations of a steady flow.
    bool steady_swirl{};
    /// Of simpleFoam: SIMPLEC with the pressure relaxed by a half, where it diverges without.
    bool cautious{};
};

/// Makes the mesh and writes the case into `folder`, an empty folder. Gives the number of cells.
std::size_t write_foam_case(const FoamCase& foam, const std::filesystem::path& folder);

/// Environment that Debian's package needs; empty when its etc/controlDict is not where it is
/// expected.
[[nodiscard]] std::vector<std::string> foam_environment();

struct FoamTorque {
    double time{};
    double torque{}; ///< N m, the drive's, of the whole turn and the mesh's height
};
/// What the function object wrote, line by line.
[[nodiscard]] std::vector<FoamTorque> foam_torques(const std::filesystem::path& folder);

} // namespace searle::app::bench
