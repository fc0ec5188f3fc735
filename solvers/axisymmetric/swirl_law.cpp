#include "solvers/axisymmetric/swirl_law.hpp"

#include "solvers/radial/gauss_rule.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace searle::solvers::axisymmetric {
namespace {

namespace flow = laws::flow;

/// The table's rates: from first_rate times the speed, evenly in the logarithm.
constexpr double first_rate = 1e-9;
constexpr double log_spacing = 0.25;
constexpr int table_size = 140;

/// Integral of the excess stress over the rate, Pa/s, in closed form; negative where there is none.
template <class Law>
double closed_form(const Law& law, double rate) {
    if constexpr (std::is_same_v<Law, flow::Casson>) {
        return rate * (law.excess_stress(rate) / 2.0 +
                       std::sqrt(law.yield_stress * law.plastic_viscosity * rate) / 3.0);
    } else if constexpr (std::is_same_v<Law, flow::HerschelBulkley> ||
                         std::is_same_v<Law, flow::PowerLaw>) {
        return rate * law.excess_stress(rate) / (1.0 + law.flow_index);
    } else if constexpr (std::is_same_v<Law, flow::Newtonian> ||
                         std::is_same_v<Law, flow::Bingham>) {
        return rate * law.excess_stress(rate) / 2.0;
    } else {
        return -1.0;
    }
}

/// Integral of stress d(rate) between two rates whose logarithms differ by at most log_spacing.
template <class Law>
double piece(const Law& law, double log_from, double log_to) {
    const auto& rule = radial::gauss_rule<5>();
    double sum = 0.0;
    for (std::size_t k = 0; k < rule.node.size(); ++k) {
        const double rate =
            std::exp(0.5 * (log_from + log_to) + 0.5 * (log_to - log_from) * rule.node[k]);
        sum += rule.weight[k] * law.excess_stress(rate) * rate;
    }
    return 0.5 * (log_to - log_from) * sum;
}

} // namespace

SwirlLaw::SwirlLaw(const flow::AnyFlowLaw& law, double speed, double rate_scale)
    : law_(law), speed_(speed), stress_scale_(flow::stress(law, speed * rate_scale)) {
    tabulate();
}

double SwirlLaw::yield_stress() const { return flow::yield_stress(law_) / stress_scale_; }

double SwirlLaw::homogeneity() const {
    if (std::holds_alternative<flow::Newtonian>(law_)) {
        return 2.0;
    }
    if (const auto* power = std::get_if<flow::PowerLaw>(&law_)) {
        return 1.0 + power->flow_index;
    }
    return 0.0;
}

void SwirlLaw::tabulate() {
    std::visit(
        [&](const auto& law) {
            if (closed_form(law, speed_) >= 0.0) {
                return;
            }
            const double log_first = std::log(first_rate * speed_);
            const double first = std::exp(log_first);
            table_.push_back(first * law.excess_stress(first) / (1.0 + law.log_slope(first)));
            for (int k = 1; k < table_size; ++k) {
                const double from = log_first + (k - 1) * log_spacing;
                table_.push_back(table_.back() + piece(law, from, from + log_spacing));
            }
        },
        law_);
}

double SwirlLaw::excess_potential(double rate) const {
    if (!(rate > 0.0)) {
        return 0.0;
    }
    return std::visit(
        [&](const auto& law) {
            const double closed = closed_form(law, rate);
            if (closed >= 0.0) {
                return closed;
            }
            const double steps = std::log(rate / (first_rate * speed_)) / log_spacing;
            if (steps <= 0.0) {
                return rate * law.excess_stress(rate) / (1.0 + law.log_slope(rate));
            }
            const int whole = std::min(static_cast<int>(steps), table_size - 1);
            double from = std::log(first_rate * speed_) + whole * log_spacing;
            double sum = table_[static_cast<std::size_t>(whole)];
            const double to = std::log(rate);
            while (to > from + log_spacing) {
                sum += piece(law, from, from + log_spacing);
                from += log_spacing;
            }
            return sum + piece(law, from, to);
        },
        law_);
}

Eigen::ArrayXXd SwirlLaw::potential(const Eigen::ArrayXXd& rate) const {
    const double yield = flow::yield_stress(law_);
    return rate.unaryExpr([&](double scaled) {
        return yield * scaled / stress_scale_ +
               excess_potential(scaled * speed_) / (stress_scale_ * speed_);
    });
}

Eigen::ArrayXXd SwirlLaw::conjugate(const Eigen::ArrayXXd& stress) const {
    return std::visit(
        [&](const auto& law) -> Eigen::ArrayXXd {
            return stress.unaryExpr([&](double scaled) {
                const double excess = scaled * stress_scale_ - law.yield_stress_value();
                if (!(excess > 0.0)) {
                    return 0.0;
                }
                const double rate = law.rate_at_excess(excess);
                return (excess * rate - excess_potential(rate)) / (stress_scale_ * speed_);
            });
        },
        law_);
}

Eigen::ArrayXXd SwirlLaw::stress(const Eigen::ArrayXXd& rate) const {
    return std::visit(
        [&](const auto& law) -> Eigen::ArrayXXd {
            return rate.unaryExpr([&](double scaled) {
                return scaled > 0.0 ? double{law.stress(scaled * speed_)} / stress_scale_ : 0.0;
            });
        },
        law_);
}

void SwirlLaw::RoundedPotential::slopes(const Eigen::ArrayXd& rate, Eigen::ArrayXd& secant,
                                        Eigen::ArrayXd& tangent) const {
    const double speed = law_.speed_;
    const double scale = law_.stress_scale_;
    std::visit(
        [&](const auto& law) {
            for (Eigen::Index q = 0; q < rate.size(); ++q) {
                const double square = rate[q] * rate[q] + rounding_ * rounding_;
                const double rounded = std::sqrt(square);
                const double stress = law.stress(rounded * speed) / scale;
                const double share = rate[q] * rate[q] / square;
                secant[q] = stress / rounded;
                tangent[q] = secant[q] * (share * law.log_slope(rounded * speed) + 1.0 - share);
            }
        },
        law_.law_);
}

void SwirlLaw::SoftenedConjugate::slopes(const Eigen::ArrayXd& stress, Eigen::ArrayXd& secant,
                                         Eigen::ArrayXd& tangent) const {
    const double speed = law_.speed_;
    const double scale = law_.stress_scale_;
    std::visit(
        [&](const auto& law) {
            const double yield = law.yield_stress_value();
            for (Eigen::Index q = 0; q < stress.size(); ++q) {
                const double square = stress[q] * stress[q] + rounding_ * rounding_;
                const double rounded = std::sqrt(square);
                const double excess = rounded * scale - yield;
                double compliance = 0.0;
                double slope = 0.0;
                if (excess > 0.0) {
                    const double rate = law.rate_at_excess(excess);
                    if (rate > 0.0) {
                        compliance = rate / (speed * rounded);
                        slope = compliance / law.log_slope(rate);
                    }
                }
                const double share = stress[q] * stress[q] / square;
                secant[q] = compliance + softening_;
                tangent[q] = slope * share + compliance * (1.0 - share) + softening_;
            }
        },
        law_.law_);
}

} // namespace searle::solvers::axisymmetric
