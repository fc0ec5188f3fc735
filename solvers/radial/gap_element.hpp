#pragma once

#include "solvers/radial/compliance.hpp"
#include "solvers/radial/gap_grid.hpp"
#include "solvers/radial/gauss_rule.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace searle::solvers::radial {

/// One element of the dual (flux) discretisation of the transient gap equation: on xi in [-1, 1]
/// the flux is F = F0 (1 - xi)/2 + F1 (1 + xi)/2 + Fb (1 - xi^2), the velocity w = w0 + w1 xi. All
/// that depends on geometry alone is kept here.
class GapElement {
public:
    /// Gauss points of a smooth element: enough for rate ~ excess^4, and for steeper laws.
    static constexpr int few_points = 5;
    static constexpr int many_points = 8;

    /// Values of the flux: at the two ends, and the bubble's coefficient.
    using Flux = std::array<double, 3>;

    /// integral of rate(F/a)/b G_i dx, and its derivative with respect to F_j (upper triangle
    /// 00, 01, 11, 0b, 1b, bb).
    struct Integrals {
        std::array<double, 3> residual{};
        std::array<double, 6> tangent{};
    };

    /// @param exponent  the law's rate_exponent
    GapElement(const GapShape& shape, double left, double right, double exponent);

    /// d(w0, w1)/dt = M^-1 (integral of F' phi dx).
    [[nodiscard]] std::array<double, 2> acceleration(const Flux& flux) const {
        const double jump = flux[1] - flux[0];
        const double bend = -4.0 / 3.0 * flux[2];
        return {inverse_mass_[0] * jump + inverse_mass_[1] * bend,
                inverse_mass_[1] * jump + inverse_mass_[2] * bend};
    }
    /// Inverse of the mass matrix of (1, xi): entries 00, 01, 11; 1/(kg m) or 1/(kg/m^2) planar.
    [[nodiscard]] const std::array<double, 3>& inverse_mass() const { return inverse_mass_; }
    /// integral of rho m (w0 + w1 xi) dx: the element's share of the angular momentum / (2 pi).
    [[nodiscard]] double momentum(double w0, double w1) const {
        return mass_[0] * w0 + mass_[1] * w1;
    }

    /// integral of rho m (|w0| + |w1 xi|) dx, nearly: the size of a momentum.
    [[nodiscard]] double momentum_size(double w0, double w1) const {
        return mass_[0] * std::abs(w0) + std::sqrt(mass_[0] * mass_[2]) * std::abs(w1);
    }
    /// Adds `compliance` times the integral of (F - from) G_i dx: the homotopy of GapSystem.
    void add_compliance(double compliance, const Flux& flux, const Flux& from,
                        Integrals& sum) const;
    /// Integrals over the element; split exactly where the flux crosses the yield stress, with a
    /// variable that takes the root-like start of the rate away, also where that start lies a
    /// little outside: the integrals are continuous in the flux, however a crossing passes a node.
    template <class Law>
    [[nodiscard]] Integrals integrals(const Law& law, const Flux& flux) const;

private:
    struct Sample {
        double inverse_a; ///< 1/a
        double weight;    ///< Gauss weight dx/dxi / b
        std::array<double, 3> shape;
    };

    [[nodiscard]] static std::array<double, 3> shape_functions(double xi) {
        return {0.5 * (1.0 - xi), 0.5 * (1.0 + xi), (1.0 - xi) * (1.0 + xi)};
    }
    [[nodiscard]] Sample sample_at(double xi, double weight) const {
        const double x = middle_ + half_ * xi;
        return {planar_ ? 1.0 : 1.0 / (x * x), weight * half_ / (planar_ ? 1.0 : x),
                shape_functions(xi)};
    }
    [[nodiscard]] static double value(const Flux& flux, const Sample& sample) {
        return flux[0] * sample.shape[0] + flux[1] * sample.shape[1] + flux[2] * sample.shape[2];
    }
    template <class Law>
    static void add(Integrals& sum, const Law& law, double yield, const Flux& flux,
                    const Sample& at);
    enum class State { plug, sheared, unsure };
    /// From bounds of |F| over the element alone.
    [[nodiscard]] State state(const Flux& flux, double yield) const {
        const double low = std::min(flux[0], flux[1]) + std::min(flux[2], 0.0);
        const double high = std::max(flux[0], flux[1]) + std::max(flux[2], 0.0);
        const double margin = 0.5 * reach_ * (high - low);
        if (low - margin > yield * largest_a_ || high + margin < -yield * largest_a_) {
            return State::sheared;
        }
        const bool plug = high < yield * smallest_a_ && low > -yield * smallest_a_;
        return plug ? State::plug : State::unsure;
    }
    /// Places where |F| = yield a, increasing, in (-1, 1) and `reach_` beyond on both sides; the
    /// result is how many there are.
    [[nodiscard]] int crossings(const Flux& flux, double yield, std::array<double, 4>& cuts) const;

    double middle_{};
    double half_{};
    bool planar_{};
    double smallest_a_{};
    double largest_a_{};
    std::array<double, 3> mass_{};
    std::array<double, 3> inverse_mass_{};
    int count_ = few_points;
    /// Where the rate starts like a root or a low power at the yield stress, xi = cut +- length
    /// s^start_power_ makes it smooth.
    int start_power_ = 1;
    double reach_{}; ///< how far outside such a start is felt by the Gauss rule
    std::array<Sample, many_points> samples_{};
};

template <class Law>
void GapElement::add(Integrals& sum, const Law& law, double yield, const Flux& flux,
                     const Sample& at) {
    const double stress = value(flux, at) * at.inverse_a;
    const double excess = std::abs(stress) - yield;
    if (!(excess > 0.0)) {
        return;
    }
    const Compliance response = compliance(law, excess);
    const double rate = std::copysign(at.weight * response.rate, stress);
    const double slope = at.weight * response.slope * at.inverse_a;
    const auto& g = at.shape;
    for (std::size_t i = 0; i < 3; ++i) {
        sum.residual[i] += rate * g[i];
    }
    sum.tangent[0] += slope * g[0] * g[0];
    sum.tangent[1] += slope * g[0] * g[1];
    sum.tangent[2] += slope * g[1] * g[1];
    sum.tangent[3] += slope * g[0] * g[2];
    sum.tangent[4] += slope * g[1] * g[2];
    sum.tangent[5] += slope * g[2] * g[2];
}

template <class Law>
GapElement::Integrals GapElement::integrals(const Law& law, const Flux& flux) const {
    Integrals sum;
    const double yield = law.yield_stress_value();
    const State known = smooth_through_rest<Law> ? State::sheared : state(flux, yield);
    if (known == State::plug) {
        return sum;
    }
    std::array<double, 4> cuts{};
    const int count = known == State::unsure ? crossings(flux, yield, cuts) : 0;
    if (count == 0) {
        for (int k = 0; k < count_; ++k) {
            add(sum, law, yield, flux, samples_[static_cast<std::size_t>(k)]);
        }
        return sum;
    }
    // Over [from, to], away from a crossing at `cut` on the side of `from`.
    const auto& rule = gauss_rule<many_points>();
    const auto add_from_cut = [&](double cut, double from, double to) {
        const double length = to - cut;
        const double power = start_power_;
        const double first = from == cut ? 0.0 : std::pow((from - cut) / length, 1.0 / power);
        const double span = 1.0 - first;
        for (std::size_t k = 0; k < rule.node.size(); ++k) {
            const double s = first + 0.5 * span * (1.0 + rule.node[k]);
            const double before = start_power_ == 1 ? 1.0 : start_power_ == 2 ? s : s * s * s;
            const double weight = 0.5 * rule.weight[k] * span * power * before * std::abs(length);
            add(sum, law, yield, flux, sample_at(cut + length * before * s, weight));
        }
    };
    const auto cut = [&](int k) { return cuts[static_cast<std::size_t>(k)]; };
    for (int k = 0; k <= count; ++k) {
        const double left = k > 0 ? std::max(-1.0, cut(k - 1)) : -1.0;
        const double right = k < count ? std::min(1.0, cut(k)) : 1.0;
        if (left >= right) {
            continue;
        }
        if (k > 0 && k < count) {
            const double half_way = 0.5 * (left + right);
            add_from_cut(cut(k - 1), left, half_way);
            add_from_cut(cut(k), right, half_way);
        } else if (k > 0) {
            add_from_cut(cut(k - 1), left, right);
        } else {
            add_from_cut(cut(k), right, left);
        }
    }
    return sum;
}

} // namespace searle::solvers::radial
