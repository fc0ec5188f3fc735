#include "solvers/axisymmetric/swirl_level.hpp"

#include "solvers/axisymmetric/field_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::solvers::axisymmetric {
namespace {

constexpr int most_newton_steps = 60;

/// g and |g| of a field at all points.
struct Gradient {
    Eigen::ArrayXXd r;
    Eigen::ArrayXXd z;
    Eigen::ArrayXXd size;
};

Gradient gradient(const SectionSpace& space, const Eigen::VectorXd& values) {
    const auto& elements = space.elements();
    const auto count = static_cast<Eigen::Index>(elements.size());
    const Eigen::Index points = elements.front().weight.size();
    Gradient g{Eigen::ArrayXXd(points, count), Eigen::ArrayXXd(points, count), {}};
    Eigen::VectorXd local(elements.front().slope.cols());
    for (Eigen::Index e = 0; e < count; ++e) {
        const auto& element = elements[static_cast<std::size_t>(e)];
        for (Eigen::Index k = 0; k < local.size(); ++k) {
            local[k] = values[element.node[static_cast<std::size_t>(k)]];
        }
        const Eigen::VectorXd both = element.slope * local;
        g.r.col(e) = both.head(points).array();
        g.z.col(e) = both.tail(points).array();
    }
    g.size = (g.r.square() + g.z.square()).sqrt();
    return g;
}

Eigen::ArrayXXd weights(const SectionSpace& space) {
    const auto& elements = space.elements();
    Eigen::ArrayXXd weight(elements.front().weight.size(),
                           static_cast<Eigen::Index>(elements.size()));
    for (std::size_t e = 0; e < elements.size(); ++e) {
        weight.col(static_cast<Eigen::Index>(e)) = elements[e].weight;
    }
    return weight;
}

/// Bounds of the torque M = dP/d(speed) from the bounds P >= P_min >= D: the field of this speed,
/// scaled, is admissible at other speeds, and P_min is convex in the speed.
void bracket(const SwirlLaw& law, const Eigen::ArrayXXd& weight, const Eigen::ArrayXXd& rate,
             SwirlEnergies& energies) {
    const double power = law.homogeneity();
    if (power > 0.0) {
        energies.upper = power * energies.potential;
        energies.lower = power * energies.conjugate;
        return;
    }
    const auto scaled = [&](double factor) {
        return (weight * law.potential(factor * rate)).sum();
    };
    const double gap = std::max(energies.potential - energies.conjugate,
                                std::numeric_limits<double>::epsilon() * energies.potential);
    constexpr double probe = 0.02;
    const double bend =
        (scaled(1.0 + probe) - 2.0 * energies.potential + scaled(1.0 - probe)) / (probe * probe);
    const double best = std::sqrt(2.0 * gap / std::max(bend, 1e-6 * energies.potential));
    energies.upper = std::numeric_limits<double>::infinity();
    energies.lower = 0.0;
    for (const double factor : {0.75, 1.0, 1.3}) {
        const double h = std::min(factor * best, 0.5);
        energies.upper = std::min(energies.upper, (scaled(1.0 + h) - energies.conjugate) / h);
        energies.lower = std::max(energies.lower, (energies.conjugate - scaled(1.0 - h)) / h);
    }
}

/// The largest flux a - sum Phi*(a |stress|) of a few shares a <= 1: near the plastic limit a
/// stress that is a little too large somewhere costs more than a smaller stress everywhere.
double best_conjugate(const SwirlLaw& law, const Eigen::ArrayXXd& weight,
                      const Eigen::ArrayXXd& stress, double flux) {
    double best = flux - (weight * law.conjugate(stress)).sum();
    if (law.yield_stress() == 0.0) {
        return best;
    }
    for (double less = 1e-6; less < 0.1; less *= 2.0) {
        const double share = 1.0 - less;
        const double found = share * flux - (weight * law.conjugate(share * stress)).sum();
        if (found < best && less > 1e-3) {
            break;
        }
        best = std::max(best, found);
    }
    return best;
}

} // namespace

SwirlLevel::SwirlLevel(const SectionShape& shape, SectionLines lines, int degree, int points)
    : lines_(std::move(lines)), mesh_(section_of(shape, lines_)), points_(points),
      rotation_space_(mesh_, Field::rotation, degree, points),
      stress_space_(mesh_, Field::stress_function, degree, points),
      rotation_minimiser_(rotation_space_), stress_minimiser_(stress_space_),
      rotation_(rotation_space_.prescribed()), stress_function_(stress_space_.prescribed()) {}

void SwirlLevel::start_from(const SwirlLevel& coarse) {
    rotation_ = transferred({coarse.lines_, coarse.mesh_, coarse.rotation_space_}, coarse.rotation_,
                            Field::rotation, {lines_, mesh_, rotation_space_});
    stress_function_ =
        transferred({coarse.lines_, coarse.mesh_, coarse.stress_space_}, coarse.stress_function_,
                    Field::stress_function, {lines_, mesh_, stress_space_});
}

bool SwirlLevel::minimise(const SwirlLaw& law, double rounding, double tolerance) {
    // The stress function's own rounding only keeps slopes finite where a shear-thickening fluid is
    // at rest; it is far below the softening.
    constexpr double rounding_of_stress = 1e-3;
    const SwirlLaw::RoundedPotential potential(law, rounding);
    const SwirlLaw::SoftenedConjugate conjugate(law, rounding, rounding_of_stress * rounding);
    const Eigen::VectorXd no_load = Eigen::VectorXd::Zero(rotation_space_.nodes());
    Eigen::VectorXd turning = Eigen::VectorXd::Zero(stress_space_.nodes());
    turning[stress_space_.surface_node()] = 1.0;
    const Minimised above =
        rotation_minimiser_.minimise(potential, no_load, tolerance, most_newton_steps, rotation_);
    const Minimised below = stress_minimiser_.minimise(conjugate, turning, tolerance,
                                                       most_newton_steps, stress_function_);
    steps_ += above.steps + below.steps;
    return above.converged && below.converged;
}

SwirlEnergies SwirlLevel::energies(const SwirlLaw& law, int points) const {
    const auto on = [&](const SectionSpace& rotation, const SectionSpace& stress_function) {
        const Eigen::ArrayXXd weight = weights(rotation);
        const Eigen::ArrayXXd rate = gradient(rotation, rotation_).size;
        const Eigen::ArrayXXd stress = gradient(stress_function, stress_function_).size;
        SwirlEnergies found;
        found.flux = stress_function_[stress_function.surface_node()];
        found.potential = (weight * law.potential(rate)).sum();
        found.conjugate = best_conjugate(law, weight, stress, found.flux);
        found.dissipation = (weight * law.stress(rate) * rate).sum();
        bracket(law, weight, rate, found);
        return found;
    };
    if (points == points_) {
        return on(rotation_space_, stress_space_);
    }
    const int degree = rotation_space_.degree();
    return on(SectionSpace(mesh_, Field::rotation, degree, points),
              SectionSpace(mesh_, Field::stress_function, degree, points));
}

LineMarks SwirlLevel::marks(const SwirlLaw& law, double share) const {
    const Eigen::ArrayXXd weight = weights(rotation_space_);
    const Gradient rate = gradient(rotation_space_, rotation_);
    const Gradient curl = gradient(stress_space_, stress_function_);
    // The stress is the curl of psi: (-d/dz, d/dr) psi / r^2 with the sign that resists.
    const Eigen::ArrayXXd excess = weight * (law.potential(rate.size) + law.conjugate(curl.size) -
                                             (rate.z * curl.r - rate.r * curl.z).abs());
    std::array<std::vector<double>, line_families> part;
    for (std::size_t family = 0; family < line_families; ++family) {
        part[family].assign(lines_[family].empty() ? 0 : lines_[family].size() - 1, 0.0);
    }
    double total = 0.0;
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
        const auto column = static_cast<Eigen::Index>(e);
        const double gap = std::max(0.0, excess.col(column).sum());
        // The direction in which the rate varies more is the one to divide.
        const Eigen::Map<const Eigen::ArrayXXd> table(rate.size.col(column).data(), points_,
                                                      points_);
        const double along_r = (table.rowwise() - table.colwise().mean()).square().sum();
        const double along_z = (table.colwise() - table.rowwise().mean()).square().sum();
        const double radial =
            along_r / std::max(along_r + along_z, std::numeric_limits<double>::min());
        const SectionElement& shape = mesh_.elements[e];
        part[shape.family[0]][shape.interval[0]] += gap * radial;
        part[shape.family[1]][shape.interval[1]] += gap * (1.0 - radial);
        total += gap;
    }
    std::vector<double> sorted;
    for (const auto& family : part) {
        sorted.insert(sorted.end(), family.begin(), family.end());
    }
    std::sort(sorted.rbegin(), sorted.rend());
    double sum = 0.0;
    double least = 0.0;
    for (const double each : sorted) {
        least = each;
        sum += each;
        if (sum >= share * total) {
            break;
        }
    }
    LineMarks marks;
    for (std::size_t family = 0; family < line_families; ++family) {
        for (const double each : part[family]) {
            marks[family].push_back(each > 0.0 && each >= least);
        }
    }
    return marks;
}

long SwirlLevel::unknowns() const { return rotation_space_.unknowns() + stress_space_.unknowns(); }

} // namespace searle::solvers::axisymmetric
