#pragma once

#include "solvers/axisymmetric/section_space.hpp"

#include <Eigen/Core>

namespace searle::solvers::axisymmetric {

/// A field on a section and its division.
struct DividedSection {
    const SectionLines& lines;
    const SectionMesh& mesh;
    const SectionSpace& space;
};

/// The field `values` of `coarse` at the nodes of `fine`: exact when the fine lines contain the
/// coarse ones and the degree is not lower (the stress function: but for elements that no longer
/// touch the axis). Prescribed values are those of `fine`.
[[nodiscard]] Eigen::VectorXd transferred(const DividedSection& coarse,
                                          const Eigen::VectorXd& values, Field field,
                                          const DividedSection& fine);

} // namespace searle::solvers::axisymmetric
