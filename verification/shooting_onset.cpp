#include "verification/shooting_onset.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
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

template <class Number>
using State = std::array<Number, 6>; // u, w, S, Q, v, T

/// A disturbance over the bob's radius and speed: u(r), i w(r), v(r) times exp(i (k z + m theta) +
/// s t).
template <class Number>
struct Wave {
    double density{}; ///< over eta / (omega R^2)
    double axial{};   ///< k
    Number order{};   ///< i m; 0 in real numbers for m = 0
    Number growth{};  ///< s
};

/// d/dr of the linearised equations.
template <class Number>
State<Number> slope(const Point& at, const Wave<Number>& wave, const State<Number>& y) {
    const auto& [u, w, shear, pressure, v, torsion] = y;
    const double r = at.radius;
    const double k = wave.axial;
    const Number turn = wave.order / r;                          // i m / r
    const Number drift = wave.growth + wave.order * at.rotation; // D / Dt
    const Number u_slope = k * w - u / r - turn * v;             // continuity
    const Number radial = 2.0 * at.secant * u_slope;             // normal stresses
    const Number around = 2.0 * at.secant * (turn * v + u / r);
    const Number across = at.secant * (k * v + turn * w); // (theta, z) stress over i
    const Number level = pressure + radial;               // the pressure
    const double spin = 2.0 * at.rotation - at.rate;      // (r^2 Omega)' / r
    return {u_slope,
            shear / at.secant - k * u,
            k * level + 2.0 * at.secant * k * k * w - shear / r - turn * across +
                wave.density * drift * w,
            (radial - around) / r + turn * torsion - k * shear -
                wave.density * (drift * u - 2.0 * at.rotation * v),
            torsion / at.tangent + v / r - turn * u,
            wave.density * (drift * v + spin * u) + turn * (level - around) + k * across -
                2.0 * torsion / r};
}

template <class Number>
State<Number> plus(const State<Number>& y, double factor, const State<Number>& d) {
    State<Number> sum = y;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i] += factor * d[i];
    }
    return sum;
}

template <class Number>
State<Number> shoot(const BaseFlow& flow, const Wave<Number>& wave, State<Number> y) {
    const double h = flow.step();
    for (int k = 0; k < steps; ++k) {
        const Point& start = flow.point(2 * k);
        const Point& middle = flow.point(2 * k + 1);
        const Point& end = flow.point(2 * k + 2);
        const auto at = [&](const Point& point, const State<Number>& state) {
            State<Number> d = slope(point, wave, state);
            for (Number& value : d) {
                value *= point.stretch * point.radius; // d r / d zeta
            }
            return d;
        };
        const State<Number> a = at(start, y);
        const State<Number> b = at(middle, plus(y, 0.5 * h, a));
        const State<Number> c = at(middle, plus(y, 0.5 * h, b));
        const State<Number> d = at(end, plus(y, h, c));
        y = plus(plus(plus(plus(y, h / 6.0, a), h / 3.0, b), h / 3.0, c), h / 6.0, d);
    }
    return y;
}

/// Of the velocities that three solutions from the bob have at the outer end.
template <class Number>
Number determinant(const BaseFlow& flow, const Wave<Number>& wave) {
    const State<Number> first = shoot<Number>(flow, wave, {0.0, 0.0, 1.0, 0.0, 0.0, 0.0});
    const State<Number> second = shoot<Number>(flow, wave, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0});
    const State<Number> third = shoot<Number>(flow, wave, {0.0, 0.0, 0.0, 0.0, 0.0, 1.0});
    const auto minor = [&](std::size_t i, std::size_t j) {
        return second[i] * third[j] - second[j] * third[i];
    };
    return first[0] * minor(1, 4) - first[1] * minor(0, 4) + first[4] * minor(0, 1);
}

double determinant(const BaseFlow& flow, double density, double axial) {
    return determinant(flow, Wave<double>{.density = density, .axial = axial});
}

/// Where a wave that runs around the bob is marginal.
struct Running {
    double density{};
    double speed{}; ///< angular phase speed over the bob's
};

/// Newton's method in the density and the phase speed, for m > 0 (any real number).
Running marginal_running_wave(const BaseFlow& flow, double axial, double m, Running guess) {
    using Complex = std::complex<double>;
    const auto value_at = [&](double density, double speed) {
        return determinant(flow, Wave<Complex>{.density = density,
                                               .axial = axial,
                                               .order = {0.0, m},
                                               .growth = {0.0, -m * speed}});
    };
    constexpr double aside = 1e-5;
    for (int k = 0; k < 30; ++k) {
        const Complex here = value_at(guess.density, guess.speed);
        const Complex by_density =
            (value_at(guess.density * (1.0 + aside), guess.speed) - here) / aside;
        const Complex by_speed = (value_at(guess.density, guess.speed + aside) - here) / aside;
        const double area = (std::conj(by_density) * by_speed).imag();
        const double density_step = (std::conj(by_speed) * here).imag() / area;
        const double speed_step = -(std::conj(by_density) * here).imag() / area;
        guess.density *= 1.0 + std::clamp(density_step, -0.2, 0.2);
        guess.speed += std::clamp(speed_step, -0.1, 0.1);
        if (std::abs(density_step) + std::abs(speed_step) < 1e-8) {
            return guess;
        }
    }
    throw std::runtime_error("no marginal wave near the guess");
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

/// Lowest of a parabola through three values, one apart, and where.
struct Lowest {
    double position; ///< from the middle one
    double value;
};
Lowest lowest(const std::array<double, 3>& values) {
    const double bend = values[0] - 2.0 * values[1] + values[2];
    const double lean = 0.5 * (values[2] - values[0]);
    return {-lean / bend, values[1] - 0.5 * lean * lean / bend};
}

double density_scale(const BaseFlow& flow, const solvers::radial::AnnularGap& gap, double speed) {
    return flow.wall_viscosity() / (speed * gap.inner_radius * gap.inner_radius);
}

} // namespace

ShotOnset shooting_onset(const solvers::radial::AnnularGap& gap, const laws::flow::AnyFlowLaw& law,
                         double speed, double density, double wave_number) {
    const BaseFlow flow(gap, law, speed);
    const double scale = density_scale(flow, gap, speed);
    double best = wave_number * gap.inner_radius;
    for (const double spread : {0.05, 0.005}) {
        std::array<double, 3> found{};
        for (int i = 0; i < 3; ++i) {
            found[static_cast<std::size_t>(i)] =
                marginal_density(flow, density / scale, best * (1.0 + spread * (i - 1)));
        }
        best *= 1.0 + spread * lowest(found).position;
    }
    return {.density = scale * marginal_density(flow, density / scale, best),
            .wave_number = best / gap.inner_radius};
}

double running_wave_density(const solvers::radial::AnnularGap& gap,
                            const laws::flow::AnyFlowLaw& law, double speed, int order,
                            const ShotOnset& axisymmetric) {
    const BaseFlow flow(gap, law, speed);
    const double scale = density_scale(flow, gap, speed);
    double axial = axisymmetric.wave_number * gap.inner_radius;
    Running wave{.density = axisymmetric.density / scale, .speed = 0.4};
    // From nearly axisymmetric ones, whose density is known.
    constexpr int stages = 8;
    for (int k = 1; k <= stages * order; ++k) {
        wave = marginal_running_wave(flow, axial, static_cast<double>(k) / stages, wave);
    }
    double least = wave.density;
    for (const double spread : {0.05, 0.05}) {
        std::array<double, 3> found{};
        for (int i = 0; i < 3; ++i) {
            found[static_cast<std::size_t>(i)] =
                marginal_running_wave(flow, axial * (1.0 + spread * (i - 1)), order, wave).density;
        }
        const Lowest low = lowest(found);
        axial *= 1.0 + spread * std::clamp(low.position, -3.0, 3.0);
        least = low.value;
        wave = marginal_running_wave(flow, axial, order, wave);
    }
    return scale * std::min(least, wave.density);
}

} // namespace searle::verification
