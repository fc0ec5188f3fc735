#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace searle::rheometry {

template <std::size_t Size>
using Vector = std::array<double, Size>;
template <std::size_t Size>
using Matrix = std::array<Vector<Size>, Size>;

/// The inverse of a symmetric positive definite matrix, by its Cholesky factor of the matrix scaled
/// to a unit diagonal; no value when it is singular to working precision.
template <std::size_t Size>
[[nodiscard]] std::optional<Matrix<Size>> inverse_of_symmetric(const Matrix<Size>& matrix) {
    Vector<Size> scale{};
    for (std::size_t i = 0; i < Size; ++i) {
        if (!(matrix[i][i] > 0.0))
            return std::nullopt;
        scale[i] = 1.0 / std::sqrt(matrix[i][i]);
    }
    Matrix<Size> factor{};
    for (std::size_t i = 0; i < Size; ++i) {
        for (std::size_t k = 0; k <= i; ++k) {
            double sum = matrix[i][k] * scale[i] * scale[k];
            for (std::size_t j = 0; j < k; ++j)
                sum -= factor[i][j] * factor[k][j];
            if (i != k)
                factor[i][k] = sum / factor[k][k];
            else if (sum > 1e-14)
                factor[i][i] = std::sqrt(sum);
            else
                return std::nullopt;
        }
    }
    Matrix<Size> half{};
    for (std::size_t i = 0; i < Size; ++i) {
        half[i][i] = 1.0 / factor[i][i];
        for (std::size_t k = 0; k < i; ++k) {
            double sum = 0.0;
            for (std::size_t j = k; j < i; ++j)
                sum -= factor[i][j] * half[j][k];
            half[i][k] = sum / factor[i][i];
        }
    }
    Matrix<Size> inverse{};
    for (std::size_t i = 0; i < Size; ++i)
        for (std::size_t k = 0; k < Size; ++k)
            for (std::size_t j = 0; j < Size; ++j)
                inverse[i][k] += half[j][i] * half[j][k] * scale[i] * scale[k];
    return inverse;
}

template <std::size_t Size>
[[nodiscard]] Vector<Size> product(const Matrix<Size>& matrix, const Vector<Size>& vector) {
    Vector<Size> result{};
    for (std::size_t i = 0; i < Size; ++i)
        for (std::size_t k = 0; k < Size; ++k)
            result[i] += matrix[i][k] * vector[k];
    return result;
}

} // namespace searle::rheometry
