#include "rheometry/fit/weighted_residuals.hpp"

#include <algorithm>
#include <cmath>

namespace searle::rheometry::fit {
namespace {

struct Bent {
    double value{};
    double slope{};
};

/// The residual whose square is the loss of `x` (in robust standard deviations).
Bent bent(Loss loss, double x) {
    const double size = std::abs(x);
    if (loss == Loss::huber) {
        constexpr double edge = 1.345;
        if (size > edge) {
            const double root = std::sqrt(edge * (2.0 * size - edge));
            return {std::copysign(root, x), edge / root};
        }
    } else if (loss == Loss::cauchy && size > 1e-6) {
        constexpr double edge = 2.385;
        const double root = edge * std::sqrt(std::log1p(x * x / (edge * edge)));
        return {std::copysign(root, x), size / (root * (1.0 + x * x / (edge * edge)))};
    }
    return {x, 1.0};
}

} // namespace

WeightedResiduals::WeightedResiduals(const ForwardModel& forward, std::span<const double> observed,
                                     std::span<const double> deviations, Weighting weighting)
    : forward_(forward), observed_(observed.begin(), observed.end()), unit_(observed.size()),
      logarithmic_(weighting == Weighting::logarithmic) {
    double sum = 0.0;
    for (const double value : observed)
        sum += value * value / double(observed.size());
    const double size = std::sqrt(sum);
    for (std::size_t k = 0; k < unit_.size(); ++k) {
        // One common unit keeps absolute residuals, whatever their unit, near the others' size.
        if (weighting == Weighting::absolute)
            unit_[k] = size;
        else
            unit_[k] = weighting == Weighting::custom ? deviations[k] : observed_[k];
    }
}

LeastSquaresProblem WeightedResiduals::problem(std::span<const Parameter> parameters) const {
    LeastSquaresProblem problem;
    problem.evaluate = [this](std::span<const double> search, std::span<double> residuals,
                              std::span<double> jacobian) {
        return evaluate(search, residuals, jacobian);
    };
    problem.residuals = observed_.size();
    for (const Parameter& parameter : parameters) {
        problem.low.push_back(to_search(parameter.transform, parameter.low));
        problem.high.push_back(to_search(parameter.transform, parameter.high));
    }
    return problem;
}

bool WeightedResiduals::evaluate(std::span<const double> search, std::span<double> residuals,
                                 std::span<double> jacobian) const {
    if (!forward_.predict(search, residuals, jacobian))
        return false;
    const std::size_t count = search.size();
    for (std::size_t k = 0; k < observed_.size(); ++k) {
        double slope = 1.0 / unit_[k];
        if (logarithmic_) {
            if (!(residuals[k] > 0.0))
                return false;
            slope = 1.0 / residuals[k];
            residuals[k] = std::log(residuals[k] / observed_[k]);
        } else {
            residuals[k] = (residuals[k] - observed_[k]) / unit_[k];
        }
        if (loss_ != Loss::squares) {
            const Bent shape = bent(loss_, residuals[k] / loss_scale_);
            residuals[k] = shape.value * loss_scale_;
            slope *= shape.slope;
        }
        if (!std::isfinite(residuals[k]))
            return false;
        if (!jacobian.empty())
            for (std::size_t i = 0; i < count; ++i) {
                jacobian[k * count + i] *= slope;
                if (!std::isfinite(jacobian[k * count + i]))
                    return false;
            }
    }
    return true;
}

bool WeightedResiduals::plain_residuals(std::span<const double> search,
                                        std::span<double> residuals) const {
    WeightedResiduals plain = *this;
    plain.loss_ = Loss::squares;
    return plain.evaluate(search, residuals, {});
}

void WeightedResiduals::set_reference(std::span<const double> predicted) {
    std::copy(predicted.begin(), predicted.end(), unit_.begin());
}

void WeightedResiduals::set_loss(Loss loss, double scale) {
    loss_ = loss;
    loss_scale_ = scale;
}

double robust_deviation(std::span<const double> residuals) {
    std::vector<double> sizes;
    for (const double residual : residuals)
        sizes.push_back(std::abs(residual));
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return 1.4826 * *middle;
}

} // namespace searle::rheometry::fit
