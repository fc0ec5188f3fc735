#pragma once

#include "rheometry/fit/fit_result.hpp"
#include "rheometry/fit/flow_data.hpp"
#include "rheometry/fit/model.hpp"
#include "rheometry/fit/prediction.hpp"

#include <string>
#include <vector>

namespace searle::rheometry::report {

/// A law as it was fitted.
struct FittedLaw {
    const fit::Model* law{};
    fit::FitResult result;
    /// Of a fit through an instrument: what the conventional route gives.
    std::vector<fit::Estimate> conventional{};
    /// Of a fit through an instrument: the law with its bands; else it is made from the result.
    std::vector<fit::PredictedPoint> curve{};
};

/// Stress and rate at the rotor's wall without a law, of one row.
struct RotorPoint {
    double stress{}; ///< Pa
    double rate{};   ///< 1/s
    double low{};    ///< 95 % band of the rate
    double high{};
};

/// A curve and the laws fitted to it, best first.
struct FittedCurve {
    std::string name;
    fit::FlowData data;
    std::vector<FittedLaw> laws;
    std::string failure; ///< why there is none

    // Of a fit through an instrument:
    std::vector<RotorPoint> rotor_points{};
    std::vector<double> observed{};       ///< N m, in the order of the fit
    std::vector<double> observed_rates{}; ///< 1/s, by the conversion
    std::vector<std::string> notes{};     ///< sentences on ends and loops, plain text
};

struct FitPageInput {
    std::vector<FittedCurve> curves;
    std::string program_version;
};

/// The page fit.html: per curve the data with the best law and its bands, the residuals, the table
/// of parameters with intervals, the correlations, the ranking and the warnings. Needs no network.
/// With more than 12 curves only the table of all of them is followed by the first 12 in full.
[[nodiscard]] std::string render_fit_page(const FitPageInput& input);

} // namespace searle::rheometry::report
