#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace searle::solvers::openfoam {

/// All bytes of a file; empty where there is none.
[[nodiscard]] inline std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace searle::solvers::openfoam
