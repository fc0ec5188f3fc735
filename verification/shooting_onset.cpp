#include "verification/shooting_onset.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace searle::verification {
namespace {

constexpr int steps = 2000;
constexpr double plug_distance = 1e-2; ///< cubed: share of the layer left out at a yield surface

/// The steady flow at one radius, over the bob's radius, speed and viscosity.
struct Point {
    double radius{};
    double stretch{}; ///< d ln r / d zeta
    double rotation{};
    double rate{};
    double secant{};
    double tangent{};
};

/// Steady flow at the ends and middles of the steps in zeta, ln r = depth (1 - (1 - zeta)^3).
class BaseFlow {
public:
    BaseFlow(const solvers::radial::AnnularGap& gap, const laws::flow::AnyFlowLaw& law,
             double speed)
        : law_(law), full_depth_(std::log1p(gap.width() / gap.inner_radius)) {
        // Speed rises with the wall stress: bisection of its logarithm.
        double low = -60.0;
        double high = 60.0;
        for (int k = 0; k < 100; ++k) {
            const double middle = 0.5 * (low + high);
            set_wall_stress(std::exp(middle));
            (depth_ > 0.0 && turned(0.0, 1.0, 400) > speed ? high : low) = middle;
        }
        set_wall_stress(std::exp(high));
        wall_viscosity_ = wall_stress_ / laws::flow::rate(law_, wall_stress_);
        const double end = has_plug_ ? 1.0 - plug_distance : 1.0;
        points_.resize(2 * steps + 1);
        double rotation = has_plug_ ? turned(end, 1.0, 4) : 0.0;
        for (int i = 2 * steps; i >= 0; --i) {
            const double zeta = end * i / (2.0 * steps);
            if (i < 2 * steps) {
                rotation += turned(zeta, end * (i + 1) / (2.0 * steps), 1);
            }
            points_[static_cast<std::size_t>(i)] = at(zeta, rotation / speed, speed);
        }
        step_ = end / steps;
    }

    [[nodiscard]] const Point& point(int half_step) const {
        return points_[static_cast<std::size_t>(half_step)];
    }
    [[nodiscard]] double step() const { return step_; }
    [[nodiscard]] double wall_viscosity() const { return wall_viscosity_; }

private:
    void set_wall_stress(double stress) {
        wall_stress_ = stress;
        const double yield = laws::flow::yield_stress(law_);
        const double sheared = yield > 0.0 ? 0.5 * std::log(stress / yield) : full_depth_ + 1.0;
        has_plug_ = sheared < full_depth_;
        depth_ = has_plug_ ? sheared : full_depth_;
    }
    [[nodiscard]] double log_radius(double zeta) const {
        return depth_ * (1.0 - std::pow(1.0 - zeta, 3));
    }
    [[nodiscard]] double stretch(double zeta) const {
        return 3.0 * depth_ * std::pow(1.0 - zeta, 2);
    }
    [[nodiscard]] double rate(double zeta) const {
        return laws::flow::rate(law_, wall_stress_ * std::exp(-2.0 * log_radius(zeta)));
    }
    /// Angular velocity between two places: integral of rate d ln r, panels of a three-point rule.
    [[nodiscard]] double turned(double from, double to, int panels) const {
        const double half = 0.5 * (to - from) / panels;
        double sum = 0.0;
        for (int k = 0; k < panels; ++k) {
            const double middle = from + (2.0 * k + 1.0) * half;
            const double off = half * std::sqrt(0.6);
            sum += half *
                   (5.0 * rate(middle - off) * stretch(middle - off) +
                    8.0 * rate(middle) * stretch(middle) +
                    5.0 * rate(middle + off) * stretch(middle + off)) /
                   9.0;
        }
        return sum;
    }
    [[nodiscard]] Point at(double zeta, double rotation, double speed) const {
        const double here = rate(zeta);
        const double stress = wall_stress_ * std::exp(-2.0 * log_radius(zeta));
        return {
            .radius = std::exp(log_radius(zeta)),
            .stretch = stretch(zeta),
            .rotation = rotation,
            .rate = here / speed,
            .secant = stress / here / wall_viscosity_,
            .tangent =
                std::visit([&](const auto& law) { return double{law.stress_slope(here)}; }, law_) /
                wall_viscosity_};
    }

    laws::flow::AnyFlowLaw law_;
    double full_depth_;
    double depth_{};
    bool has_plug_{};
    double wall_stress_{};
    double wall_viscosity_{};
    double step_{};
    std::vector<Point> points_;
};

using State = std::array<double, 6>; // u, w, S, Q, v, T

/// d/dr at the marginal state, for velocities u(r) cos kz, -w sin kz, v cos kz, lengths over the
/// bob's radius, density over eta / (omega R^2).
State slope(const Point& at, double density, double wave, const State& y) {
    const auto [u, w, shear, pressure, v, torsion] = y;
    const double r = at.radius;
    const double u_slope = wave * w - u / r;                    // continuity
    const double normal = pressure + 2.0 * at.secant * u_slope; // the pressure
    const double spin = 2.0 * at.rotation - at.rate;            // (r^2 Omega)' / r
    return {u_slope,
            shear / at.secant - wave * u,
            wave * normal + 2.0 * at.secant * wave * wave * w - shear / r,
            2.0 * at.secant * (u_slope / r - u / (r * r)) - wave * shear +
                2.0 * density * at.rotation * v,
            torsion / at.tangent + v / r,
            density * spin * u + at.secant * wave * wave * v - 2.0 * torsion / r};
}

State plus(const State& y, double factor, const State& d) {
    State sum = y;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i] += factor * d[i];
    }
    return sum;
}

State shoot(const BaseFlow& flow, double density, double wave, State y) {
    const double h = flow.step();
    for (int k = 0; k < steps; ++k) {
        const Point& start = flow.point(2 * k);
        const Point& middle = flow.point(2 * k + 1);
        const Point& end = flow.point(2 * k + 2);
        const auto at = [&](const Point& point, const State& state) {
            State d = slope(point, density, wave, state);
            for (double& value : d) {
                value *= point.stretch * point.radius; // d r / d zeta
            }
            return d;
        };
        const State a = at(start, y);
        const State b = at(middle, plus(y, 0.5 * h, a));
        const State c = at(middle, plus(y, 0.5 * h, b));
        const State d = at(end, plus(y, h, c));
        y = plus(plus(plus(plus(y, h / 6.0, a), h / 3.0, b), h / 3.0, c), h / 6.0, d);
    }
    return y;
}

double determinant(const BaseFlow& flow, double density, double wave) {
    const State first = shoot(flow, density, wave, {0.0, 0.0, 1.0, 0.0, 0.0, 0.0});
    const State second = shoot(flow, density, wave, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0});
    const State third = shoot(flow, density, wave, {0.0, 0.0, 0.0, 0.0, 0.0, 1.0});
    const auto minor = [&](std::size_t i, std::size_t j) {
        return second[i] * third[j] - second[j] * third[i];
    };
    return first[0] * minor(1, 4) - first[1] * minor(0, 4) + first[4] * minor(0, 1);
}

/// The smallest density between half and twice a guess at which the determinant changes sign.
double marginal_density(const BaseFlow& flow, double guess, double wave) {
    constexpr double stride = 1.1;
    double low = 0.5 * guess;
    double at_low = determinant(flow, low, wave);
    double high = low * stride;
    double at_high = determinant(flow, high, wave);
    while (at_low * at_high > 0.0) {
        if (high > 2.0 * guess) {
            throw std::runtime_error("no marginal density near the guess");
        }
        low = high;
        at_low = at_high;
        high *= stride;
        at_high = determinant(flow, high, wave);
    }
    // Regula falsi; an end that stays twice counts half (Illinois).
    double next = high;
    for (int k = 0, stays = 0; k < 60 && high - low > 1e-11 * high; ++k) {
        const double before = next;
        next = (low * at_high - high * at_low) / (at_high - at_low);
        const double value = determinant(flow, next, wave);
        if (std::abs(next - before) < 1e-11 * next) {
            break;
        }
        const bool replaces_high = value * at_high > 0.0;
        if (replaces_high) {
            high = next;
            at_high = value;
        } else {
            low = next;
            at_low = value;
        }
        const int side = replaces_high ? 1 : -1;
        if (stays == side) {
            (replaces_high ? at_low : at_high) *= 0.5;
        }
        stays = side;
    }
    return next;
}

} // namespace

ShotOnset shooting_onset(const solvers::radial::AnnularGap& gap, const laws::flow::AnyFlowLaw& law,
                         double speed, double density, double wave_number) {
    const BaseFlow flow(gap, law, speed);
    const double scale = flow.wall_viscosity() / (speed * gap.inner_radius * gap.inner_radius);
    // Parabolas through three wave numbers, wide and narrow.
    double best = wave_number * gap.inner_radius;
    for (const double spread : {0.05, 0.005}) {
        std::array<double, 3> found{};
        for (int i = 0; i < 3; ++i) {
            found[static_cast<std::size_t>(i)] =
                marginal_density(flow, density / scale, best * (1.0 + spread * (i - 1)));
        }
        const double bend = found[0] - 2.0 * found[1] + found[2];
        best *= 1.0 - spread * 0.5 * (found[2] - found[0]) / bend;
    }
    return {.density = scale * marginal_density(flow, density / scale, best),
            .wave_number = best / gap.inner_radius};
}

} // namespace searle::verification
