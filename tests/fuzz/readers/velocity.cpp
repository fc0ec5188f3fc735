#include "solvers/openfoam/velocity_file.hpp"
#include "tests/fuzz/readers.hpp"
#include "tests/fuzz/temporary_file.hpp"

namespace searle::fuzz {

void read_velocity(std::string_view bytes) {
    file_of(bytes, "case/1/U");
    constexpr std::size_t cells = 3;
    static_cast<void>(solvers::openfoam::velocity_at(temporary_folder() / "case", "1", cells));
}

} // namespace searle::fuzz
