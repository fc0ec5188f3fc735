#pragma once

namespace searle::solvers::stability {

/// Where circular Couette flow of a Newtonian fluid, inner cylinder turning and outer at rest,
/// loses its stability to Taylor vortices (axisymmetric, steady).
struct TaylorThreshold {
    double reynolds{};    ///< R_bob omega d / nu at the onset
    double wave_number{}; ///< axial wave number times gap width d at the onset
    double
        relative_error{}; ///< difference of `reynolds` between the last two resolutions, relative
    int modes{};          ///< polynomials per unknown of the last resolution
};

/// The linear stability problem (docs/plan.md, section Taylor vortices; Chandrasekhar 1961, chapter
/// VII) by a Legendre-Galerkin method in ln(r), minimised over the axial wave number, at rising
/// resolution until the Reynolds number stands still to 1e-10. In ln(r) all coefficients are entire
/// and nothing cancels for a narrow gap, so any gap > 0 will do: checked from 1e-6 to 999.
/// Answers are kept for the life of the process; a new one costs less than a millisecond up to
/// relative gaps of 1, a few milliseconds up to 20. Safe to call from several threads.
/// @param relative_gap  d / R_bob = delta - 1, > 0; std::invalid_argument otherwise
[[nodiscard]] TaylorThreshold taylor_threshold(double relative_gap);

/// The same at one resolution, uncached; relative_error is 0. For convergence studies.
/// @param modes  polynomials per unknown, >= 4
[[nodiscard]] TaylorThreshold taylor_threshold_with_modes(double relative_gap, int modes);

} // namespace searle::solvers::stability
