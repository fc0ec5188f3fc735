#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace searle::solvers::openfoam {

/// What a function object of type `forces` wrote: a value at a time.
struct LoadSample {
    double time{};
    double value{};
};

enum class LoadComponent {
    moment_z, ///< N m about the z axis, by the fluid on the patches
    force_x   ///< N along x, by the fluid on the patches
};

/// All samples of a function object, in the order of time. Each (re)start has a folder of its own,
/// named by its time: what an earlier one wrote from there on is replaced. A last line that is not
/// complete is left out. Empty where there is no file.
/// @param object_folder  CASE/postProcessing/NAME
[[nodiscard]] std::vector<LoadSample> load_history(const std::filesystem::path& object_folder,
                                                   LoadComponent component);

/// The last samples that one (re)start wrote so far, in the order of time: about `count` of them,
/// or all there are. Takes no longer for a long file.
[[nodiscard]] std::vector<LoadSample> last_loads(const std::filesystem::path& object_folder,
                                                 std::string_view start, LoadComponent component,
                                                 int count);

} // namespace searle::solvers::openfoam
