#pragma once

#include "geometry/din_bob.hpp"
#include "rheometry/speed_history.hpp"
#include "solvers/axisymmetric/section_mesh.hpp"

#include <vector>

namespace searle::solvers::axisymmetric {

/// How a Newtonian fluid in the whole section answers to the rotor's speed, without secondary flow:
///   torque = steady omega + at_once domega/dt + sum of strength_k y_k,
///   dy_k/dt = domega/dt - decay_k y_k.
/// A linear system reduced to its decaying modes; all terms are positive.
struct SwirlResponse {
    double steady{};  ///< torque over speed, N m s
    double at_once{}; ///< inertia of the modes too fast to follow, kg m^2
    struct Mode {
        double decay{};    ///< 1/s, > 0
        double strength{}; ///< N m s, torque of a jump of the speed by 1 rad/s
    };
    std::vector<Mode> modes;
    long unknowns{};
    SectionDivision division;
};

/// One level of resolution.
struct ResponseResolution {
    int degree{};      ///< of the elements
    double smallest{}; ///< element next to the rotor over the gap
    int modes{};       ///< of the reduced system
};

/// @param viscosity  Pa s, > 0
/// @param density    kg/m^3, > 0
[[nodiscard]] SwirlResponse swirl_response(const geometry::DinBob& bob, double viscosity,
                                           double density, const ResponseResolution& resolution);

/// Torque at the rows of a history, N m, exact in time for the given response.
[[nodiscard]] std::vector<double> torque_along(const SwirlResponse& response,
                                               const rheometry::SpeedHistory& history);

/// Torque at the rows with an estimate of its error, from two resolutions, the second finer in all
/// respects; refined until the error is at most `accuracy` of the torque, or of 1e-3 of the largest
/// torque where that is more.
struct TransientSwirl {
    std::vector<double> torque; ///< N m
    std::vector<double> error;  ///< N m, >= 0
    double worst_relative_error{};
    bool reached{};
    int levels{};
    int modes{};
    long unknowns{};
    SectionDivision division; ///< of the finest level
    double steady{};          ///< torque over speed without inertia, N m s
};
[[nodiscard]] TransientSwirl transient_swirl(const geometry::DinBob& bob, double viscosity,
                                             double density, const rheometry::SpeedHistory& history,
                                             double accuracy);

} // namespace searle::solvers::axisymmetric
