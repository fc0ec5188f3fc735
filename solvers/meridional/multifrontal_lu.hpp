#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <Eigen/LU>
#include <functional>
#include <vector>

namespace searle::solvers::meridional {

/// An element of a mesh, as far as its matrix goes.
struct ElementUnknowns {
    /// Unknown of each row and column of the element's matrix; -1: prescribed, left out.
    std::vector<int> unknown;
    /// The one among them that multiplies a constraint (a mean pressure: nothing on the diagonal),
    /// or -1. It is of this element alone.
    int multiplier = -1;
    double radius{}; ///< of the centre, to divide the mesh by
    double height{}; ///< of the centre
};

/// LU factors of a matrix that is a sum of dense matrices of elements, by fronts (Duff and Reid
/// 1983, ACM Trans. Math. Softw. 9, 302) along a nested dissection of the mesh (George 1973, SIAM
/// J. Numer. Anal. 10, 345): two parts of the mesh become one by eliminating what only they share.
/// Pivots are sought within a front. The multiplier of a part stays until the part is joined to
/// another, since a part's unknowns determine its pressures up to a constant.
class MultifrontalLu {
public:
    /// @param size  number of unknowns. One multiplier must have been left out in each connected
    ///     piece of the mesh, whose walls let nothing through.
    MultifrontalLu(const std::vector<ElementUnknowns>& elements, int size);

    /// Sets the matrix of an element, whose size is that of its unknowns; called once for each.
    using Assembly = std::function<void(std::size_t element, Eigen::MatrixXd& matrix)>;

    /// False where a pivot is 0 or not finite, or where a piece has all of its multipliers; there
    /// are no factors then.
    bool factorise(const Assembly& assemble);

    /// @param load  of each unknown, (size)
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& load) const;

    /// Multiplications of a factorisation, to compare orderings by.
    [[nodiscard]] double multiplications() const;

private:
    /// A part of the mesh: an element, or two parts joined.
    struct Front {
        std::vector<std::size_t> parts;      ///< fronts before this one; none: an element
        std::size_t element{};               ///< where there are no parts
        std::vector<int> eliminated;         ///< unknowns
        std::vector<int> kept;               ///< unknowns shared with the rest of the mesh
        std::vector<std::vector<int>> place; ///< of what each part keeps, eliminated ones first
        Eigen::PartialPivLU<Eigen::MatrixXd> pivots; ///< (eliminated, eliminated)
        Eigen::MatrixXd to_eliminated;               ///< pivots^-1 (eliminated, kept)
        Eigen::MatrixXd from_eliminated;             ///< (kept, eliminated)
    };

    class Dissection;

    std::vector<Front> fronts_; ///< parts before what they make
};

} // namespace searle::solvers::meridional
