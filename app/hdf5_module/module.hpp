#pragma once

#include <map>
#include <string>
#include <vector>

namespace searle::app {

/// Columns of numbers in a file, and a text that says of what.
struct StoredColumns {
    std::string identity;
    std::map<std::string, std::vector<double>> columns;
    bool damaged = false; ///< some of it could not be read
};

} // namespace searle::app

/// HDF5 draws in some thirty libraries, which took a third of the time that the program needs to
/// start; so it is a module that only runs with checkpoints open. Both give false when the file
/// cannot be written or read; `errno` may say why.
extern "C" bool searle_hdf5_write(const char* file, const searle::app::StoredColumns* columns);
extern "C" bool searle_hdf5_read(const char* file, searle::app::StoredColumns* columns);
