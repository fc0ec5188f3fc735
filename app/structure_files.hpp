#pragma once

#include "app/result_folder.hpp"
#include "solvers/suspension/microstructure.hpp"

#include <cstddef>
#include <map>
#include <vector>

namespace searle::app {

/// The microstructure of a suspension at the wanted rows, four tables each:
/// fields/row-0001-pairs.csv, -profile.csv, -contacts.csv and -local-fractions.csv
/// (docs/suspension.md).
/// @param structure  by row, from 0
/// @param finished   rows of the rheogram
/// @param wanted     for how many rows, evenly spread, the last included
[[nodiscard]] std::vector<ResultFile>
structure_files(const std::map<std::size_t, solvers::suspension::Microstructure>& structure,
                std::size_t finished, std::size_t wanted);

} // namespace searle::app
