#pragma once

#include "solvers/radial/gap_element.hpp"

#include <vector>

namespace searle::solvers::radial {

/// Flux F over the gap: N + 1 nodal values and N bubble coefficients.
struct FluxField {
    std::vector<double> node;
    std::vector<double> bubble;

    [[nodiscard]] GapElement::Flux of(std::size_t element) const {
        return {node[element], node[element + 1], bubble[element]};
    }
    /// Of the nodes, in magnitude; infinite where one is no number.
    [[nodiscard]] double largest() const;
};

/// Velocity over the gap: per element the coefficients of 1 and xi.
using VelocityField = std::vector<std::array<double, 2>>;

/// Outcome of one nonlinear solve.
struct StageOutcome {
    bool converged{};
    int iterations{};
};

/// The equations of one implicit stage, w = w~ + theta M^-1 (F', phi), for the flux F:
///
///   integral of rate(F/a)/b G dx + theta (D^T M^-1 D F) . G = [w G] at the walls - D^T w~ . G
///
/// for every hat and bubble G. This is the gradient of a convex function of F, whatever the law:
/// the yield stress only makes a stretch of it flat, so nothing is regularised. Newton with the
/// bubbles eliminated, one tridiagonal solve an iteration, and a line search on the function's
/// slope. Order 4 in the element size for the fluxes at the walls.
template <class Law>
class GapSystem {
public:
    GapSystem(const GapShape& shape, const std::vector<double>& grid, const Law& law);

    [[nodiscard]] std::size_t elements() const { return element_.size(); }
    [[nodiscard]] const Law& law() const { return law_; }
    [[nodiscard]] long linear_solves() const { return linear_solves_; }
    /// Evaluations of the flow law over all elements, line searches included: what takes the time.
    [[nodiscard]] long assemblies() const { return assemblies_; }
    /// Rounding error of the flux, relative: grows where a step is long against the time momentum
    /// takes through an element, since the velocity then hangs on differences of nearly equal
    /// fluxes.
    [[nodiscard]] double rounding() const;
    /// The same of the error estimate of a step, which is a difference of accelerations.
    [[nodiscard]] double step_rounding() const;

    /// dw/dt that goes with a flux.
    void acceleration(const FluxField& flux, VelocityField& result) const;
    /// integral of rho m w dx (angular momentum / 2 pi per length; momentum per area when planar).
    [[nodiscard]] double momentum(const VelocityField& velocity) const;

    [[nodiscard]] double momentum_size(const VelocityField& velocity) const;

    /// Solves the stage for `flux`, which holds the starting guess.
    /// @param theta      time-step times the scheme's diagonal, s, > 0
    /// @param wall       speeds of the inner and outer wall at the stage's time
    /// @param tolerance  accepted last correction relative to the largest flux
    /// @param typical_flux  size of a flux of this flow, > 0, for the homotopy's start
    [[nodiscard]] StageOutcome solve(const VelocityField& start, double theta,
                                     std::array<double, 2> wall, double tolerance,
                                     double typical_flux, FluxField& flux);

    /// The change of flux that a change of velocity would cause, by the last stage's linearisation.
    /// Result: the largest change over the nodes.
    [[nodiscard]] double flux_change(const VelocityField& change);

private:
    void assemble(const VelocityField& start, double theta, std::array<double, 2> wall,
                  const FluxField& flux);
    void factorise();
    /// Solves (tangent) correction = -residual with the bubbles eliminated.
    void correct(FluxField& correction);
    [[nodiscard]] double slope_along(const FluxField& direction) const;
    /// Moves from `from` along `direction` to where the function's slope has fallen enough.
    void search(const VelocityField& start, double theta, std::array<double, 2> wall,
                const FluxField& from, const FluxField& direction, double slope_start,
                double slope_end, FluxField& flux);
    [[nodiscard]] StageOutcome newton(const VelocityField& start, double theta,
                                      std::array<double, 2> wall, double tolerance,
                                      int most_iterations, FluxField& flux);

    Law law_;
    double width_;
    double speed_scale_ = 0.0;      ///< largest difference of speeds in the stage
    double added_compliance_ = 0.0; ///< 1/(Pa s) scale of the homotopy; 0 for the true equations
    std::vector<GapElement> element_;
    long linear_solves_ = 0;
    long assemblies_ = 0;
    double stiffness_ = 0.0;  ///< theta times the largest inverse mass of the last assembly
    double compliance_ = 0.0; ///< integral of d rate / d flux over the gap, of the last assembly

    // Residual and tangent at the last assembled flux, and the factors of the condensed tangent.
    std::vector<double> node_residual_, bubble_residual_;
    std::vector<std::array<double, 3>> coupling_; ///< tangent 0b, 1b, bb of each element
    std::vector<double> diagonal_, off_diagonal_; ///< condensed, then factors
    std::vector<double> pivot_, factor_;
    FluxField correction_, trial_, anchor_, guess_;
};

} // namespace searle::solvers::radial
