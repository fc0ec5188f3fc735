#pragma once

#include "rheometry/fit/design.hpp"
#include "rheometry/fit/fit_result.hpp"
#include "rheometry/fit/flow_data.hpp"
#include "rheometry/fit/model.hpp"
#include "rheometry/fit/prediction.hpp"

#include <string>
#include <vector>

namespace searle::app {

namespace fit = rheometry::fit;

/// A law fitted to a curve, with what was asked for beside it.
struct LawRecord {
    const fit::Model* law{};
    fit::FitResult result;
    std::vector<fit::PredictedPoint> predictions;
    std::vector<fit::Design> designs;
    /// Of a fit through an instrument: the same law fitted to the converted stresses and rates.
    std::vector<fit::Estimate> conventional;
};

/// One curve and the laws fitted to it, best first.
struct CurveRecord {
    std::string name;
    fit::FlowData data;
    std::vector<LawRecord> laws;
    std::string failure; ///< why there is none; empty: there is
    /// What the numbers of `data` are, for a fit through an instrument: torques at speeds.
    bool through_instrument = false;
};

/// The contract's JSON: an object for one law, a list for several, best first; for several curves a
/// list of these with a key "curve". Ends with a line break.
/// @param as_list  a list even of one (several laws were asked for)
[[nodiscard]] std::string fits_as_json(const std::vector<CurveRecord>& curves, bool as_list);

/// A row per curve, law and parameter; with a header, 17 significant digits.
[[nodiscard]] std::string fits_as_csv(const std::vector<CurveRecord>& curves);

/// A row per predicted rate.
[[nodiscard]] std::string predictions_as_csv(const std::vector<CurveRecord>& curves);

/// Tables for people; one line a curve where there are many.
[[nodiscard]] std::string fits_as_text(const std::vector<CurveRecord>& curves);

} // namespace searle::app
