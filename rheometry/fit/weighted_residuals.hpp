#pragma once

#include "rheometry/fit/fit_options.hpp"
#include "rheometry/fit/forward_model.hpp"
#include "rheometry/fit/least_squares.hpp"
#include "rheometry/fit/parameter.hpp"

#include <span>
#include <vector>

namespace searle::rheometry::fit {

/// Deviations of a prediction from observations, weighted, and bent by a robust loss.
class WeightedResiduals {
public:
    /// @param observed    size() of `forward`; > 0 unless the weighting is absolute or custom
    /// @param deviations  standard deviations per point for Weighting::custom, > 0; else unused
    WeightedResiduals(const ForwardModel& forward, std::span<const double> observed,
                      std::span<const double> deviations, Weighting weighting);

    /// The problem for the search; refers to this object.
    [[nodiscard]] LeastSquaresProblem problem(std::span<const Parameter> parameters) const;
    [[nodiscard]] bool evaluate(std::span<const double> search, std::span<double> residuals,
                                std::span<double> jacobian) const;
    /// Without the loss.
    [[nodiscard]] bool plain_residuals(std::span<const double> search,
                                       std::span<double> residuals) const;

    /// For Weighting::fitted: deviations are measured against these predictions from now on.
    void set_reference(std::span<const double> predicted);
    /// @param scale  robust standard deviation of the plain residuals, > 0
    void set_loss(Loss loss, double scale);

    /// What one unit of the plain residual is at each point, in the observation's unit; for the
    /// logarithmic weighting the observed value.
    [[nodiscard]] const std::vector<double>& units() const { return unit_; }
    [[nodiscard]] const ForwardModel& forward() const { return forward_; }
    [[nodiscard]] std::size_t size() const { return observed_.size(); }

private:
    const ForwardModel& forward_;
    std::vector<double> observed_;
    std::vector<double> unit_;
    bool logarithmic_;
    Loss loss_ = Loss::squares;
    double loss_scale_ = 1.0;
};

/// 1.4826 times the median of the absolute values: the standard deviation, if they are normal.
[[nodiscard]] double robust_deviation(std::span<const double> residuals);

} // namespace searle::rheometry::fit
