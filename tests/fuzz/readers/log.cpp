#include "solvers/openfoam/log_tail.hpp"
#include "tests/fuzz/readers.hpp"
#include "tests/fuzz/temporary_file.hpp"

namespace searle::fuzz {

void read_log(std::string_view bytes) {
    static_cast<void>(solvers::openfoam::log_tail(file_of(bytes, "log.pimpleFoam")));
}

} // namespace searle::fuzz
