#pragma once

#include <filesystem>

namespace searle::app {

struct ReportOptions {
    std::filesystem::path folder; ///< a result folder, of a run or of a sweep
};

/// `searle report DIR`: makes report.html again from the folder's other files; of an unchanged
/// folder the bytes are those that `run` wrote. Returns the exit code: 0, or 2 when the folder does
/// not hold results. Throws OutputWriteError.
[[nodiscard]] int report(const ReportOptions& options);

} // namespace searle::app
