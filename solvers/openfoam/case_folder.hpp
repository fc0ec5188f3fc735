#pragma once

#include "solvers/openfoam/dictionaries.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace searle::solvers::openfoam {

/// Writes the case of one level: mesh, fields, dictionaries, Allrun. The folder appears as a whole.
/// Throws std::filesystem::filesystem_error.
void write_case(const std::filesystem::path& folder, const CaseFacts& facts);

/// Sets an entry of system/controlDict that stands on a line of its own.
void set_control(const std::filesystem::path& folder, const std::string& key,
                 const std::string& value);

/// An entry of system/controlDict that stands on a line of its own; empty where there is none.
[[nodiscard]] std::string control_entry(const std::filesystem::path& folder,
                                        const std::string& key);

/// Name of the time folder of an iteration.
[[nodiscard]] std::string name_of_iteration(double iteration);

/// Names of the time folders that hold a velocity, in the order of time.
/// @param folder  a case, or one of its processor folders
[[nodiscard]] std::vector<std::string> times_in(const std::filesystem::path& folder);

/// Removes the time folders that a killed program left half written, so that OpenFOAM, which starts
/// from the latest folder, finds a whole one. 0 always stays.
/// @param places  the case, or its processor folders: what is broken in one goes in all
void remove_half_written_times(const std::vector<std::filesystem::path>& places);

} // namespace searle::solvers::openfoam
