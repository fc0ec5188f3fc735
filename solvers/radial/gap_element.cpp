#include "solvers/radial/gap_element.hpp"

namespace searle::solvers::radial {
namespace {

/// A root this far outside of [-1, 1] changes five Gauss points' sum by 1e-10 of it.
constexpr double farthest_felt = 4.0;

} // namespace

GapElement::GapElement(const GapShape& shape, double left, double right, double exponent)
    : middle_(0.5 * (left + right)), half_(0.5 * (right - left)), planar_(shape.planar),
      smallest_a_(planar_ ? 1.0 : left * left), largest_a_(planar_ ? 1.0 : right * right),
      start_power_(exponent < 1.0   ? 4
                   : exponent < 2.0 ? 2
                                    : 1),
      reach_(exponent < 2.0 && exponent != 1.0 ? farthest_felt : 0.0) {
    const auto prepare = [&](const auto& rule) {
        for (std::size_t k = 0; k < rule.node.size(); ++k) {
            const double xi = rule.node[k];
            samples_[k] = sample_at(xi, rule.weight[k]);
            const double x = middle_ + half_ * xi;
            const double mass =
                shape.density * rule.weight[k] * half_ * (planar_ ? 1.0 : x * x * x);
            mass_[0] += mass;
            mass_[1] += mass * xi;
            mass_[2] += mass * xi * xi;
        }
        count_ = static_cast<int>(rule.node.size());
    };
    if (exponent <= 4.0) {
        prepare(gauss_rule<few_points>());
    } else {
        prepare(gauss_rule<many_points>());
    }
    const double determinant = mass_[0] * mass_[2] - mass_[1] * mass_[1];
    inverse_mass_ = {mass_[2] / determinant, -mass_[1] / determinant, mass_[0] / determinant};
}

void GapElement::add_compliance(double compliance, const Flux& flux, const Flux& from,
                                Integrals& sum) const {
    // integral of G_i G_j over xi: entries 00, 01, 11, 0b, 1b, bb.
    constexpr std::array<double, 6> product{2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0,
                                            2.0 / 3.0, 2.0 / 3.0, 16.0 / 15.0};
    const double scale = compliance * half_;
    const Flux moved{flux[0] - from[0], flux[1] - from[1], flux[2] - from[2]};
    for (std::size_t k = 0; k < product.size(); ++k) {
        sum.tangent[k] += scale * product[k];
    }
    sum.residual[0] +=
        scale * (product[0] * moved[0] + product[1] * moved[1] + product[3] * moved[2]);
    sum.residual[1] +=
        scale * (product[1] * moved[0] + product[2] * moved[1] + product[4] * moved[2]);
    sum.residual[2] +=
        scale * (product[3] * moved[0] + product[4] * moved[1] + product[5] * moved[2]);
}

int GapElement::crossings(const Flux& flux, double yield, std::array<double, 4>& cuts) const {
    int count = 0;
    // F - sign yield a as a polynomial c0 + c1 xi + c2 xi^2.
    const double a0 = planar_ ? 1.0 : middle_ * middle_;
    const double a1 = planar_ ? 0.0 : 2.0 * middle_ * half_;
    const double a2 = planar_ ? 0.0 : half_ * half_;
    const auto keep = [&](double xi) {
        if (xi > -1.0 - reach_ && xi < 1.0 + reach_) {
            int place = count++;
            for (; place > 0 && cuts[static_cast<std::size_t>(place - 1)] > xi; --place) {
                cuts[static_cast<std::size_t>(place)] = cuts[static_cast<std::size_t>(place - 1)];
            }
            cuts[static_cast<std::size_t>(place)] = xi;
        }
    };
    for (const double sign : {-1.0, 1.0}) {
        const double c0 = 0.5 * (flux[0] + flux[1]) + flux[2] - sign * yield * a0;
        const double c1 = 0.5 * (flux[1] - flux[0]) - sign * yield * a1;
        const double c2 = -flux[2] - sign * yield * a2;
        const double discriminant = c1 * c1 - 4.0 * c2 * c0;
        if (discriminant >= 0.0) {
            const double q = -0.5 * (c1 + std::copysign(std::sqrt(discriminant), c1));
            if (q != 0.0) {
                keep(c0 / q);
            }
            if (c2 != 0.0 && q / c2 != c0 / q) {
                keep(q / c2);
            }
        }
        if (yield == 0.0) {
            break;
        }
    }
    return count;
}

} // namespace searle::solvers::radial
