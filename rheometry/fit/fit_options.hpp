#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace searle::rheometry::fit {

/// What a deviation is measured against.
enum class Weighting {
    relative,    ///< the measured value
    fitted,      ///< the fitted value: as `relative`, without its bias (docs/fit.md, Weights)
    absolute,    ///< nothing: all deviations in Pa count alike
    logarithmic, ///< the deviation is ln(fitted / measured)
    custom       ///< a given standard deviation per point
};

[[nodiscard]] std::string_view name_of(Weighting weighting);
/// relative, fitted, absolute, log or custom.
[[nodiscard]] std::optional<Weighting> weighting_named(std::string_view name);

/// How much a far outlier counts.
enum class Loss {
    squares, ///< least squares
    huber,   ///< linear beyond 1.345 robust standard deviations
    cauchy   ///< logarithmic beyond 2.385 of them
};

[[nodiscard]] std::string_view name_of(Loss loss);
/// none, huber or cauchy.
[[nodiscard]] std::optional<Loss> loss_named(std::string_view name);

struct Range {
    double low{};
    double high{};
};

struct FitOptions {
    Weighting weighting = Weighting::relative;
    Loss loss = Loss::squares;
    /// 95 % profile-likelihood intervals; without: from the standard errors.
    bool profile_intervals = true;
    /// Bounds by parameter's key instead of the usual ones; equal ends hold the parameter.
    std::map<std::string, Range, std::less<>> bounds;
};

} // namespace searle::rheometry::fit
