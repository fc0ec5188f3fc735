#pragma once

#include "geometry/mesh.hpp"
#include "geometry/outline.hpp"

namespace searle::geometry {

/// The gap between two circles, the inner one about the z axis, the outer one's centre at x =
/// -offset (so the gap is narrowest on the side of +x), as the conformal image of a concentric one.
///
/// With W = w / r_1 the map is z / r_1 = (W + b) / (1 + b W), which leaves the inner circle where
/// it is; the concentric outer circle has |W| = q = e^T, cosh T = (r_1^2 + r_2^2 - e^2) / (2 r_1
/// r_2), and b / (1 - b^2) = e / (2 r_2 sinh T) (b from the centre of the outer circle's image).
/// Lines that cross at right angles still do, and equal angles crowd together in the narrow part,
/// as Sommerfeld's substitution for the bearing has them.
class EccentricAnnulus {
public:
    /// 0 < inner < outer, 0 <= offset < outer - inner, all in m.
    EccentricAnnulus(double inner, double outer, double offset);

    /// Of a gap's rectangle in r and z, the inner wall at the least radius.
    EccentricAnnulus(const Outline& gap, double offset);

    [[nodiscard]] double inner() const { return inner_; }
    [[nodiscard]] double outer() const { return outer_; }
    /// Where a point of the concentric gap (inner <= r <= outer) comes to lie; z is kept. For
    /// offset 0 it stays.
    [[nodiscard]] Point placed(const Point& concentric) const;
    /// Largest angle on a wall, about that wall's centre, over the concentric gap's, >= 1.
    [[nodiscard]] double largest_stretch() const;

private:
    double inner_;
    double outer_;
    double log_ratio_; ///< T
    double pole_;      ///< b, 0 <= b < 1
};

/// What the body has that is made of `cells` chords around in place of arcs: measures of the whole
/// turn.
/// @param outline  the rectangle of the gap: the inner wall at the least radius
[[nodiscard]] OutlineMeasures eccentric_chord_measures(const Outline& outline, double offset,
                                                       int cells);

} // namespace searle::geometry
