#pragma once

#include "rheometry/correction/wall_rate.hpp"
#include "rheometry/fit/design.hpp"
#include "rheometry/fit/fit_result.hpp"
#include "rheometry/fit/flow_data.hpp"
#include "rheometry/fit/model.hpp"
#include "rheometry/fit/prediction.hpp"
#include "rheometry/fit/ramp_loop.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace searle::app {

namespace fit = rheometry::fit;

/// c_L of a DIN bob as computed for a law.
struct EndsRecord {
    std::string series;
    double least{};
    double most{};
    double of_case{}; ///< what the conventional route takes
    double relative_error{};
    std::string stand_in; ///< law whose c_L is taken; empty: the fitted one's
};

/// A row of raw data turned into rate and stress at the rotor's wall without any law.
struct ModelFreeRow {
    std::size_t line{};
    double speed{};  ///< rad/s, > 0
    double stress{}; ///< Pa
    double rate{};   ///< 1/s; NaN where the data do not give it
    double low{};    ///< 95 % band of the rate
    double high{};
    rheometry::GapBranch branch = rheometry::GapBranch::unknown;
    double law_rate{}; ///< of the best law at this speed
};

/// The model-free inversion of one series (docs/conversion.md).
struct ModelFreeRecord {
    std::string series;
    std::vector<ModelFreeRow> rows;
    std::optional<double> yield_stress; ///< Pa, that the slow end extrapolates to
    double yield_standard_error{};
};

/// The loop between the ways up and down of one series.
struct LoopRecord {
    std::string series;
    fit::RampLoop loop;
};

/// A law fitted to a curve, with what was asked for beside it.
struct LawRecord {
    const fit::Model* law{};
    fit::FitResult result;
    std::vector<fit::PredictedPoint> predictions;
    std::vector<fit::Design> designs;
    /// Of a fit through an instrument: the same law fitted to the converted stresses and rates.
    std::vector<fit::Estimate> conventional;
    std::vector<EndsRecord> ends;
    /// The law with its bands over the data's range, for a figure; of a fit through an instrument.
    std::vector<fit::PredictedPoint> curve;
};

/// One curve and the laws fitted to it, best first.
struct CurveRecord {
    std::string name;
    fit::FlowData data;
    std::vector<LawRecord> laws;
    std::string failure; ///< why there is none; empty: there is
    /// What the numbers of `data` are, for a fit through an instrument: torques at speeds.
    bool through_instrument = false;
    /// Torques in the order of the fit, and the conversion's rates; of a fit through an instrument.
    std::vector<double> observed;
    std::vector<double> observed_rates;
    std::vector<ModelFreeRecord> model_free;
    std::vector<LoopRecord> loops;
};

/// The contract's JSON: an object for one law, a list for several, best first; for several curves a
/// list of these with a key "curve". Ends with a line break.
/// @param as_list  a list even of one (several laws were asked for)
[[nodiscard]] std::string fits_as_json(const std::vector<CurveRecord>& curves, bool as_list);

/// A row per curve, law and parameter; with a header, 17 significant digits.
[[nodiscard]] std::string fits_as_csv(const std::vector<CurveRecord>& curves);

/// A row per row of the model-free inversion.
[[nodiscard]] std::string model_free_as_csv(const std::vector<CurveRecord>& curves);

/// A row per predicted rate.
[[nodiscard]] std::string predictions_as_csv(const std::vector<CurveRecord>& curves);

/// What was found beside the best law's parameters: ends, yield stress without a law, loops; a
/// sentence each.
[[nodiscard]] std::vector<std::string> notes_on(const CurveRecord& curve);

/// Tables for people; one line a curve where there are many.
/// @param all_rows  every row of a model-free inversion, not some of them
[[nodiscard]] std::string fits_as_text(const std::vector<CurveRecord>& curves, bool all_rows);

} // namespace searle::app
