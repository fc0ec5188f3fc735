#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace searle::rheometry::fit {

template <std::size_t Count>
struct LinearTerms {
    std::array<double, Count> factor{};
    double misfit = std::numeric_limits<double>::infinity(); ///< sum of squares
};

/// Linear least squares with factors >= 0 and very few columns: every subset of the columns is
/// tried. Good to a few digits, as a start for a better fit.
template <std::size_t Count>
class PositiveLeastSquares {
public:
    void add(const std::array<double, Count>& row, double target) {
        for (std::size_t i = 0; i < Count; ++i) {
            for (std::size_t k = 0; k < Count; ++k)
                normal_[i][k] += row[i] * row[k];
            right_[i] += row[i] * target;
        }
        target_square_ += target * target;
    }

    [[nodiscard]] LinearTerms<Count> solve() const {
        LinearTerms<Count> best;
        best.misfit = target_square_;
        for (unsigned subset = 1; subset < (1U << Count); ++subset) {
            LinearTerms<Count> terms;
            if (solve_subset(subset, terms.factor)) {
                terms.misfit = misfit_of(terms.factor);
                if (terms.misfit < best.misfit)
                    best = terms;
            }
        }
        return best;
    }

private:
    bool solve_subset(unsigned subset, std::array<double, Count>& factor) const {
        std::array<std::array<double, Count>, Count> matrix = normal_;
        std::array<double, Count> right = right_;
        const auto in = [subset](std::size_t i) { return (subset >> i & 1U) != 0; };
        for (std::size_t i = 0; i < Count; ++i) {
            if (!in(i))
                continue;
            if (!(matrix[i][i] > 1e-13 * normal_[i][i]))
                return false;
            for (std::size_t k = i + 1; k < Count; ++k) {
                if (!in(k))
                    continue;
                const double ratio = matrix[k][i] / matrix[i][i];
                for (std::size_t j = i; j < Count; ++j)
                    matrix[k][j] -= ratio * matrix[i][j];
                right[k] -= ratio * right[i];
            }
        }
        for (std::size_t i = Count; i-- > 0;) {
            factor[i] = 0.0;
            if (!in(i))
                continue;
            double sum = right[i];
            for (std::size_t k = i + 1; k < Count; ++k)
                if (in(k))
                    sum -= matrix[i][k] * factor[k];
            factor[i] = sum / matrix[i][i];
            if (!(factor[i] >= 0.0))
                return false;
        }
        return true;
    }
    [[nodiscard]] double misfit_of(const std::array<double, Count>& factor) const {
        double misfit = target_square_;
        for (std::size_t i = 0; i < Count; ++i) {
            misfit -= 2.0 * factor[i] * right_[i];
            for (std::size_t k = 0; k < Count; ++k)
                misfit += factor[i] * normal_[i][k] * factor[k];
        }
        return misfit;
    }

    std::array<std::array<double, Count>, Count> normal_{};
    std::array<double, Count> right_{};
    double target_square_ = 0.0;
};

} // namespace searle::rheometry::fit
