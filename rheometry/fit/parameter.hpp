#pragma once

#include <string>

namespace searle::rheometry::fit {

/// How the search sees a parameter. Intervals do not depend on it, the search's ease does.
enum class Transform {
    identity,
    logarithm,  ///< for parameters > 0 of unknown size
    square_root ///< where the curve has a root of the parameter (Casson's yield stress)
};

/// One parameter of a fit.
struct Parameter {
    std::string key;  ///< as in case files: "yield_stress"
    std::string unit; ///< SI: "Pa", "Pa.s^n", "1"
    Transform transform = Transform::identity;
    double low{};  ///< smallest value allowed, SI
    double high{}; ///< largest value allowed, SI
    /// The end is a bound of the law itself (a yield stress is not negative), not just the edge of
    /// where the search looks.
    bool low_is_physical = false;
    bool high_is_physical = false;
    bool held = false; ///< keeps its starting value (low = high)
};

/// The search's coordinate of a value, its inverse, and d value / d coordinate.
[[nodiscard]] double to_search(Transform transform, double value);
[[nodiscard]] double from_search(Transform transform, double coordinate);
[[nodiscard]] double search_slope(Transform transform, double coordinate);

} // namespace searle::rheometry::fit
