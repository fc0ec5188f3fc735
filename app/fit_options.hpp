#pragma once

#include "app/verb_fit.hpp"
#include "rheometry/fit/fit_options.hpp"
#include "rheometry/fit/flow_data.hpp"
#include "rheometry/fit/model.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace searle::app {

/// The verb's words as the fit takes them. Each throws UsageError for a word that it cannot use.
[[nodiscard]] rheometry::fit::FitOptions fit_options_of(const FitVerbOptions& options);
/// The laws that `--model` names: one, several with commas between them, or all.
[[nodiscard]] std::vector<rheometry::fit::Model> laws_of(std::string_view names);
[[nodiscard]] rheometry::fit::Selection selection_of(const FitVerbOptions& options);
/// The heading of a column of standard deviations, where `--weights` names one.
[[nodiscard]] std::optional<std::string> deviation_column_of(const FitVerbOptions& options);
/// Rates of "0.1,1,10" or of "0.01:1000:31" (spread evenly in the logarithm), 1/s.
/// @param option  that takes them, for messages
[[nodiscard]] std::vector<double> rates_of(std::string_view words, std::string_view option);

} // namespace searle::app
