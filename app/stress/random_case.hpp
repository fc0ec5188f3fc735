#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace searle::app {

/// A scene of a stress sweep, as the text of its case file.
struct RandomCase {
    std::string kind;     ///< "single-gap herschel-bulkley steady", for the table
    std::string text;     ///< TOML
    bool physical = true; ///< an instrument could be asked this; false: absurd on purpose
};

/// The families that there are: "fluid", "extreme", "particles", "input", "openfoam".
[[nodiscard]] std::vector<std::string> stress_families();
/// Those that need nothing but this program.
[[nodiscard]] std::vector<std::string> usual_stress_families();

/// The case of a number in a family: the same for the same seed on every machine, whatever was
/// drawn before. Ranges: docs/robustness.md.
[[nodiscard]] RandomCase random_case(std::string_view family, std::uint64_t seed, long number);

} // namespace searle::app
