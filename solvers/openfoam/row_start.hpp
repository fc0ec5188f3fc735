#pragma once

#include "solvers/openfoam/foam_plan.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace searle::solvers::openfoam {

/// Where the iterations of a steady row begin: at the flow that the level before found for the same
/// row, interpolated by mapFields. From a flow at rest, or from another row's, what turns with the
/// rotor needs many times as many iterations.
struct RowStart {
    const FoamPlan& plan;
    std::filesystem::path folder;              ///< the case of this level
    std::filesystem::path coarser;             ///< the case of the level before; empty: none
    std::vector<std::filesystem::path> places; ///< of the fields: the case, or processor folders
    std::size_t row{};

    /// Names of the time folders: what the row before left, what is mapped, and where the row ends.
    [[nodiscard]] std::string before() const;
    [[nodiscard]] std::string mapped() const;
    [[nodiscard]] std::string end() const;

    /// Whether the row is at its start and the level before has solved it.
    [[nodiscard]] bool can_be_mapped() const;
    /// Puts fields with the conditions at the boundary, for mapFields to write over.
    void prepare() const;
    /// The command of mapFields, run in `folder`: from whole to whole, since nothing is
    /// interpolated between the parts of two processors.
    [[nodiscard]] std::vector<std::string> command() const;
    /// The command, run in `folder`, that gives each of several processors its part of that.
    [[nodiscard]] std::vector<std::string> distribution() const;
    /// Removes what was mapped: the row was solved, or a command failed.
    void clear() const;
};

} // namespace searle::solvers::openfoam
