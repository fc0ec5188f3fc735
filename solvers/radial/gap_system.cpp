#include "solvers/radial/gap_system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::solvers::radial {
namespace {

/// Newton from a good guess takes 2 to 5 iterations; past this many the homotopy is quicker.
constexpr int most_direct_iterations = 15;
constexpr int most_homotopy_iterations = 40;
/// The homotopy's compliance falls by this factor from step to step, over so many steps at most.
constexpr double homotopy_factor = 0.15;
constexpr int most_homotopy_steps = 20;
/// A full Newton step is taken when the function's slope along it has fallen to this share.
constexpr double accepted_slope = 0.5;
/// Shift of the tangent's diagonal, relative to each entry (a thickening fluid at rest has entries
/// of any size): decides the otherwise free constant stress of a gap that is all plug (it stays
/// what it was); too small to slow Newton down. A Newtonian gap has none, and is solved once: there
/// the shift would stay in the flux.
template <class Law>
constexpr double shift = std::is_same_v<Law, laws::flow::Newtonian> ? 0.0 : 1e-13;
/// Largest growth of the flux in one iteration for laws that yield or bend.
constexpr double most_growth = 4.0;

void add_scaled(FluxField& sum, double factor, const FluxField& term) {
    for (std::size_t k = 0; k < sum.node.size(); ++k) {
        sum.node[k] += factor * term.node[k];
    }
    for (std::size_t k = 0; k < sum.bubble.size(); ++k) {
        sum.bubble[k] += factor * term.bubble[k];
    }
}

void scale(double factor, FluxField& field) {
    for (double& value : field.node) {
        value *= factor;
    }
    for (double& value : field.bubble) {
        value *= factor;
    }
}

/// A steady share, and one that grows with `growth` times stiffness over compliance.
double rounding_of(double growth, double stiffness, double compliance, std::size_t elements) {
    const double ratio = compliance > 0.0 ? stiffness / compliance : 0.0;
    return std::numeric_limits<double>::epsilon() *
           (8.0 + growth * ratio * static_cast<double>(elements));
}

} // namespace

double FluxField::largest() const {
    double most = 0.0;
    for (const double value : node) {
        // std::max would pass over what is not a number.
        if (std::isnan(value)) {
            return std::numeric_limits<double>::infinity();
        }
        most = std::max(most, std::abs(value));
    }
    return most;
}

template <class Law>
GapSystem<Law>::GapSystem(const GapShape& shape, const std::vector<double>& grid, const Law& law)
    : law_(law), width_(shape.width()) {
    const std::size_t count = grid.size() - 1;
    element_.reserve(count);
    for (std::size_t e = 0; e < count; ++e) {
        element_.emplace_back(shape, grid[e], grid[e + 1], rate_exponent(law));
    }
    node_residual_.resize(count + 1);
    bubble_residual_.resize(count);
    coupling_.resize(count);
    diagonal_.resize(count + 1);
    off_diagonal_.resize(count);
    pivot_.resize(count + 1);
    factor_.resize(count);
    correction_ = trial_ = FluxField{std::vector<double>(count + 1), std::vector<double>(count)};
}

template <class Law>
void GapSystem<Law>::acceleration(const FluxField& flux, VelocityField& result) const {
    for (std::size_t e = 0; e < element_.size(); ++e) {
        result[e] = element_[e].acceleration(flux.of(e));
    }
}

template <class Law>
double GapSystem<Law>::momentum(const VelocityField& velocity) const {
    double sum = 0.0;
    for (std::size_t e = 0; e < element_.size(); ++e) {
        sum += element_[e].momentum(velocity[e][0], velocity[e][1]);
    }
    return sum;
}

template <class Law>
double GapSystem<Law>::momentum_size(const VelocityField& velocity) const {
    double sum = 0.0;
    for (std::size_t e = 0; e < element_.size(); ++e) {
        sum += element_[e].momentum_size(velocity[e][0], velocity[e][1]);
    }
    return sum;
}

template <class Law>
void GapSystem<Law>::assemble(const VelocityField& start, double theta, std::array<double, 2> wall,
                              const FluxField& flux) {
    ++assemblies_;
    std::fill(node_residual_.begin(), node_residual_.end(), 0.0);
    std::fill(diagonal_.begin(), diagonal_.end(), 0.0);
    node_residual_.front() += wall[0];
    node_residual_.back() -= wall[1];
    stiffness_ = 0.0;
    compliance_ = 0.0;
    for (std::size_t e = 0; e < element_.size(); ++e) {
        const GapElement::Flux local = flux.of(e);
        GapElement::Integrals integrals = element_[e].integrals(law_, local);
        if (added_compliance_ > 0.0) {
            element_[e].add_compliance(added_compliance_, local, anchor_.of(e), integrals);
        }
        const auto& [residual, tangent] = integrals;
        const std::array<double, 2> change = element_[e].acceleration(local);
        const double w0 = start[e][0] + theta * change[0];
        const double w1 = start[e][1] + theta * change[1];
        node_residual_[e] += residual[0] - w0;
        node_residual_[e + 1] += residual[1] + w0;
        bubble_residual_[e] = residual[2] - 4.0 / 3.0 * w1;

        const auto& inverse = element_[e].inverse_mass();
        stiffness_ = std::max(stiffness_, theta * inverse[0]);
        compliance_ += tangent[0] + 2.0 * tangent[1] + tangent[2];
        diagonal_[e] += tangent[0] + theta * inverse[0];
        diagonal_[e + 1] += tangent[2] + theta * inverse[0];
        off_diagonal_[e] = tangent[1] - theta * inverse[0];
        coupling_[e] = {tangent[3] + 4.0 / 3.0 * theta * inverse[1],
                        tangent[4] - 4.0 / 3.0 * theta * inverse[1],
                        tangent[5] + 16.0 / 9.0 * theta * inverse[2]};
    }
}

template <class Law>
void GapSystem<Law>::factorise() {
    ++linear_solves_;
    for (std::size_t e = 0; e < element_.size(); ++e) {
        const auto& [left, right, bubble] = coupling_[e];
        diagonal_[e] -= left * left / bubble;
        diagonal_[e + 1] -= right * right / bubble;
        off_diagonal_[e] -= left * right / bubble;
    }
    pivot_[0] = diagonal_[0] * (1.0 + shift<Law>);
    for (std::size_t e = 0; e < element_.size(); ++e) {
        factor_[e] = off_diagonal_[e] / pivot_[e];
        // The condensed tangent is positive definite; rounding must not turn a pivot negative.
        const double own = diagonal_[e + 1];
        pivot_[e + 1] =
            std::max(own * (1.0 + shift<Law>)-factor_[e] * off_diagonal_[e], shift<Law> * own);
    }
}

template <class Law>
void GapSystem<Law>::correct(FluxField& correction) {
    auto& x = correction.node;
    for (std::size_t k = 0; k < x.size(); ++k) {
        x[k] = -node_residual_[k];
    }
    for (std::size_t e = 0; e < element_.size(); ++e) {
        const auto& [left, right, bubble] = coupling_[e];
        const double load = bubble_residual_[e] / bubble;
        x[e] += left * load;
        x[e + 1] += right * load;
    }
    for (std::size_t e = 0; e < element_.size(); ++e) {
        x[e + 1] -= factor_[e] * x[e];
    }
    for (std::size_t k = 0; k < x.size(); ++k) {
        x[k] /= pivot_[k];
    }
    for (std::size_t e = element_.size(); e-- > 0;) {
        x[e] -= factor_[e] * x[e + 1];
        const auto& [left, right, bubble] = coupling_[e];
        correction.bubble[e] = -(bubble_residual_[e] + left * x[e] + right * x[e + 1]) / bubble;
    }
}

template <class Law>
double GapSystem<Law>::slope_along(const FluxField& direction) const {
    double slope = 0.0;
    for (std::size_t k = 0; k < node_residual_.size(); ++k) {
        slope += node_residual_[k] * direction.node[k];
    }
    for (std::size_t k = 0; k < bubble_residual_.size(); ++k) {
        slope += bubble_residual_[k] * direction.bubble[k];
    }
    return slope;
}

template <class Law>
void GapSystem<Law>::search(const VelocityField& start, double theta, std::array<double, 2> wall,
                            const FluxField& from, const FluxField& direction, double slope_start,
                            double slope_end, FluxField& flux) {
    double low = 0.0;
    double low_slope = slope_start;
    double high = 1.0;
    double high_slope = slope_end;
    // The slope rises along the direction (convexity): regula falsi with bisection every other
    // time.
    for (int trial = 0; trial < 40; ++trial) {
        const double secant = low - low_slope * (high - low) / (high_slope - low_slope);
        const double length =
            trial % 2 == 0 && std::isfinite(high_slope) ? secant : 0.5 * (low + high);
        flux = from;
        add_scaled(flux, length, direction);
        assemble(start, theta, wall, flux);
        const double slope = slope_along(direction);
        if (std::abs(slope) <= accepted_slope * std::abs(slope_start)) {
            break;
        }
        (slope > 0.0 || !std::isfinite(slope) ? high : low) = length;
        (slope > 0.0 || !std::isfinite(slope) ? high_slope : low_slope) = slope;
    }
}

template <class Law>
StageOutcome GapSystem<Law>::newton(const VelocityField& start, double theta,
                                    std::array<double, 2> wall, double tolerance,
                                    int most_iterations, FluxField& flux) {
    constexpr bool linear = std::is_same_v<Law, laws::flow::Newtonian>;
    assemble(start, theta, wall, flux);
    StageOutcome outcome;
    while (outcome.iterations < most_iterations) {
        ++outcome.iterations;
        factorise();
        correct(correction_);
        const double step = correction_.largest();
        const double size = flux.largest();
        if (!std::isfinite(step)) {
            return outcome;
        }
        // The predicted fall of the convex function, in units of flux times speed: small against
        // tolerance^2 it leaves only directions that the flow does not feel (stress inside a plug).
        const double slope_full = slope_along(correction_);
        const double enough = tolerance * tolerance * size * speed_scale_;
        if (linear || step <= tolerance * std::max(size, step) || std::abs(slope_full) <= enough) {
            add_scaled(flux, 1.0, correction_);
            outcome.converged = true;
            return outcome;
        }
        if (size > 0.0 && step > most_growth * size) {
            scale(most_growth * size / step, correction_);
        }
        const double slope_start = slope_along(correction_);
        trial_ = flux;
        add_scaled(flux, 1.0, correction_);
        assemble(start, theta, wall, flux);
        const double slope_end = slope_along(correction_);
        if (slope_end > accepted_slope * std::abs(slope_start) || !std::isfinite(slope_end)) {
            search(start, theta, wall, trial_, correction_, slope_start, slope_end, flux);
        }
    }
    return outcome;
}

template <class Law>
StageOutcome GapSystem<Law>::solve(const VelocityField& start, double theta,
                                   std::array<double, 2> wall, double tolerance,
                                   double typical_flux, FluxField& flux) {
    anchor_ = flux;
    speed_scale_ = std::abs(wall[0] - wall[1]);
    for (const auto& velocity : start) {
        speed_scale_ = std::max(speed_scale_, std::abs(velocity[0] - wall[0]));
    }
    StageOutcome outcome = newton(start, theta, wall, tolerance, most_direct_iterations, flux);
    if (outcome.converged) {
        return outcome;
    }
    // A plug gives Newton no warning of the steep rise at its edge. A compliance in parallel with
    // the law does; it is taken back step by step, and the last solve has none of it.
    flux = anchor_;
    added_compliance_ = speed_scale_ / (std::max(typical_flux, flux.largest()) * width_);
    for (int k = 0; k < most_homotopy_steps; ++k) {
        const StageOutcome eased =
            newton(start, theta, wall, std::max(tolerance, 1e-3), most_homotopy_iterations, flux);
        outcome.iterations += eased.iterations;
        added_compliance_ *= homotopy_factor;
        if (k % 4 == 3) {
            const double kept = added_compliance_;
            added_compliance_ = 0.0;
            guess_ = flux;
            const StageOutcome exact =
                newton(start, theta, wall, tolerance, most_homotopy_iterations, flux);
            outcome.iterations += exact.iterations;
            if (exact.converged) {
                outcome.converged = true;
                return outcome;
            }
            flux = guess_;
            added_compliance_ = kept;
        }
    }
    added_compliance_ = 0.0;
    return outcome;
}

template <class Law>
double GapSystem<Law>::rounding() const {
    // Slow ramps of viscous fluids against the closed form, 12 to 676 elements, ramps of 1 to 1e4 s
    // in a gap of 1 ms: at most 0.06 in place of the 2.
    return rounding_of(2.0, stiffness_, compliance_, elements());
}

template <class Law>
double GapSystem<Law>::step_rounding() const {
    return rounding_of(200.0, stiffness_, compliance_, elements());
}

template <class Law>
double GapSystem<Law>::flux_change(const VelocityField& change) {
    std::fill(node_residual_.begin(), node_residual_.end(), 0.0);
    for (std::size_t e = 0; e < element_.size(); ++e) {
        node_residual_[e] -= change[e][0];
        node_residual_[e + 1] += change[e][0];
        bubble_residual_[e] = -4.0 / 3.0 * change[e][1];
    }
    correct(correction_);
    return correction_.largest();
}

template class GapSystem<laws::flow::Newtonian>;
template class GapSystem<laws::flow::Bingham>;
template class GapSystem<laws::flow::PowerLaw>;
template class GapSystem<laws::flow::HerschelBulkley>;
template class GapSystem<laws::flow::Casson>;
template class GapSystem<TabulatedLaw<laws::flow::CarreauYasuda>>;
template class GapSystem<TabulatedLaw<laws::flow::Cross>>;

} // namespace searle::solvers::radial
