#pragma once

#include <string>

namespace searle::solvers {

/// What is known about the flow at one row.
struct RegimeFacts {
    double speed{};          ///< rad/s or m/s
    bool partly_sheared{};   ///< a yield surface lies inside a gap
    double taylor_ratio{};   ///< Re / Re_critical
    double lag_share{};      ///< part of the stress that is inertia, 0 ... 1
    double end_flow_share{}; ///< estimated part of the torque that comes from secondary flow at the
                             ///< ends
    double accuracy{};       ///< asked-for relative error: what is larger than it is named
};

/// Names joined by '+', in this order:
///  rest             the drive stands still
///  partly-sheared   part of the gap does not flow (yield stress)
///  lag              inertia is more than `accuracy` of the stress
///  taylor-vortices  Re is above its critical value
///  end-flow         secondary flow at the ends is more than `accuracy` of the torque
///  laminar          none of these: the steady laminar flow that the conversion rests on
[[nodiscard]] std::string regime_name(const RegimeFacts& facts);

} // namespace searle::solvers
