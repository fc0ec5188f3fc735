#include "solvers/axisymmetric/swirl_fields.hpp"

#include "solvers/axisymmetric/nodal_basis.hpp"
#include "solvers/axisymmetric/section_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::solvers::axisymmetric {
namespace {

namespace fields = rheometry::fields;
using Index = Eigen::Index;

/// Points in an element along each side, at least: smooth pictures of coarse elements.
constexpr int least_points = 6;
/// Points of a whole section, about; few elements get no more than so many each along a side.
constexpr double points_of_section = 16000.0;
constexpr double most_points = 32.0;
/// Fields are taken this far inside the ends of an element: on the axis the stress is 0 / 0.
constexpr double inset = 1e-7;
/// A rate so small beside the typical one may be an error of the elements, or what is left of the
/// rounding of the yield surface.
constexpr double rate_resolved = 3e-3;

struct Sampled {
    Eigen::MatrixXd value; ///< (point, element); meaningful for the rotation alone
    Eigen::MatrixXd r;     ///< of the gradient g
    Eigen::MatrixXd z;
};

Sampled sampled(const SwirlSolution& solution, Field field, const Eigen::VectorXd& values,
                const LineRule& rule) {
    const SectionSpace space(solution.mesh, field, solution.degree, rule);
    const auto& elements = space.elements();
    const auto count = static_cast<Index>(elements.size());
    const Index points = rule.node.size() * rule.node.size();
    Sampled found{Eigen::MatrixXd(points, count), Eigen::MatrixXd(points, count),
                  Eigen::MatrixXd(points, count)};
    Eigen::VectorXd local(elements.front().slope.cols());
    for (Index e = 0; e < count; ++e) {
        const auto& element = elements[static_cast<std::size_t>(e)];
        for (Index k = 0; k < local.size(); ++k) {
            local[k] = values[element.node[static_cast<std::size_t>(k)]];
        }
        found.value.col(e).noalias() = space.values() * local;
        const Eigen::VectorXd both = element.slope * local;
        found.r.col(e) = both.head(points);
        found.z.col(e) = both.tail(points);
    }
    return found;
}

/// Rate of shear of the flow in r and z alone, over the speed; slopes are sampled times r.
double rate_in_plane(const Sampled& radial, const Sampled& axial, Index point, Index element,
                     double radius) {
    // On the axis u / r is the slope of u.
    const double u_r = radial.r(point, element) / radius;
    const double u_z = radial.z(point, element) / radius;
    const double w_r = axial.r(point, element) / radius;
    const double w_z = axial.z(point, element) / radius;
    const double u_over_r = radial.value(point, element) / radius;
    return std::sqrt(2.0 * (u_r * u_r + u_over_r * u_over_r + w_z * w_z) +
                     (u_z + w_r) * (u_z + w_r));
}

void add_outline(fields::SectionFields& section, const SectionMesh& mesh,
                 const SectionElement& shape, std::uint32_t first, std::uint32_t columns) {
    const std::uint32_t last = columns - 1;
    const std::array<std::array<std::uint32_t, 2>, 4> start_and_step{
        {{0, 1}, {last * columns, 1}, {0, columns}, {last, columns}}};
    for (std::size_t side = 0; side < 4; ++side) {
        const unsigned boundary = mesh.edge_boundary[static_cast<std::size_t>(shape.edge[side])];
        if (boundary == interior_side) {
            continue;
        }
        const fields::OutlineKind kind = boundary == rotor_wall ? fields::OutlineKind::rotor
                                         : boundary == cup_wall ? fields::OutlineKind::fixed_wall
                                         : (boundary & (free_surface | inner_surface)) != 0U
                                             ? fields::OutlineKind::free_surface
                                             : fields::OutlineKind::axis;
        const auto [start, step] = start_and_step[side];
        for (std::uint32_t k = 0; k < last; ++k) {
            const std::uint32_t from = first + start + k * step;
            section.outline.push_back({kind, {from, from + step}});
        }
    }
}

} // namespace

fields::SectionFields swirl_fields(const SwirlSolution& solution,
                                   const laws::flow::AnyFlowLaw& law) {
    const double share =
        std::sqrt(points_of_section / static_cast<double>(solution.mesh.elements.size()));
    const int columns = std::max({solution.degree + 1, least_points,
                                  static_cast<int>(std::ceil(std::min(share, most_points)))});
    const Eigen::VectorXd exact = lobatto_nodes(columns - 1);
    LineRule rule{exact, Eigen::VectorXd::Zero(columns)};
    rule.node[0] += inset;
    rule.node[columns - 1] -= inset;
    const Sampled rotation = sampled(solution, Field::rotation, solution.rotation, rule);
    Sampled curl;
    if (solution.stress_function != nullptr) {
        curl = sampled(solution, Field::stress_function, *solution.stress_function, rule);
    }

    const bool has_secondary = solution.radial != nullptr && solution.axial != nullptr;
    Sampled radial;
    Sampled axial;
    Sampled stream;
    if (has_secondary) {
        radial = sampled(solution, Field::rotation, *solution.radial, rule);
        axial = sampled(solution, Field::rotation, *solution.axial, rule);
    }
    if (solution.stream_function != nullptr) {
        stream = sampled(solution, Field::rotation, *solution.stream_function, rule);
    }

    fields::SectionFields section;
    section.speed = solution.speed;
    section.yield_stress = laws::flow::yield_stress(law);
    if (section.yield_stress > 0.0) {
        section.rigid_rate = rate_resolved * solution.rate_scale;
    }
    fields::NodalField velocity{std::string{fields::name::velocity}, "m/s", 3, {}};
    fields::NodalField angular{std::string{fields::name::angular_velocity}, "rad/s", 1, {}};
    fields::NodalField shear_rate{std::string{fields::name::shear_rate}, "1/s", 1, {}};
    fields::NodalField shear_stress{std::string{fields::name::shear_stress}, "Pa", 1, {}};
    fields::NodalField swirl_stress{std::string{fields::name::swirl_stress}, "Pa", 3, {}};
    fields::NodalField viscosity{std::string{fields::name::viscosity}, "Pa.s", 1, {}};
    fields::NodalField yielded{std::string{fields::name::yielded}, "1", 1, {}};
    fields::NodalField stream_values{std::string{fields::name::stream_function}, "m^3/s", 1, {}};
    const double direction = std::copysign(1.0, solution.speed);
    for (std::size_t e = 0; e < solution.mesh.elements.size(); ++e) {
        const SectionElement& shape = solution.mesh.elements[e];
        const std::uint32_t first = fields::add_patch(
            section, static_cast<std::size_t>(columns), static_cast<std::size_t>(columns),
            [&](std::size_t column, std::size_t row) {
                const double right = 0.5 * (1.0 + exact[static_cast<Index>(column)]);
                const double up = 0.5 * (1.0 + exact[static_cast<Index>(row)]);
                const double bottom =
                    shape.bottom_left + (shape.bottom_right - shape.bottom_left) * right;
                const double top = shape.top_left + (shape.top_right - shape.top_left) * right;
                return fields::SectionPoint{solution.length *
                                                (shape.left + (shape.right - shape.left) * right),
                                            solution.length * (bottom + (top - bottom) * up)};
            });
        add_outline(section, solution.mesh, shape, first, static_cast<std::uint32_t>(columns));
        const double nearest = shape.left + 0.5 * inset * (shape.right - shape.left);
        for (Index q = 0; q < Index{columns} * columns; ++q) {
            const auto element = static_cast<Index>(e);
            const double radius = section.points[first + static_cast<std::size_t>(q)].r;
            const double w = solution.speed * rotation.value(q, element);
            const double g_r = rotation.r(q, element);
            const double g_z = rotation.z(q, element);
            const double size = std::hypot(g_r, g_z);
            const double speed = std::abs(solution.speed);
            const double rate =
                has_secondary
                    ? speed * std::hypot(size,
                                         rate_in_plane(radial, axial, q, element,
                                                       std::max(radius / solution.length, nearest)))
                    : speed * size;
            double stress = rate > 0.0 ? laws::flow::stress(law, rate) : 0.0;
            // The swirl's share of the stress is its share of the rate.
            double stress_r = rate > 0.0 ? direction * stress * speed * g_r / rate : 0.0;
            double stress_z = rate > 0.0 ? direction * stress * speed * g_z / rate : 0.0;
            if (solution.stress_function != nullptr) {
                // r^2 stress = (-d/dz, d/dr) psi.
                stress_r = -direction * solution.stress_scale * curl.z(q, element);
                stress_z = direction * solution.stress_scale * curl.r(q, element);
                stress = std::hypot(stress_r, stress_z);
            }
            const bool flows = section.yield_stress == 0.0 || rate > section.rigid_rate;
            const double scale = has_secondary ? speed * solution.length : 0.0;
            velocity.values.insert(velocity.values.end(),
                                   {has_secondary ? scale * radial.value(q, element) : 0.0,
                                    radius * w,
                                    has_secondary ? scale * axial.value(q, element) : 0.0});
            if (solution.stream_function != nullptr) {
                stream_values.values.push_back(speed * std::pow(solution.length, 3) *
                                               stream.value(q, element));
            }
            angular.values.push_back(w);
            shear_rate.values.push_back(rate);
            shear_stress.values.push_back(stress);
            swirl_stress.values.insert(swirl_stress.values.end(), {stress_r, 0.0, stress_z});
            viscosity.values.push_back(flows && rate > 0.0
                                           ? laws::flow::stress(law, rate) / rate
                                           : std::numeric_limits<double>::quiet_NaN());
            yielded.values.push_back(flows ? 1.0 : 0.0);
        }
    }
    section.fields = {std::move(velocity),     std::move(angular),      std::move(shear_rate),
                      std::move(shear_stress), std::move(swirl_stress), std::move(viscosity),
                      std::move(yielded)};
    if (solution.stream_function != nullptr) {
        section.fields.push_back(std::move(stream_values));
    }
    return section;
}

} // namespace searle::solvers::axisymmetric
