#include "solvers/openfoam/moment_file.hpp"
#include "tests/fuzz/readers.hpp"
#include "tests/fuzz/temporary_file.hpp"

namespace searle::fuzz {

void read_moments(std::string_view bytes) {
    using solvers::openfoam::LoadComponent;
    const std::filesystem::path folder = temporary_folder() / "rotor";
    // A run that went on at time 2.
    for (const char* file :
         {"rotor/0/moment.dat", "rotor/0/force.dat", "rotor/2/moment.dat", "rotor/2/force.dat"})
        file_of(bytes, file);
    for (const auto component : {LoadComponent::moment_z, LoadComponent::force_x}) {
        static_cast<void>(solvers::openfoam::load_history(folder, component));
    }
}

} // namespace searle::fuzz
