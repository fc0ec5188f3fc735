#pragma once

#include "rheometry/fields/section_fields.hpp"
#include "rheometry/speed_history.hpp"
#include "solvers/axisymmetric/section_mesh.hpp"

#include <Eigen/Core>

#include <span>
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
    int elements{};
    long unknowns{};
};

/// One level of resolution.
struct ResponseResolution {
    int degree{};      ///< of the elements
    double smallest{}; ///< element next to the rotor over the gap
    int modes{};       ///< of the reduced system
};

/// The angular velocity that belongs to a response: speed steady + sum of y_k mode_k, at the nodes
/// of the elements.
struct SwirlShapes {
    SectionMesh mesh;
    int degree{};
    Eigen::VectorXd steady; ///< over the speed
    Eigen::MatrixXd mode;   ///< (node, mode), over y
};

/// @param viscosity  Pa s, > 0
/// @param density    kg/m^3, > 0
/// @param shapes     filled where not null
[[nodiscard]] SwirlResponse swirl_response(const SectionShape& shape, double viscosity,
                                           double density, const ResponseResolution& resolution,
                                           SwirlShapes* shapes = nullptr);

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
    int elements{};
    long unknowns{};
    double steady{};                 ///< torque over speed without inertia, N m s
    ResponseResolution resolution{}; ///< of the last level
};
[[nodiscard]] TransientSwirl transient_swirl(const SectionShape& shape, double viscosity,
                                             double density, const rheometry::SpeedHistory& history,
                                             double accuracy);

/// The flow in the section at some rows of a history.
/// @param rows  numbers from 1, increasing
[[nodiscard]] std::vector<rheometry::fields::SectionFields>
transient_fields(const SectionShape& shape, double viscosity, double density,
                 const rheometry::SpeedHistory& history, const ResponseResolution& resolution,
                 std::span<const std::size_t> rows);

} // namespace searle::solvers::axisymmetric
