#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace searle::app {

struct FitVerbOptions {
    /// Rheograms (rheometry/tables/flow_curves.hpp), or with `case_files` raw torques and speeds.
    std::vector<std::filesystem::path> data_files;
    /// Instruments that the data were measured with: one for all files, or one per file.
    std::vector<std::filesystem::path> case_files;
    std::vector<std::string> overrides; ///< "key=value" texts of --set
    std::string model = "herschel-bulkley";
    std::string weights = "relative"; ///< or fitted, absolute, log, or a column's name
    std::string loss = "none";        ///< or huber, cauchy
    std::optional<std::string> range; ///< "LOW:HIGH", 1/s
    std::vector<std::string> bounds;  ///< "NAME=LOW:HIGH"
    std::vector<std::string> held;    ///< "NAME=VALUE"
    std::optional<std::string> curve; ///< only curves whose name holds this text
    bool joint = false;               ///< all data with one set of parameters
    bool slip = false;                ///< with case files: fit a wall slip as well
    bool fixed_ends = false;          ///< with case files: c_L of the case, not computed
    bool keep_all = false;            ///< points in disturbed regimes too
    bool model_free = false;          ///< with case files: all rows of the model-free inversion
    bool json = false;
    bool csv = false;
    std::optional<std::string> predict; ///< "RATE,RATE,..." or "LOW:HIGH:COUNT", 1/s
    std::optional<int> design;          ///< suggest so many further points
    /// Also written: fit.html, fit.json or fit.csv by the ending.
    std::vector<std::filesystem::path> outputs;
};

/// `searle fit`: flow laws to rheograms, or through the instrument to torques. Tables, JSON or CSV
/// to stdout, remarks to stderr. Returns the exit code. Throws rheometry::TableError, CaseError,
/// OutputPlaceError, OutputWriteError and UsageError.
[[nodiscard]] int fit_laws(const FitVerbOptions& options);

} // namespace searle::app
