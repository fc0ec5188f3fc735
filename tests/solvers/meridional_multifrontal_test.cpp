#include "solvers/meridional/multifrontal_lu.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace {

using namespace searle::solvers::meridional;
using Eigen::Index;

/// Squares in columns and rows. Unknowns: one at each vertex, two at each inner edge, of which the
/// first is the flux through it, and the pressure of each square but the first.
class Squares {
public:
    /// @param closed  the last column borders on the first
    Squares(int columns, int rows, bool closed) {
        const int upright = closed ? columns : columns + 1;
        const auto vertex = [&](int i, int j) { return j * upright + i % upright; };
        int next = upright * (rows + 1);
        std::vector<int> level(static_cast<std::size_t>(columns * (rows + 1)), -1);
        std::vector<int> side(static_cast<std::size_t>(upright * rows), -1);
        const auto level_edge = [&](int i, int j) -> int& {
            return level[static_cast<std::size_t>(j * columns + i)];
        };
        const auto side_edge = [&](int i, int j) -> int& {
            return side[static_cast<std::size_t>(j * upright + i % upright)];
        };
        for (int j = 0; j < rows; ++j) {
            for (int i = 0; i < columns; ++i) {
                if (j > 0) {
                    level_edge(i, j) = next;
                    next += 2;
                }
                if (closed || i > 0) {
                    side_edge(i, j) = next;
                    next += 2;
                }
            }
        }
        for (int j = 0; j < rows; ++j) {
            for (int i = 0; i < columns; ++i) {
                ElementUnknowns element{.unknown = {vertex(i, j), vertex(i + 1, j),
                                                    vertex(i, j + 1), vertex(i + 1, j + 1)},
                                        .multiplier = i + j == 0 ? -1 : next,
                                        .radius = 1.0 * i,
                                        .height = 1.0 * j};
                next += i + j == 0 ? 0 : 1;
                for (const int edge : {level_edge(i, j), level_edge(i, j + 1), side_edge(i, j),
                                       side_edge(i + 1, j)}) {
                    element.unknown.push_back(edge);
                    element.unknown.push_back(edge < 0 ? -1 : edge + 1);
                }
                element.unknown.push_back(element.multiplier);
                elements.push_back(element);
            }
        }
        size = next;
    }

    /// Any coefficients, the same every time; of the pressure what flows out.
    [[nodiscard]] static Eigen::MatrixXd matrix(std::size_t element) {
        std::uint64_t state = element + 1;
        Eigen::MatrixXd result(13, 13);
        for (double& each : result.reshaped()) {
            state = state * 6364136223846793005ULL + 1442695040888963407ULL;
            each = static_cast<double>(state >> 40U) * 0x1p-23 - 1.0;
        }
        result.diagonal().array() += 4.0;
        result.row(12).setZero();
        result.col(12).setZero();
        for (const auto& [edge, out] : {std::pair{4, -1.0}, {6, 1.0}, {8, -1.0}, {10, 1.0}}) {
            result(12, edge) = result(edge, 12) = out;
        }
        return result;
    }

    [[nodiscard]] Eigen::MatrixXd whole() const {
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
        for (std::size_t e = 0; e < elements.size(); ++e) {
            const Eigen::MatrixXd part = matrix(e);
            const std::vector<int>& unknown = elements[e].unknown;
            for (std::size_t a = 0; a < unknown.size(); ++a) {
                for (std::size_t b = 0; b < unknown.size(); ++b) {
                    if (unknown[a] >= 0 && unknown[b] >= 0) {
                        sum(unknown[a], unknown[b]) +=
                            part(static_cast<Index>(a), static_cast<Index>(b));
                    }
                }
            }
        }
        return sum;
    }

    std::vector<ElementUnknowns> elements;
    int size{};
};

TEST(MultifrontalLu, solves_what_a_dense_matrix_with_full_pivoting_solves) {
    for (const auto& [columns, rows, closed] :
         {std::tuple{2, 1, false}, {9, 1, false}, {1, 8, false}, {5, 6, false}, {7, 3, true}}) {
        SCOPED_TRACE(columns);
        const Squares squares(columns, rows, closed);
        MultifrontalLu lu(squares.elements, squares.size);
        std::vector<int> calls(squares.elements.size());
        ASSERT_TRUE(lu.factorise([&](std::size_t e, Eigen::MatrixXd& matrix) {
            ++calls[e];
            matrix = Squares::matrix(e);
        }));
        EXPECT_EQ(calls, std::vector<int>(calls.size(), 1));
        const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(squares.size, -1.0, 2.0);
        const Eigen::VectorXd expected = squares.whole().fullPivLu().solve(load);
        EXPECT_LT((lu.solve(load) - expected).norm(), 1e-11 * expected.norm());
    }
}

TEST(MultifrontalLu, factorises_again_with_other_coefficients) {
    const Squares squares(4, 4, false);
    MultifrontalLu lu(squares.elements, squares.size);
    const Eigen::VectorXd load = Eigen::VectorXd::Ones(squares.size);
    const auto solved = [&](double factor) {
        EXPECT_TRUE(lu.factorise(
            [&](std::size_t e, Eigen::MatrixXd& matrix) { matrix = factor * Squares::matrix(e); }));
        return lu.solve(load);
    };
    const Eigen::VectorXd first = solved(1.0);
    EXPECT_LT((2.0 * solved(2.0) - first).norm(), 1e-13 * first.norm());
    EXPECT_EQ(solved(1.0), first);
}

TEST(MultifrontalLu, work_grows_as_the_three_halves_power_of_the_elements) {
    // George (1973): twice the squares along both sides, eight times the work.
    const auto work = [](int side) {
        const Squares squares(side, side, false);
        return MultifrontalLu(squares.elements, squares.size).multiplications();
    };
    EXPECT_NEAR(std::log2(work(64) / work(32)), 3.0, 0.1);
    // A strip is cut across: the work is that of its length.
    const auto strip = [](int length) {
        const Squares squares(4, length, false);
        return MultifrontalLu(squares.elements, squares.size).multiplications();
    };
    EXPECT_NEAR(std::log2(strip(256) / strip(128)), 1.0, 0.1);
}

TEST(MultifrontalLu, a_singular_matrix_is_told) {
    const Squares squares(3, 3, false);
    MultifrontalLu lu(squares.elements, squares.size);
    const auto all = [&](double factor) {
        return [factor](std::size_t e, Eigen::MatrixXd& matrix) {
            matrix = (e == 4 ? factor : 1.0) * Squares::matrix(e);
        };
    };
    EXPECT_FALSE(lu.factorise(all(std::numeric_limits<double>::quiet_NaN())));
    // The pressure of the middle square is in no equation.
    EXPECT_FALSE(lu.factorise([&](std::size_t e, Eigen::MatrixXd& matrix) {
        matrix = Squares::matrix(e);
        if (e == 4) {
            matrix.row(12).setZero();
            matrix.col(12).setZero();
        }
    }));
    EXPECT_TRUE(lu.factorise(all(1.0)));
}

} // namespace
