#include "solvers/axisymmetric/swirl_response.hpp"

#include "solvers/axisymmetric/section_space.hpp"
#include "solvers/axisymmetric/swirl_fields.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace searle::solvers::axisymmetric {
namespace {

using Index = Eigen::Index;
using Sparse = Eigen::SparseMatrix<double>;

/// Stiffness and mass of the free nodes, and the two vectors that the walls' values bring in.
struct Swirl {
    Sparse stiffness;
    Sparse mass;
    Eigen::VectorXd wall_force;    ///< stiffness between free nodes and the walls' values
    Eigen::VectorXd wall_momentum; ///< mass between free nodes and the walls' values
    double wall_stiffness{};       ///< walls with walls
    double wall_mass{};
};

/// Number of a node's unknown, or -1 where the value is prescribed.
int unknown_of(const SectionSpace& space, int node) {
    return node < space.shared_nodes() ? space.shared_unknown()[static_cast<std::size_t>(node)]
                                       : space.shared_unknowns() + node - space.shared_nodes();
}

Swirl assemble(const SectionSpace& space) {
    const auto unknown = [&](int node) { return unknown_of(space, node); };
    const auto size = static_cast<Index>(space.unknowns());
    Swirl swirl{Sparse(size, size), Sparse(size, size), Eigen::VectorXd::Zero(size),
                Eigen::VectorXd::Zero(size)};
    std::vector<Eigen::Triplet<double>> stiff;
    std::vector<Eigen::Triplet<double>> heavy;
    for (const auto& element : space.elements()) {
        const Index points = element.weight.size();
        const Index locals = element.slope.cols();
        Eigen::ArrayXd twice(2 * points);
        twice << element.weight, element.weight;
        const Eigen::MatrixXd k =
            element.slope.transpose() * twice.matrix().asDiagonal() * element.slope;
        const Eigen::ArrayXd inertia = element.weight * element.radius.square();
        const Eigen::MatrixXd m =
            space.values().transpose() * inertia.matrix().asDiagonal() * space.values();
        for (Index j = 0; j < locals; ++j) {
            const int node_j = element.node[static_cast<std::size_t>(j)];
            const int column = unknown(node_j);
            const double wall = space.prescribed()[node_j];
            for (Index i = 0; i < locals; ++i) {
                const int node_i = element.node[static_cast<std::size_t>(i)];
                const int row = unknown(node_i);
                if (row >= 0 && column >= 0) {
                    if (row >= column) {
                        stiff.emplace_back(row, column, k(i, j));
                    }
                    heavy.emplace_back(row, column, m(i, j));
                } else if (row >= 0) {
                    swirl.wall_force[row] += k(i, j) * wall;
                    swirl.wall_momentum[row] += m(i, j) * wall;
                } else if (column < 0) {
                    const double other = space.prescribed()[node_i];
                    swirl.wall_stiffness += other * wall * k(i, j);
                    swirl.wall_mass += other * wall * m(i, j);
                }
            }
        }
    }
    swirl.stiffness.setFromTriplets(stiff.begin(), stiff.end());
    swirl.mass.setFromTriplets(heavy.begin(), heavy.end());
    return swirl;
}

/// Scale of a row's relative error: its torque, or where that is smaller 1e-3 of the largest.
std::vector<double> scale_of(const std::vector<double>& torque) {
    double largest = 0.0;
    std::vector<double> scale;
    for (const double each : torque) {
        largest = std::max(largest, std::abs(each));
        scale.push_back(std::max(std::abs(each), 1e-3 * largest));
    }
    return scale;
}

} // namespace

SwirlResponse swirl_response(const SectionShape& shape, double viscosity, double density,
                             const ResponseResolution& resolution, SwirlShapes* shapes) {
    const SectionLines lines =
        graded_lines(shape, {.smallest = resolution.smallest, .ratio = 0.15});
    const SectionMesh mesh = section_of(shape, lines);
    const SectionSpace space(mesh, Field::rotation, resolution.degree, resolution.degree + 2);
    const Swirl swirl = assemble(space);
    const Eigen::SimplicialLDLT<Sparse> factor(swirl.stiffness);

    const Eigen::VectorXd steady = factor.solve(-swirl.wall_force);
    const double steady_stiffness = swirl.wall_stiffness + swirl.wall_force.dot(steady);
    const Eigen::VectorXd mass_of_steady = swirl.mass * steady;
    // w = omega W + v with W the steady field: v is driven by the momentum of W alone.
    const Eigen::VectorXd momentum = mass_of_steady + swirl.wall_momentum;
    const double inertia =
        swirl.wall_mass + 2.0 * swirl.wall_momentum.dot(steady) + steady.dot(mass_of_steady);

    // Lanczos for stiffness^-1 mass in the product of the stiffness, from stiffness^-1 momentum:
    // the moments of the slow modes come first. Each vector is kept with its stiffness image.
    const Eigen::VectorXd start = factor.solve(momentum);
    const double start_square = start.dot(momentum);
    std::vector<Eigen::VectorXd> basis{start / std::sqrt(start_square)};
    std::vector<Eigen::VectorXd> image{momentum / std::sqrt(start_square)};
    Eigen::MatrixXd reduced = Eigen::MatrixXd::Zero(resolution.modes, resolution.modes);
    int count = 0;
    for (int j = 0; j < resolution.modes; ++j) {
        Eigen::VectorXd next_image = swirl.mass * basis.back();
        Eigen::VectorXd next = factor.solve(next_image);
        reduced(j, j) = next_image.dot(basis.back());
        count = j + 1;
        // Twice, so that rounding leaves no part along the vectors found before.
        for (int pass = 0; pass < 2; ++pass) {
            for (std::size_t k = 0; k < basis.size(); ++k) {
                const double part = image[k].dot(next);
                next -= part * basis[k];
                next_image -= part * image[k];
            }
        }
        const double square = next.dot(next_image);
        if (j + 1 == resolution.modes || !(square > 1e-28 * reduced(0, 0) * reduced(0, 0))) {
            break;
        }
        const double length = std::sqrt(square);
        reduced(j, j + 1) = reduced(j + 1, j) = length;
        basis.push_back(next / length);
        image.push_back(next_image / length);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(reduced.topLeftCorner(count, count));

    const double torque_scale = 2.0 * std::numbers::pi * viscosity * std::pow(shape.unit(), 3);
    const double diffusion_time = shape.unit() * shape.unit() * density / viscosity;
    SwirlResponse response{.steady = torque_scale * steady_stiffness,
                           .at_once = inertia,
                           .modes = {},
                           .elements = static_cast<int>(mesh.elements.size()),
                           .unknowns = space.unknowns()};
    for (Index k = 0; k < count; ++k) {
        const double time = eigen.eigenvalues()[k];
        const double weight = eigen.eigenvectors()(0, k) * eigen.eigenvectors()(0, k);
        if (!(time > 0.0)) {
            continue;
        }
        // momentum (K + s M)^-1 momentum = sum of start_square weight / (1 + s time).
        const double mode_inertia = start_square * weight / time;
        response.at_once -= mode_inertia;
        response.modes.push_back({.decay = 1.0 / (time * diffusion_time),
                                  .strength = torque_scale * mode_inertia / time});
    }
    response.at_once *= torque_scale * diffusion_time;
    if (shapes != nullptr) {
        // v = sum of b_k (basis u_k) with b_k + time b_k' = -start u_k0 domega/dt.
        Eigen::MatrixXd vectors(space.unknowns(), count);
        for (int k = 0; k < count; ++k) {
            vectors.col(k) = basis[static_cast<std::size_t>(k)];
        }
        const Eigen::MatrixXd along_modes = vectors * eigen.eigenvectors();
        shapes->degree = resolution.degree;
        shapes->steady = space.prescribed();
        shapes->mode = Eigen::MatrixXd::Zero(space.nodes(), count);
        Index used = 0;
        for (Index k = 0; k < count; ++k) {
            const double time = eigen.eigenvalues()[k];
            if (!(time > 0.0)) {
                continue;
            }
            const double amount = -std::sqrt(start_square) * eigen.eigenvectors()(0, k) / time;
            for (int node = 0; node < space.nodes(); ++node) {
                const int row = unknown_of(space, node);
                if (row >= 0) {
                    shapes->steady[node] = steady[row];
                    shapes->mode(node, used) = amount * along_modes(row, k);
                }
            }
            ++used;
        }
        shapes->mode.conservativeResize(space.nodes(), used);
        shapes->mesh = mesh;
    }
    return response;
}

namespace {

/// Calls `use(row, state of the modes, acceleration)` at each row of a history.
template <class Use>
void along_rows(const SwirlResponse& response, const rheometry::SpeedHistory& history,
                const Use& use) {
    std::vector<double> state(response.modes.size(), 0.0);
    double speed = history.initial_speed;
    std::size_t row = 0;
    for (const auto& piece : history.pieces) {
        const double jump = piece.start_speed - speed;
        for (double& each : state) {
            each += jump;
        }
        const double acceleration =
            (piece.end_speed - piece.start_speed) / (piece.end_time - piece.start_time);
        double now = piece.start_time;
        const auto advance = [&](double to) {
            for (std::size_t k = 0; k < state.size(); ++k) {
                const double decay = response.modes[k].decay;
                const double passed = decay * (to - now);
                state[k] =
                    state[k] * std::exp(-passed) - acceleration * std::expm1(-passed) / decay;
            }
            now = to;
        };
        while (row < history.row_times.size() && history.row_times[row] <= piece.end_time) {
            advance(history.row_times[row]);
            use(row, state, acceleration);
            ++row;
        }
        advance(piece.end_time);
        speed = piece.end_speed;
    }
}

} // namespace

std::vector<double> torque_along(const SwirlResponse& response,
                                 const rheometry::SpeedHistory& history) {
    std::vector<double> torque;
    torque.reserve(history.row_times.size());
    along_rows(response, history,
               [&](std::size_t row, const std::vector<double>& state, double acceleration) {
                   double sum = response.steady * history.speed_at(history.row_times[row]) +
                                response.at_once * acceleration;
                   for (std::size_t k = 0; k < state.size(); ++k) {
                       sum += response.modes[k].strength * state[k];
                   }
                   torque.push_back(sum);
               });
    return torque;
}

TransientSwirl transient_swirl(const SectionShape& shape, double viscosity, double density,
                               const rheometry::SpeedHistory& history, double accuracy) {
    constexpr int most_levels = 4;
    // Just after a jump two neighbouring levels miss the same fast modes in part.
    constexpr double safety = 2.0;
    const double digits = std::max(2.0, -std::log10(accuracy));
    ResponseResolution resolution{.degree = 3 + static_cast<int>(std::lround(0.5 * digits)),
                                  .smallest = std::min(0.1, std::pow(20.0 * accuracy, 0.75)),
                                  .modes = 10 + static_cast<int>(std::lround(6.0 * digits))};
    TransientSwirl result;
    std::vector<double> before;
    for (int level = 0; level < most_levels; ++level) {
        const SwirlResponse response = swirl_response(shape, viscosity, density, resolution);
        result.torque = torque_along(response, history);
        result.levels = level + 1;
        result.modes = static_cast<int>(response.modes.size());
        result.elements = response.elements;
        result.resolution = resolution;
        result.unknowns = response.unknowns;
        result.steady = response.steady;
        if (level > 0) {
            const std::vector<double> scale = scale_of(result.torque);
            result.error.clear();
            result.worst_relative_error = 0.0;
            for (std::size_t k = 0; k < scale.size(); ++k) {
                result.error.push_back(safety * std::abs(result.torque[k] - before[k]) +
                                       1e-13 * scale[k]);
                if (scale[k] > 0.0) {
                    result.worst_relative_error =
                        std::max(result.worst_relative_error, result.error.back() / scale[k]);
                }
            }
            result.reached = result.worst_relative_error <= accuracy;
            if (result.reached) {
                break;
            }
        }
        before = result.torque;
        resolution.degree += 1;
        resolution.smallest *= 0.15;
        resolution.modes = 3 * resolution.modes / 2;
    }
    return result;
}

std::vector<rheometry::fields::SectionFields>
transient_fields(const SectionShape& shape, double viscosity, double density,
                 const rheometry::SpeedHistory& history, const ResponseResolution& resolution,
                 std::span<const std::size_t> rows) {
    SwirlShapes shapes;
    const SwirlResponse response = swirl_response(shape, viscosity, density, resolution, &shapes);
    const laws::flow::AnyFlowLaw law = laws::flow::Newtonian{viscosity};
    std::vector<rheometry::fields::SectionFields> sections;
    along_rows(response, history, [&](std::size_t row, const std::vector<double>& state, double) {
        if (!std::binary_search(rows.begin(), rows.end(), row + 1)) {
            return;
        }
        const double time = history.row_times[row];
        const double speed = history.speed_at(time);
        const Eigen::VectorXd rotation =
            speed * shapes.steady +
            shapes.mode *
                Eigen::Map<const Eigen::VectorXd>(state.data(), static_cast<Index>(state.size()));
        // In rad/s, so that a row at rest, where the fluid still turns, needs no other way.
        auto section = swirl_fields(
            {shapes.mesh, shape.unit(), resolution.degree, rotation, 1.0, 0.0, nullptr, 0.0}, law);
        section.speed = speed;
        section.time = time;
        section.row = row + 1;
        sections.push_back(std::move(section));
    });
    return sections;
}

} // namespace searle::solvers::axisymmetric
