#pragma once

#include <cstddef>
#include <span>

namespace searle::rheometry::fit {

/// What an experiment would show for given parameters: a stress per rate, a torque per speed.
class ForwardModel {
public:
    ForwardModel() = default;
    ForwardModel(const ForwardModel&) = default;
    ForwardModel& operator=(const ForwardModel&) = default;
    virtual ~ForwardModel() = default;

    /// Number of observations predicted.
    [[nodiscard]] virtual std::size_t size() const = 0;
    /// @param search    the parameters in the search's coordinates (parameter.hpp)
    /// @param values    size() predictions
    /// @param jacobian  size() x parameters, row by row, d value / d coordinate; empty: not wanted
    /// @return false where there is no prediction for these parameters
    [[nodiscard]] virtual bool predict(std::span<const double> search, std::span<double> values,
                                       std::span<double> jacobian) const = 0;
};

} // namespace searle::rheometry::fit
