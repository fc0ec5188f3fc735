#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace searle::app {

struct ConvertOptions {
    /// Measured speeds and torques: delimited text, or a spreadsheet exported by TRIOS (.xls).
    std::filesystem::path data_file;
    std::filesystem::path case_file;
    std::vector<std::string> overrides; ///< "key=value" texts of --set
    /// Where the table goes; absent: stdout. A file that is there is replaced, as a whole, at the
    /// end.
    std::optional<std::filesystem::path> output;
    /// Only this step of an export: its name, or the number that ends it ("3" for "Flow sweep -
    /// 3").
    std::optional<std::string> step;
    bool quiet = false; ///< no remarks on stderr
};

/// `searle convert DATA --case CASE.toml [-o OUT.csv] [--step NAME]`: measured torque and speed to
/// stress and rate, by the definition of the case (docs/conversion.md). The table goes to the
/// output, the definition and remarks to stderr. Returns the exit code 0. Throws CaseError,
/// rheometry::TableError, OutputPlaceError and OutputWriteError; nothing is written then.
[[nodiscard]] int convert(const ConvertOptions& options);

} // namespace searle::app
