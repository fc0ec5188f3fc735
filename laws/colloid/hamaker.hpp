#pragma once

namespace searle::laws::colloid {

/// Van der Waals attraction of two spheres, Hamaker 1937, Physica 4, 1058. With centre distance r,
/// p = r^2 - (r_i + r_j)^2 and q = r^2 - (r_i - r_j)^2,
///     E = -A/6 [2 r_i r_j / p + 2 r_i r_j / q + ln(p / q)],
/// whose derivative collapses to
///     dE/dr = (32/3) A r (r_i r_j)^3 / (p q)^2.
/// Limits: -A a / (12 h) for equal spheres of radius a and h -> 0; -(16/9) A (a/r)^6 for r -> inf.
/// Unretarded; it overestimates beyond some tens of nanometres.
/// hamaker: A, J, >= 0.
template <class Scalar = double>
struct Hamaker {
    Scalar hamaker{};

    /// Energy at the surface distance h > 0, J, <= 0. @param r_i, r_j radii, m
    template <class Real>
    [[nodiscard]] Real energy(const Real& h, const Real& r_i, const Real& r_j) const {
        using std::log;
        const Real p = h * (h + 2 * (r_i + r_j));
        const Real q = p + 4 * r_i * r_j;
        const Real twice = 2 * r_i * r_j;
        return -Real(hamaker) / 6 * (twice / p + twice / q + log(p / q));
    }
    /// Attraction, -(force that pushes apart), N, >= 0.
    template <class Real>
    [[nodiscard]] Real attraction(const Real& h, const Real& r_i, const Real& r_j) const {
        const Real product = r_i * r_j;
        const Real p = h * (h + 2 * (r_i + r_j));
        const Real q = p + 4 * product;
        const Real ratio = product / (p * q);
        return Real(hamaker) * 32 / 3 * (h + r_i + r_j) * product * ratio * ratio;
    }
};

} // namespace searle::laws::colloid
