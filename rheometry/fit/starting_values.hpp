#pragma once

#include "rheometry/fit/model.hpp"

#include <span>
#include <vector>

namespace searle::rheometry::fit {

/// Starting values (SI) read off the data: for a grid of the parameters in which the law is not
/// linear, the best values >= 0 of the others by linear least squares of the relative deviation;
/// the best few of the grid. Takes a sample of at most some 40 points.
/// @param rates     1/s, > 0, increasing
/// @param stresses  Pa, > 0, as many
[[nodiscard]] std::vector<std::vector<double>> starting_values(const Model& model,
                                                               std::span<const double> rates,
                                                               std::span<const double> stresses);

/// A simpler law's parameters as parameters of a law that contains it: same curve. Empty where
/// `model` does not contain `simpler`.
/// @param middle_rate  1/s, for parameters that are then without effect
[[nodiscard]] std::vector<double> embedded(const Model& simpler, std::span<const double> values,
                                           const Model& model, double middle_rate);

/// Names of the laws that a law contains as special cases, simplest first.
[[nodiscard]] std::vector<std::string_view> contained_in(const Model& model);

} // namespace searle::rheometry::fit
