#pragma once

#include "rheometry/fit/fit_options.hpp"
#include "rheometry/fit/parameter.hpp"
#include "rheometry/fit/statistics.hpp"

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace searle::rheometry::fit {

/// Data or options that no fit can be made of; what() says why, for people.
struct FitError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What the data say about one parameter, SI.
struct Estimate {
    Parameter parameter;
    double value{};
    /// From the curvature at the optimum; NaN when held, on a bound, or not determined.
    double standard_error{};
    /// 95 % interval by the profile of the sum of squares.
    double low{};
    double high{};
    /// The data set no limit on that side: `low` is -infinity or a bound of the law (0 for a yield
    /// stress), `high` infinity or a bound of the law.
    bool low_open = false;
    bool high_open = false;
    bool at_bound = false;
};

struct FitResult {
    std::string model;
    std::vector<Estimate> estimates;
    /// Of the values in `estimates`, row by row, SI; 0 for parameters without a standard error.
    std::vector<double> covariance;
    std::vector<double> correlation;

    std::size_t points{};
    std::size_t degrees_of_freedom{};
    Weighting weighting{};
    Loss loss{};
    double sum_of_squares{};       ///< weighted
    double residual_deviation{};   ///< sqrt(sum_of_squares / degrees_of_freedom)
    double rms_relative{};         ///< root mean square of (fitted - observed) / observed
    double rms_absolute{};         ///< root mean square of fitted - observed
    double determination{};        ///< R^2, of the observed values as they are
    std::vector<double> fitted;    ///< in the order of the data
    std::vector<double> residuals; ///< weighted, without the loss, in the order of the data
    std::vector<double> units;     ///< of the residuals, in the observation's unit
    std::optional<RunsTest> runs;
    InformationCriteria criteria{};
    bool converged = false;
    int iterations = 0;
    std::vector<std::string> warnings;

    std::vector<double> present_rates; ///< 1/s, of a flow curve's points; empty for others

    /// In the search's coordinates, for bands: optimum, and covariance.
    std::vector<double> search;
    std::vector<double> search_covariance;

    [[nodiscard]] std::vector<double> values() const {
        std::vector<double> result;
        for (const Estimate& estimate : estimates)
            result.push_back(estimate.value);
        return result;
    }
};

} // namespace searle::rheometry::fit
