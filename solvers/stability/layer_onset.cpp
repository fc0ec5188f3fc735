#include "solvers/stability/layer_onset.hpp"

#include "solvers/stability/layer_basis.hpp"
#include "solvers/stability/marginal_problem.hpp"

#include <boost/math/tools/minima.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace searle::solvers::stability {
namespace {

/// The marginal problem of one steady flow, as matrices. With y = r/R_bob = exp(L xi), b = L k
/// R_bob, h and t the secant and tangent viscosity over eta at the bob, G the shear rate and W the
/// angular velocity over omega, ' = d/dxi, u the radial velocity, f the angular one, and for all
/// test functions U (zero with its slope at both ends), F (zero at both ends):
///   int h/y^2 (u'' - L^2 u + b^2 y^2 u)(U'' - L^2 U + b^2 y^2 U)
///     + 2 b^2 h [u' U' + L^2 u U + (u' + L u)(U' + L U)]        = int b^2 y^3 W f U
///   int t y^2 f' F' + b^2 h y^4 f F                             = lambda int y^3 (G - 2 W) u F
/// where lambda = 2 L^4 (rho omega R_bob^2 / eta)^2.
class LayerProblem {
public:
    LayerProblem(const ShearedLayer& layer, int modes)
        : problem_(matrices_of(layer, modes)),
          is_falling_everywhere_((layer.rate - 2.0 * layer.rotation).minCoeff() > 0.0) {}

    /// Largest 1/lambda > 0 at a wave number b; 0 if there is none.
    double largest_inverse(double wave_number) {
        return is_falling_everywhere_ ? problem_.largest_inverse(wave_number)
                                      : problem_.largest_inverse_of_all(wave_number);
    }

private:
    static MarginalProblem::Matrices matrices_of(const ShearedLayer& layer, int modes) {
        const LayerBasis basis = layer_basis(layer, modes);
        const double log_ratio = layer.depth;
        const double squared_log = log_ratio * log_ratio;
        const Eigen::ArrayXd weights = layer.grid->weights.array();
        const Eigen::ArrayXd radius = (log_ratio * layer.grid->position.array()).exp();
        const Eigen::ArrayXd square = radius.square();
        const Eigen::ArrayXd viscous = weights * layer.secant;
        const Eigen::MatrixXd bent = basis.clamped_curvature - squared_log * basis.clamped;
        const Eigen::MatrixXd mixed = weighted_product(bent, viscous, basis.clamped);
        const Eigen::MatrixXd spread = basis.clamped_slope + log_ratio * basis.clamped;
        const Eigen::ArrayXd falling = layer.rate - 2.0 * layer.rotation;
        return {.bending = {weighted_product(bent, viscous / square, bent),
                            mixed + mixed.transpose() +
                                2.0 * (weighted_product(basis.clamped_slope, viscous,
                                                        basis.clamped_slope) +
                                       squared_log *
                                           weighted_product(basis.clamped, viscous, basis.clamped) +
                                       weighted_product(spread, viscous, spread)),
                            weighted_product(basis.clamped, viscous * square, basis.clamped)},
                .swirl = {weighted_product(basis.pinned_slope, weights * layer.tangent * square,
                                           basis.pinned_slope),
                          weighted_product(basis.pinned, viscous * square.square(), basis.pinned)},
                .centrifugal = weighted_product(
                    basis.clamped, weights * square * radius * layer.rotation, basis.pinned),
                .transport = weighted_product(basis.pinned, weights * square * radius * falling,
                                              basis.clamped)};
    }

    MarginalProblem problem_;
    bool is_falling_everywhere_;
};

struct Minimum {
    double position;
    double value;
};

/// Minimum of a function with one, downhill from a start; the arguments are logarithms.
template <class Function>
Minimum minimum_downhill(const Function& function, double start) {
    double step = std::log(1.3);
    double middle = start;
    double lowest = function(middle);
    double behind = middle - step;
    double ahead = middle + step;
    double value_ahead = function(ahead);
    if (!(value_ahead < lowest)) {
        step = -step;
        std::swap(behind, ahead);
        value_ahead = function(ahead);
    }
    constexpr int most = 40;
    for (int k = 0; k < most && value_ahead < lowest; ++k) {
        behind = middle;
        middle = ahead;
        lowest = value_ahead;
        ahead += step;
        value_ahead = function(ahead);
    }
    const auto [position, value] = boost::math::tools::brent_find_minima(
        function, std::min(behind, ahead), std::max(behind, ahead), 20);
    return {position, value};
}

/// The linear problems of one flow.
class FlowOnset {
public:
    FlowOnset(const radial::AnnularGap& gap, const laws::flow::AnyFlowLaw& law, double speed)
        : gap_(gap), law_(law), speed_(speed) {
        if (!(gap.width() > 0.0) || !(gap.inner_radius > 0.0) || !(speed > 0.0) ||
            !std::isfinite(speed)) {
            throw std::invalid_argument("the onset of vortices needs a gap and a speed > 0");
        }
        flow_ = radial::steady_gap_flow(gap, law, speed);
    }

    /// k d at the onset of a Newtonian fluid that fills the sheared layer: where the search begins.
    [[nodiscard]] double usual_wave_number() const {
        return 3.13 * gap_.width() / (flow_.yield_radius - gap_.inner_radius);
    }

    [[nodiscard]] LayerOnset solve(int modes, double start) const {
        const ShearedLayer layer = sheared_layer(gap_, law_, flow_, speed_, nodes_for(modes));
        LayerProblem problem(layer, modes);
        const auto smallest_lambda = [&](double log_wave_number) {
            return 1.0 / problem.largest_inverse(std::exp(log_wave_number));
        };
        const double relative_gap = gap_.width() / gap_.inner_radius;
        const double scale = relative_gap / layer.depth; // k d over b
        const auto [position, lambda] = minimum_downhill(smallest_lambda, std::log(start / scale));
        const double squared_depth = layer.depth * layer.depth;
        const double rotation = std::sqrt(0.5 * lambda) / squared_depth; // rho omega R^2 / eta
        return {.critical_density = rotation * layer.wall_viscosity /
                                    (speed_ * gap_.inner_radius * gap_.inner_radius),
                .reynolds = rotation * relative_gap,
                .wave_number = std::exp(position) * scale,
                .relative_error = 0.0,
                .modes = modes};
    }

private:
    static int nodes_for(int modes) { return 2 * modes + 48; }

    const radial::AnnularGap& gap_;
    const laws::flow::AnyFlowLaw& law_;
    double speed_;
    radial::SteadyGapFlow flow_;
};

} // namespace

LayerOnset layer_onset_with_modes(const radial::AnnularGap& gap, const laws::flow::AnyFlowLaw& law,
                                  double speed, int modes) {
    if (modes < 4) {
        throw std::invalid_argument("the onset of vortices needs at least 4 modes");
    }
    const FlowOnset problem(gap, law, speed);
    return problem.solve(modes, problem.usual_wave_number());
}

LayerOnset layer_onset(const radial::AnnularGap& gap, const laws::flow::AnyFlowLaw& law,
                       double speed, double tolerance) {
    constexpr std::array resolutions{10, 14, 20, 28, 40, 56, 80};
    const FlowOnset problem(gap, law, speed);
    LayerOnset coarse = problem.solve(resolutions.front(), problem.usual_wave_number());
    for (std::size_t i = 1; i < resolutions.size(); ++i) {
        LayerOnset fine = problem.solve(resolutions[i], coarse.wave_number);
        fine.relative_error = std::abs(fine.reynolds / coarse.reynolds - 1.0);
        coarse = fine;
        if (!(fine.relative_error > tolerance)) {
            break;
        }
    }
    return coarse;
}

double energy_ratio(const radial::AnnularGap& gap, const laws::flow::AnyFlowLaw& law, double speed,
                    double density) {
    constexpr int nodes = 24;
    const ShearedLayer layer =
        sheared_layer(gap, law, radial::steady_gap_flow(gap, law, speed), speed, nodes);
    const double viscosity =
        layer.wall_viscosity * std::min({layer.secant.minCoeff(), layer.tangent.minCoeff(), 1.0});
    const double rate = std::max(layer.wall_rate, speed * layer.rate.maxCoeff());
    const double width = gap.inner_radius * std::expm1(layer.depth);
    return density * rate * width * width / (2.0 * std::numbers::pi * std::numbers::pi * viscosity);
}

} // namespace searle::solvers::stability
