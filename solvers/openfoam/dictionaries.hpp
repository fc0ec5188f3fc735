#pragma once

#include "geometry/mesh.hpp"
#include "solvers/openfoam/foam_plan.hpp"

#include <span>
#include <string>

namespace searle::solvers::openfoam {

/// What the texts of one level's case follow from.
struct CaseFacts {
    const Scene& scene;
    const FoamPlan& plan;
    const geometry::Mesh& mesh;
    double time_step{};    ///< s; of simpleFoam: 1, an iteration
    std::string coarser{}; ///< folder name of the level before, beside this one; empty: none
};

/// Time of OpenFOAM at which the case ends: s, or iterations over all rows.
[[nodiscard]] double end_time(const CaseFacts& facts);

/// 0/U: velocities at the walls as the drive turns them; every other patch by its kind.
[[nodiscard]] std::string velocity_text(const CaseFacts& facts);
/// 0/p, kinematic.
[[nodiscard]] std::string pressure_text(const CaseFacts& facts);
/// constant/transportProperties.
[[nodiscard]] std::string transport_properties(const CaseFacts& facts);
/// constant/turbulenceProperties: laminar.
[[nodiscard]] std::string turbulence_properties();
/// system/controlDict with the function objects torque_bob and torque_cup.
[[nodiscard]] std::string control_text(const CaseFacts& facts);
[[nodiscard]] std::string schemes_text(const CaseFacts& facts);
[[nodiscard]] std::string solution_text(const CaseFacts& facts);
/// system/decomposeParDict: slices along the axis or the flow.
[[nodiscard]] std::string decomposition_text(const CaseFacts& facts);

/// Names of the walls that turn with the drive, and of those at rest.
[[nodiscard]] std::vector<std::string> rotor_patches(const geometry::Mesh& mesh);
[[nodiscard]] std::vector<std::string> cup_patches(const geometry::Mesh& mesh);

} // namespace searle::solvers::openfoam
