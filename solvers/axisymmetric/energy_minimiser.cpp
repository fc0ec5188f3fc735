#include "solvers/axisymmetric/energy_minimiser.hpp"

#include "solvers/axisymmetric/newton_flux.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <vector>

namespace searle::solvers::axisymmetric {
namespace {

constexpr int most_search_steps = 40;
/// The line search ends where the slope has fallen to this share of its value at the start.
constexpr double slope_share = 0.1;

using Index = Eigen::Index;

struct Along {
    double work; ///< sum of |g| F'
    double slope;
};

} // namespace

struct EnergyMinimiser::Work {
    Eigen::SparseMatrix<double> matrix; ///< lower triangle of the shared unknowns
    /// For each element the positions of its entries in the matrix's values, column by column of
    /// its outline's square, -1 for the upper triangle and for prescribed nodes.
    std::vector<std::vector<int>> position;
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factor;
    std::vector<Eigen::LLT<Eigen::MatrixXd>> inside;
    std::vector<Eigen::MatrixXd> coupling; ///< (inside, outline)
    std::vector<Eigen::VectorXd> inside_residual;
    std::vector<Eigen::MatrixXd> mass; ///< of each element, where an InertiaTerm asked for them

    explicit Work(const SectionSpace& space);
    bool newton_step(const SectionSpace& space, const EnergyDensity& density,
                     const Eigen::MatrixXd& g, const Eigen::MatrixXd& flux,
                     const Eigen::VectorXd& load, const Eigen::VectorXd& values,
                     const InertiaTerm* inertia, Eigen::VectorXd& step);
};

EnergyMinimiser::Work::Work(const SectionSpace& space) {
    const auto& elements = space.elements();
    const auto outline = static_cast<std::size_t>(space.outline_nodes());
    std::vector<Eigen::Triplet<double>> entries;
    const auto unknown = [&](const SectionSpace::Element& element, std::size_t local) {
        return space.shared_unknown()[static_cast<std::size_t>(element.node[local])];
    };
    for (const auto& element : elements) {
        for (std::size_t j = 0; j < outline; ++j) {
            for (std::size_t i = 0; i < outline; ++i) {
                const int row = unknown(element, i);
                const int column = unknown(element, j);
                if (column >= 0 && row >= column) {
                    entries.emplace_back(row, column, 0.0);
                }
            }
        }
    }
    const Index size = space.shared_unknowns();
    matrix.resize(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    factor.analyzePattern(matrix);
    position.resize(elements.size());
    for (std::size_t e = 0; e < elements.size(); ++e) {
        position[e].assign(outline * outline, -1);
        for (std::size_t j = 0; j < outline; ++j) {
            for (std::size_t i = 0; i < outline; ++i) {
                const int row = unknown(elements[e], i);
                const int column = unknown(elements[e], j);
                if (column >= 0 && row >= column) {
                    const int* first = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column];
                    const int* last = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column + 1];
                    position[e][j * outline + i] = static_cast<int>(
                        std::lower_bound(first, last, row) - matrix.innerIndexPtr());
                }
            }
        }
    }
    inside.resize(elements.size());
    coupling.resize(elements.size());
    inside_residual.resize(elements.size());
}

bool EnergyMinimiser::Work::newton_step(const SectionSpace& space, const EnergyDensity& density,
                                        const Eigen::MatrixXd& g, const Eigen::MatrixXd& flux,
                                        const Eigen::VectorXd& load, const Eigen::VectorXd& values,
                                        const InertiaTerm* inertia, Eigen::VectorXd& step) {
    const auto& elements = space.elements();
    const Index points = g.rows() / 2;
    const Index locals = elements.front().slope.cols();
    const Index outline = space.outline_nodes();
    const Index inner = locals - outline;
    Eigen::VectorXd residual = Eigen::VectorXd::Zero(space.shared_unknowns());
    std::fill_n(matrix.valuePtr(), matrix.nonZeros(), 0.0);
    Eigen::ArrayXd size(points);
    Eigen::ArrayXd secant(points);
    Eigen::ArrayXd tangent(points);
    Eigen::MatrixXd weighted(2 * points, locals);
    Eigen::MatrixXd hessian(locals, locals);
    Eigen::VectorXd force(2 * points);
    Eigen::VectorXd local(locals);
    Eigen::VectorXd away(locals);
    // A load on a shared node counts once, not once for each element around it.
    for (std::size_t node = 0; node < space.shared_unknown().size(); ++node) {
        if (space.shared_unknown()[node] >= 0) {
            residual[space.shared_unknown()[node]] += load[static_cast<Index>(node)];
        }
    }
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const auto& element = elements[e];
        const auto along_r = g.col(static_cast<Index>(e)).head(points).array();
        const auto along_z = g.col(static_cast<Index>(e)).tail(points).array();
        size = (along_r.square() + along_z.square()).sqrt();
        density.slopes(size, secant, tangent);
        const Eigen::ArrayXd even = element.weight * secant;
        // The part of the tangent along g beyond the even part, with one of the two g replaced by
        // the flux that belongs to it (see next_flux).
        const Eigen::ArrayXd extra =
            (size > 0.0)
                .select(element.weight * (tangent - secant) / (secant * size.square()), 0.0);
        const auto flux_r = flux.col(static_cast<Index>(e)).head(points).array();
        const auto flux_z = flux.col(static_cast<Index>(e)).tail(points).array();
        const Eigen::ArrayXd rr = even + extra * along_r * flux_r;
        const Eigen::ArrayXd rz = 0.5 * extra * (along_r * flux_z + along_z * flux_r);
        const Eigen::ArrayXd zz = even + extra * along_z * flux_z;
        const auto slope_r = element.slope.topRows(points);
        const auto slope_z = element.slope.bottomRows(points);
        weighted.topRows(points) = rr.matrix().asDiagonal() * slope_r;
        weighted.topRows(points) += rz.matrix().asDiagonal() * slope_z;
        weighted.bottomRows(points) = rz.matrix().asDiagonal() * slope_r;
        weighted.bottomRows(points) += zz.matrix().asDiagonal() * slope_z;
        hessian.noalias() = element.slope.transpose() * weighted;
        force << (even * along_r).matrix(), (even * along_z).matrix();
        local.noalias() = -element.slope.transpose() * force;
        if (inertia != nullptr) {
            hessian += inertia->factor * mass[e];
            for (Index k = 0; k < locals; ++k) {
                const int node = element.node[static_cast<std::size_t>(k)];
                away[k] = values[node] - inertia->centre[node];
            }
            local.noalias() -= inertia->factor * (mass[e] * away);
        }
        for (Index k = 0; k < inner; ++k) {
            local[outline + k] += load[element.node[static_cast<std::size_t>(outline + k)]];
        }
        inside[e].compute(hessian.bottomRightCorner(inner, inner));
        if (inside[e].info() != Eigen::Success) {
            return false;
        }
        coupling[e] = inside[e].solve(hessian.bottomLeftCorner(inner, outline));
        inside_residual[e] = inside[e].solve(local.tail(inner));
        Eigen::MatrixXd reduced = hessian.topLeftCorner(outline, outline);
        reduced.noalias() -= hessian.topRightCorner(outline, inner) * coupling[e];
        const Eigen::VectorXd reduced_residual =
            local.head(outline) - hessian.topRightCorner(outline, inner) * inside_residual[e];
        for (Index j = 0; j < outline; ++j) {
            const int column = space.shared_unknown()[static_cast<std::size_t>(
                element.node[static_cast<std::size_t>(j)])];
            if (column < 0) {
                continue;
            }
            residual[column] += reduced_residual[j];
            for (Index i = 0; i < outline; ++i) {
                const int at = position[e][static_cast<std::size_t>(j * outline + i)];
                if (at >= 0) {
                    matrix.valuePtr()[at] += reduced(i, j);
                }
            }
        }
    }
    factor.factorize(matrix);
    if (factor.info() != Eigen::Success) {
        return false;
    }
    const Eigen::VectorXd shared = factor.solve(residual);
    step.setZero(space.nodes());
    for (std::size_t node = 0; node < space.shared_unknown().size(); ++node) {
        const int unknown = space.shared_unknown()[node];
        if (unknown >= 0) {
            step[static_cast<Index>(node)] = shared[unknown];
        }
    }
    Eigen::VectorXd around(outline);
    for (std::size_t e = 0; e < elements.size() && inner > 0; ++e) {
        for (Index k = 0; k < outline; ++k) {
            around[k] = step[elements[e].node[static_cast<std::size_t>(k)]];
        }
        step.segment(elements[e].node[static_cast<std::size_t>(outline)], inner) =
            inside_residual[e] - coupling[e] * around;
    }
    return true;
}

EnergyMinimiser::EnergyMinimiser(const SectionSpace& space)
    : space_(space), work_(std::make_unique<Work>(space)) {}

EnergyMinimiser::~EnergyMinimiser() = default;

void EnergyMinimiser::prepare_masses() {
    if (!work_->mass.empty()) {
        return;
    }
    for (const auto& element : space_.elements()) {
        const Eigen::ArrayXd weight = element.weight * element.radius.square();
        work_->mass.emplace_back(space_.values().transpose() * weight.matrix().asDiagonal() *
                                 space_.values());
    }
}

double EnergyMinimiser::inertia_product(const Eigen::VectorXd& one, const Eigen::VectorXd& other) {
    prepare_masses();
    const auto& elements = space_.elements();
    Eigen::VectorXd left(elements.front().slope.cols());
    Eigen::VectorXd right(left.size());
    double sum = 0.0;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        for (Index k = 0; k < left.size(); ++k) {
            const int node = elements[e].node[static_cast<std::size_t>(k)];
            left[k] = one[node];
            right[k] = other[node];
        }
        sum += left.dot(work_->mass[e] * right);
    }
    return sum;
}

double EnergyMinimiser::work_along(const EnergyDensity& density, const Eigen::VectorXd& values,
                                   const Eigen::VectorXd& test) const {
    const Eigen::MatrixXd g = gradients(space_, values);
    const Eigen::MatrixXd along = gradients(space_, test);
    const Index points = g.rows() / 2;
    Eigen::ArrayXd secant(points);
    Eigen::ArrayXd tangent(points);
    double sum = 0.0;
    for (Index e = 0; e < g.cols(); ++e) {
        const auto r = g.col(e).head(points).array();
        const auto z = g.col(e).tail(points).array();
        density.slopes((r.square() + z.square()).sqrt(), secant, tangent);
        sum += (space_.elements()[static_cast<std::size_t>(e)].weight * secant *
                (r * along.col(e).head(points).array() + z * along.col(e).tail(points).array()))
                   .sum();
    }
    return sum;
}

Minimised EnergyMinimiser::minimise(const EnergyDensity& density, const Eigen::VectorXd& load,
                                    double tolerance, int most_steps, Eigen::VectorXd& values,
                                    const InertiaTerm* inertia) {
    if (inertia != nullptr) {
        prepare_masses();
    }
    const auto& elements = space_.elements();
    const Index points = elements.front().slope.rows() / 2;
    Eigen::MatrixXd g = gradients(space_, values);
    Eigen::MatrixXd change;
    Eigen::VectorXd step;
    Eigen::ArrayXd size(points);
    Eigen::ArrayXd secant(points);
    Eigen::ArrayXd tangent(points);
    // Of the InertiaTerm: its work, its slope at the start of a step and what that grows by.
    double inertia_work = 0.0;
    double inertia_slope = 0.0;
    double inertia_bend = 0.0;
    const auto along = [&](double length, double load_step) {
        Along sum{inertia_work, inertia_slope + length * inertia_bend - load_step};
        for (std::size_t e = 0; e < elements.size(); ++e) {
            const auto column = static_cast<Index>(e);
            const Eigen::ArrayXd at = (g.col(column) + length * change.col(column)).array();
            const auto at_r = at.head(points);
            const auto at_z = at.tail(points);
            size = (at_r.square() + at_z.square()).sqrt();
            density.slopes(size, secant, tangent);
            const Eigen::ArrayXd slopes = elements[e].weight * secant *
                                          (at_r * change.col(column).head(points).array() +
                                           at_z * change.col(column).tail(points).array());
            sum.work += (elements[e].weight * secant * size.square()).sum();
            sum.slope += slopes.sum();
        }
        return sum;
    };

    const Eigen::MatrixXd still = Eigen::MatrixXd::Zero(g.rows(), g.cols());
    Eigen::MatrixXd flux = next_flux(density, g, still, still, g);
    Minimised result;
    for (result.steps = 0; result.steps < most_steps;) {
        if (!work_->newton_step(space_, density, g, flux, load, values, inertia, step)) {
            return result;
        }
        ++result.steps;
        change = gradients(space_, step);
        const double load_step = load.dot(step);
        if (inertia != nullptr) {
            const Eigen::VectorXd away = values - inertia->centre;
            inertia_work = inertia->factor * inertia_product(away, away);
            inertia_slope = inertia->factor * inertia_product(away, step);
            inertia_bend = inertia->factor * inertia_product(step, step);
        }
        const Along start = along(0.0, load_step);
        if (!std::isfinite(start.slope)) {
            return result;
        }
        result.decrement = start.work > 0.0 ? -0.5 * start.slope / start.work : 1.0;
        // The slope along the step rises from a negative value: its root is the best length.
        double low = 0.0;
        double low_slope = start.slope;
        double high = 0.0;
        double high_slope = 0.0;
        double length = 1.0;
        bool quadratic = false;
        for (int search = 0; search < most_search_steps; ++search) {
            const Along here = along(length, load_step);
            quadratic = length == 1.0 && std::abs(here.slope) <= 1e-10 * std::abs(start.slope);
            if (std::abs(here.slope) <= slope_share * std::abs(start.slope)) {
                break;
            }
            if (here.slope < 0.0) {
                low = length;
                low_slope = here.slope;
            } else {
                high = length;
                high_slope = here.slope;
            }
            if (high == 0.0) {
                if (length >= 1.0) {
                    // Longer than Newton's own step only where the energy bends away from it.
                    if (length >= 8.0) {
                        break;
                    }
                    length *= 2.0;
                }
                continue;
            }
            const double secant_length = low - low_slope * (high - low) / (high_slope - low_slope);
            const double margin = 0.1 * (high - low);
            length = std::clamp(secant_length, low + margin, high - margin);
        }
        values += length * step;
        if (quadratic || result.decrement <= tolerance) {
            result.converged = true;
            return result;
        }
        const Eigen::MatrixXd g_next = g + length * change;
        flux = next_flux(density, g, change, flux, g_next);
        g = g_next;
    }
    return result;
}

} // namespace searle::solvers::axisymmetric
