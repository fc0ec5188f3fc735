#include "solvers/openfoam/disk_space.hpp"

#include <system_error>

namespace searle::solvers::openfoam {

bool disk_is_full(const std::filesystem::path& folder) {
    constexpr std::uintmax_t least = 256 * 1024; // bytes; a time's fields take more
    std::error_code unknown;
    const std::filesystem::space_info space = std::filesystem::space(folder, unknown);
    return !unknown && space.available < least;
}

} // namespace searle::solvers::openfoam
