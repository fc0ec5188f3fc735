#pragma once

#include "app/case_reader.hpp"

#include <filesystem>

namespace searle::app {

/// Where OpenFOAM's cases of a run stand: beside its result folder, `<result folder>.openfoam`, in
/// a sweep `<result folder>.<name>.openfoam` (of a run named openfoam: `<result folder>.openfoam`).
[[nodiscard]] std::filesystem::path
engine_folder_for(const Case& source, const std::filesystem::path& result_folder, bool sweeps);

/// Throws OutputPlaceError where OpenFOAM cannot run in the folder: it leaves blanks and quotes out
/// of the paths that it is given.
void check_engine_can_run_in(const std::filesystem::path& folder);

/// Makes the folder ready for the case: it holds `case.toml`, the case as resolved.
/// @param anew  what an earlier run left there goes
/// @return whether an earlier run of this very case stands there, to go on from
/// Throws OutputPlaceError where it holds anything else, or another case.
bool open_engine_folder(const std::filesystem::path& folder, const Case& source, bool anew);

/// Removes a folder that no case was written to: the run ended before, for its settings.
void remove_unused_engine_folder(const std::filesystem::path& folder);

} // namespace searle::app
