#pragma once

#include "rheometry/fit/fit_result.hpp"
#include "rheometry/fit/flow_data.hpp"
#include "rheometry/fit/model.hpp"

#include <string>
#include <vector>

namespace searle::rheometry::report {

/// A law as it was fitted.
struct FittedLaw {
    const fit::Model* law{};
    fit::FitResult result;
};

/// A curve and the laws fitted to it, best first.
struct FittedCurve {
    std::string name;
    fit::FlowData data;
    std::vector<FittedLaw> laws;
    std::string failure; ///< why there is none
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
