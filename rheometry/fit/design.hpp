#pragma once

#include "rheometry/fit/fit_result.hpp"
#include "rheometry/fit/forward_model.hpp"
#include "rheometry/fit/model.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace searle::rheometry::fit {

/// What each observation tells: its derivatives by the parameters over its scatter, row by row,
/// parameters in the order of the fit.
struct Sensitivities {
    std::vector<double> rows;
    std::size_t parameters{};

    [[nodiscard]] std::size_t size() const {
        return parameters == 0 ? 0 : rows.size() / parameters;
    }
};

/// Of all that a forward model predicts, at the optimum. The scatter is taken to stay as it was:
/// for absolute weights the residuals' deviation in the observation's unit, else in parts of the
/// prediction.
/// @param unit_ratio  unit of this model's observation per unit of those fitted; absolute weights
[[nodiscard]] Sensitivities sensitivities(const ForwardModel& forward, const FitResult& result,
                                          double unit_ratio = 1.0);

/// Points that could be measured, e.g. with one geometry on one drive.
struct Candidates {
    std::string name;
    std::vector<double> rates;  ///< 1/s, increasing
    std::vector<double> speeds; ///< rad/s (m/s), as many; empty: not of an instrument
    Sensitivities sensitivities;
};

struct DesignPoint {
    double rate{};  ///< 1/s
    double speed{}; ///< rad/s (m/s); 0: not of an instrument
    std::size_t repeats{};
};

/// Which further points would shrink the confidence region most.
struct Design {
    std::string name;                ///< of the candidates
    std::vector<DesignPoint> points; ///< rates increasing
    double low_rate{};               ///< of the candidates, 1/s
    double high_rate{};
    /// Standard errors after these points over those before, per parameter; NaN where the present
    /// data give none.
    std::vector<double> shrinkage;
    /// Standard errors that the data and these points together promise, SI.
    std::vector<double> standard_errors;
    double volume_ratio{}; ///< of the confidence ellipsoid, after over before; 0 if it was infinite
};

/// D-optimal: point by point the one that raises the determinant of the information most, then
/// exchanged one by one until none is better.
/// @param present  the data fitted
/// @param count    further points, >= 1
[[nodiscard]] Design suggest_points(const FitResult& result, const Sensitivities& present,
                                    const Candidates& candidates, std::size_t count);

/// One design per set of candidates, the best first.
[[nodiscard]] std::vector<Design> suggest_designs(const FitResult& result,
                                                  const Sensitivities& present,
                                                  const std::vector<Candidates>& sets,
                                                  std::size_t count);

} // namespace searle::rheometry::fit
