#pragma once

#include "solvers/openfoam/dictionaries.hpp"

namespace searle::solvers::openfoam {

/// A steady row ends early when its torque has stayed within this share of itself ...
inline constexpr double settled_share = 1e-10;
/// ... over this many iterations: the residual of a component that hardly flows may hang although
/// nothing moves any more.
inline constexpr int settled_iterations = 1000;

/// Allrun: what this program itself runs, as a POSIX shell script. Steady rows follow one another,
/// each watched once a second for having settled; a case in time runs on from where it stands.
[[nodiscard]] std::string run_script(const CaseFacts& facts);

} // namespace searle::solvers::openfoam
