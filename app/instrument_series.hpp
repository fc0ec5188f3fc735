#pragma once

#include "app/fit_record.hpp"
#include "app/verb_fit.hpp"
#include "rheometry/conversion/conversion.hpp"
#include "solvers/fit_instrument/fit_instrument.hpp"
#include "solvers/scene.hpp"

#include <string>
#include <vector>

namespace searle::app {

/// Raw rows of one file or step with the instrument they come from, before anything is left out.
struct InstrumentSeries {
    std::string name;
    solvers::Scene scene;
    rheometry::Conversion conversion;
    std::vector<double> times; ///< s; empty: the file has none
    std::vector<double> speeds;
    std::vector<double> torques;
    std::vector<std::size_t> lines; ///< of the file; empty: not known
    std::vector<std::string> regimes;
    bool is_flow_curve = true;

    [[nodiscard]] std::size_t line(std::size_t row) const {
        return lines.empty() ? row + 1 : lines[row];
    }
};

/// Reads all series that the options name; remarks go to stderr. Throws CaseError, TableError, and
/// UsageError.
[[nodiscard]] std::vector<InstrumentSeries> read_instrument_series(const FitVerbOptions& options);

/// Rows that a law can be fitted to, by instrument, and the curve that the conversion makes of
/// them.
struct PreparedSeries {
    std::vector<solvers::fit_instrument::Measurement> measurements;
    std::vector<solvers::fit_instrument::RunHistory> runs; ///< one per measurement
    std::vector<const InstrumentSeries*> series;           ///< one per measurement
    std::vector<fit::MeasuredPoint> points;                ///< usable ones, converted
    std::vector<fit::ExcludedPoint> excluded;
    std::vector<std::string> remarks;
};

/// Adds the usable rows of a series: not those at rest, beyond the onset of Taylor vortices, with
/// more than 1 % of secondary flow at the ends, or of a regime that says so; and, of a series
/// without times, not those with lag.
void add_series(PreparedSeries& prepared, const InstrumentSeries& series,
                const fit::Selection& selection);

} // namespace searle::app
