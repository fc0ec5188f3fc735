#include "solvers/plan_inertia.hpp"

#include "solvers/radial/gauss_rule.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace searle::solvers {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t panel_points = 5;
using PanelMatrix = std::array<std::array<double, panel_points>, panel_points>;

/// Row k: weights that integrate the polynomial through the panel's Gauss points from the panel's
/// lower end (-1) to point k.
PanelMatrix make_running_weights() {
    const auto& rule = radial::gauss_rule<panel_points>();
    PanelMatrix weights{};
    for (std::size_t k = 0; k < panel_points; ++k) {
        for (std::size_t j = 0; j < panel_points; ++j) {
            // Legendre expansion of the j-th cardinal polynomial, integrated term by term.
            const auto legendre = [](double x) {
                std::array<double, panel_points + 1> p{1.0, x};
                for (std::size_t l = 1; l + 1 < p.size(); ++l) {
                    const auto order = static_cast<double>(l);
                    p[l + 1] = ((2.0 * order + 1.0) * x * p[l] - order * p[l - 1]) / (order + 1.0);
                }
                return p;
            };
            const auto at_source = legendre(rule.node[j]);
            const auto at_end = legendre(rule.node[k]);
            double sum = 0.5 * (rule.node[k] + 1.0);
            for (std::size_t l = 1; l < panel_points; ++l) {
                sum += 0.5 * at_source[l] * (at_end[l + 1] - at_end[l - 1]);
            }
            weights[k][j] = rule.weight[j] * sum;
        }
    }
    return weights;
}

/// d rate / d stress of a law at an excess stress, 1/(Pa s); 0 where nothing moves.
template <class Law>
double tangent_compliance(const Law& law, double excess) {
    if (!(excess > 0.0)) {
        return 0.0;
    }
    const double compliance = 1.0 / law.stress_slope(law.rate_at_excess(excess));
    return std::isfinite(compliance) ? compliance : 0.0;
}

/// The sheared layer of a steady flow from the inner wall on, in panels of Gauss points over the
/// depth ln(r / R_inner).
class ShearedLayer {
public:
    template <class Law>
    ShearedLayer(const radial::AnnularGap& gap, const Law& law, const radial::SteadyGapFlow& steady)
        : gap_depth_(std::log1p(gap.width() / gap.inner_radius)), depth_(gap_depth_) {
        const double wall_excess = law.excess_stress(steady.inner_wall_rate);
        if (steady.partly_sheared) {
            depth_ = std::min(gap_depth_, 0.5 * std::log1p(wall_excess / law.yield_stress_value()));
        }
        // The rotation changes by a factor e over a depth of about half the wall's log slope.
        double width = std::clamp(law.log_slope(steady.inner_wall_rate), 0.02, 1.0);
        for (double bottom = 0.0; bottom < depth_;) {
            const bool is_last_that_fits = count_ + 2 * panel_points > points_.size();
            const double top = is_last_that_fits ? depth_ : std::min(depth_, bottom + width);
            add_panel(bottom, top, [&](double depth) {
                return tangent_compliance(law, wall_excess + steady.inner_wall_stress *
                                                                 std::expm1(-2.0 * depth));
            });
            bottom = top;
            width = std::min(1.0, 1.5 * width);
        }
    }

    /// integral of phi^2 r^3 dr / R_inner^4 over the gap, phi = d Omega / d omega.
    [[nodiscard]] double moment(TurningWall wall) const {
        double sum = 0.0;
        for (std::size_t k = 0; k < count_; ++k) {
            const double from_inner =
                total_shear_ > 0.0 ? points_[k].running_shear / total_shear_ : 0.0;
            const double rotation = wall == TurningWall::inner ? 1.0 - from_inner : from_inner;
            sum += points_[k].weight * rotation * rotation * std::exp(4.0 * points_[k].depth);
        }
        if (wall == TurningWall::outer) { // the plug turns with the rotor
            sum += 0.25 * std::exp(4.0 * depth_) * std::expm1(4.0 * (gap_depth_ - depth_));
        }
        return sum;
    }

    /// integral of sqrt(d rate / d stress) dr / R_inner over the layer, (Pa s)^(-1/2).
    [[nodiscard]] double travel() const {
        double sum = 0.0;
        for (std::size_t k = 0; k < count_; ++k) {
            sum +=
                points_[k].weight * std::sqrt(points_[k].compliance) * std::exp(points_[k].depth);
        }
        return sum;
    }

private:
    struct Point {
        double depth{};
        double weight{};
        double compliance{};
        double running_shear{}; ///< integral of compliance r^-2 over the depth, from the inner wall
    };

    template <class Compliance>
    void add_panel(double bottom, double top, const Compliance& compliance) {
        static const PanelMatrix running_weights = make_running_weights();
        const auto& rule = radial::gauss_rule<panel_points>();
        const double half = 0.5 * (top - bottom);
        std::array<double, panel_points> shear{};
        for (std::size_t k = 0; k < panel_points; ++k) {
            Point& point = points_[count_ + k];
            point.depth = bottom + half * (1.0 + rule.node[k]);
            point.weight = half * rule.weight[k];
            point.compliance = compliance(point.depth);
            shear[k] = point.compliance * std::exp(-2.0 * point.depth);
        }
        double panel_shear = 0.0;
        for (std::size_t k = 0; k < panel_points; ++k) {
            double running = 0.0;
            for (std::size_t j = 0; j < panel_points; ++j) {
                running += running_weights[k][j] * shear[j];
            }
            points_[count_ + k].running_shear = total_shear_ + half * running;
            panel_shear += points_[count_ + k].weight * shear[k];
        }
        total_shear_ += panel_shear;
        count_ += panel_points;
    }

    double gap_depth_{};
    double depth_{};
    std::array<Point, 200> points_;
    std::size_t count_{};
    double total_shear_{};
};

} // namespace

double newtonian_lag_time(const radial::AnnularGap& gap, double kinematic_viscosity,
                          TurningWall wall) {
    const auto& rule = radial::gauss_rule<12>();
    const double depth = std::log1p(gap.width() / gap.inner_radius);
    const int panels = static_cast<int>(std::ceil(depth)); // 12 points per factor e are exact
    const double half = 0.5 * depth / panels;
    double extent = 0.0;
    for (int panel = 0; panel < panels; ++panel) {
        for (std::size_t k = 0; k < rule.node.size(); ++k) {
            const double here = half * (2.0 * panel + 1.0 + rule.node[k]);
            const double rotation = wall == TurningWall::inner
                                        ? std::expm1(2.0 * (depth - here)) / std::expm1(2.0 * depth)
                                        : std::expm1(-2.0 * here) / std::expm1(-2.0 * depth);
            extent += half * rule.weight[k] * rotation * rotation * std::exp(4.0 * here);
        }
    }
    return -0.5 * std::expm1(-2.0 * depth) * gap.inner_radius * gap.inner_radius * extent /
           kinematic_viscosity;
}

GapResponse gap_response(const radial::AnnularGap& gap, const laws::flow::AnyFlowLaw& law,
                         double density, const radial::SteadyGapFlow& steady, TurningWall wall) {
    const ShearedLayer layer =
        std::visit([&](const auto& chosen) { return ShearedLayer(gap, chosen, steady); }, law);
    const double squared_radius = gap.inner_radius * gap.inner_radius;
    const double travel = layer.travel() * gap.inner_radius;
    return {.inertia = 2.0 * pi * density * squared_radius * squared_radius * layer.moment(wall),
            .decay_time = density * travel * travel / (pi * pi)};
}

GapResponse plane_gap_response(double width, const laws::flow::AnyFlowLaw& law, double density,
                               double rate) {
    const double slope =
        std::visit([rate](const auto& chosen) { return double{chosen.stress_slope(rate)}; }, law);
    return {.inertia = density * width / 3.0,
            .decay_time = density * width * width / (pi * pi * slope)};
}

double after_jump(double x) {
    if (x < 0.5) {
        // Jacobi's identity; what is left out is below exp(-pi^2 / x).
        return 0.5 * (std::sqrt(pi / x) - 1.0);
    }
    double sum = 0.0;
    for (int n = 1; n * n * x < 40.0 || n == 1; ++n) {
        sum += std::exp(-n * n * x);
    }
    return sum;
}

double after_kink(double x) {
    if (x < 0.5) {
        return std::sqrt(pi * x) - 0.5 * x;
    }
    double sum = pi * pi / 6.0;
    for (int n = 1; n * n * x < 40.0; ++n) {
        sum -= std::exp(-n * n * x) / (n * n);
    }
    return sum;
}

} // namespace searle::solvers
