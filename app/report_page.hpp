#pragma once

#include "app/case_reader.hpp"
#include "app/result_folder.hpp"
#include "app/summary_json.hpp"
#include "rheometry/end_effect.hpp"
#include "rheometry/fields/section_fields.hpp"
#include "rheometry/rheogram.hpp"

#include <string>
#include <vector>

namespace searle::app {

/// What a result folder holds, apart from its report: enough to make the report from.
struct RunRecord {
    RunSummary summary;
    Case source; ///< read from case.toml; places of values are those of the summary
    rheometry::Rheogram rheogram;
    std::string csv;                                      ///< the bytes of rheogram.csv
    std::vector<rheometry::EndEffect> ends;               ///< of end_factor.csv
    std::vector<rheometry::fields::SectionFields> fields; ///< of fields/, by row
    std::vector<ResultFile> structure; ///< of a suspension that was just solved: its tables
};

/// What a run with particles says, in sentences; none without particles. Plain text.
[[nodiscard]] std::vector<std::string> remarks_on(const RunRecord& record);

/// The same over a sweep: where its runs differ.
[[nodiscard]] std::vector<std::string> remarks_on(const SweepSummary& summary,
                                                  const std::vector<RunRecord>& records);

/// report.html of a run. The same record gives the same bytes.
[[nodiscard]] std::string report_page(const RunRecord& record);

/// report.html over a sweep; one record for each of the summary's runs, in order.
[[nodiscard]] std::string overlay_page(const SweepSummary& summary,
                                       const std::vector<RunRecord>& records);

} // namespace searle::app
