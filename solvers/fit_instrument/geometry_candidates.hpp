#pragma once

#include "geometry/instrument.hpp"
#include "rheometry/fit/design.hpp"
#include "rheometry/fit/fit_result.hpp"
#include "rheometry/fit/model.hpp"

#include <string>
#include <vector>

namespace searle::solvers::fit_instrument {

/// What a drive can do and its sensor can tell, of the order of a rotational rheometer's data
/// sheet: speeds 1e-4 to 300 rad/s, torques 1 uN m to 0.2 N m. Of a box: 1 um/s to 0.1 m/s and
/// 1 mN to 50 N.
struct DriveLimits {
    double slowest = 1e-4;
    double fastest = 300.0;
    double least_torque = 1e-6;
    double largest_torque = 0.2;
};

/// An instrument that further points could be measured with.
struct GeometryChoice {
    std::string name; ///< "din-bob, 14/15.2 mm, 42 mm"
    geometry::Instrument instrument;
};

/// One of each of the four geometries, of usual sizes: 14/15 mm single gap, double gap of 20 to
/// 22.38 mm, 14/15.2 mm DIN bob, 1 mm box; the case's own, where there is one, in place of its
/// kind.
[[nodiscard]] std::vector<GeometryChoice>
usual_geometries(const std::vector<geometry::Instrument>& own);

/// Points of one instrument, spread over the speeds at which the drive reaches, the fitted law's
/// torque can be measured, and the flow has neither Taylor vortices nor, at a DIN bob's ends, more
/// than 1 % of secondary flow; what each would tell is seen
/// through the instrument (gap curvature and plug; c_L as a constant drops out). No points where
/// nothing is left.
/// @param result          of a fit of `law` to a flow curve or, with a slip as last parameter,
///                        through instruments
/// @param density         kg/m^3; NaN: not known, Taylor vortices are not looked at
/// @param stress_results  the fit's observations are stresses (a flow curve), not torques
[[nodiscard]] rheometry::fit::Candidates candidates_of(const GeometryChoice& choice,
                                                       const rheometry::fit::Model& law,
                                                       const rheometry::fit::FitResult& result,
                                                       double density, bool stress_results);

} // namespace searle::solvers::fit_instrument
