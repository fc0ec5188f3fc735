#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace searle::rheometry::fit {

/// Two-sided 95 % quantile of Student's t; infinity without a degree of freedom.
[[nodiscard]] double student_t95(std::size_t degrees_of_freedom);

/// Wald and Wolfowitz's test of the signs of residuals in order of the rate.
struct RunsTest {
    std::size_t runs{};     ///< stretches of equal sign
    double expected_runs{}; ///< if the signs were thrown at random
    double probability{};   ///< of as few runs or fewer by chance, exact
};

/// No value when all residuals have one sign, or there are fewer than 6. Zeros count as positive.
[[nodiscard]] std::optional<RunsTest> runs_test(std::span<const double> residuals);

/// Akaike's criterion with the correction for few points (Hurvich & Tsai 1989), and Schwarz's.
/// AICc is infinite with too few points for it.
struct InformationCriteria {
    double aicc{};
    double bic{};
};

/// @param deviance    -2 ln likelihood at the optimum
/// @param parameters  fitted ones, without the scatter (which is counted as one more)
[[nodiscard]] InformationCriteria information_criteria(double deviance, std::size_t points,
                                                       std::size_t parameters);

} // namespace searle::rheometry::fit
