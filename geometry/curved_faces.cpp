#include "geometry/curved_faces.hpp"

#include "geometry/vector3.hpp"

#include <array>
#include <span>

namespace searle::geometry {
namespace {

/// Values and slopes of a face's shape functions at a point of the unit square or triangle.
struct ShapeFunctions {
    std::array<double, 8> value{};
    std::array<double, 8> along_first{};
    std::array<double, 8> along_second{};
};

/// Serendipity quadrangle on [-1, 1]^2, gmsh's order.
ShapeFunctions quadrangle8(double u, double v) {
    constexpr std::array<std::array<double, 2>, 8> node{
        {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    ShapeFunctions shape;
    for (std::size_t at = 0; at < 8; ++at) {
        const auto [a, b] = node[at];
        if (at < 4) {
            shape.value[at] = 0.25 * (1 + a * u) * (1 + b * v) * (a * u + b * v - 1);
            shape.along_first[at] = 0.25 * a * (1 + b * v) * (2 * a * u + b * v);
            shape.along_second[at] = 0.25 * b * (1 + a * u) * (a * u + 2 * b * v);
        } else if (a == 0) {
            shape.value[at] = 0.5 * (1 - u * u) * (1 + b * v);
            shape.along_first[at] = -u * (1 + b * v);
            shape.along_second[at] = 0.5 * b * (1 - u * u);
        } else {
            shape.value[at] = 0.5 * (1 - v * v) * (1 + a * u);
            shape.along_first[at] = 0.5 * a * (1 - v * v);
            shape.along_second[at] = -v * (1 + a * u);
        }
    }
    return shape;
}

ShapeFunctions triangle6(double u, double v) {
    const double w = 1 - u - v;
    return {{w * (2 * w - 1), u * (2 * u - 1), v * (2 * v - 1), 4 * u * w, 4 * u * v, 4 * v * w},
            {1 - 4 * w, 4 * u - 1, 0, 4 * (w - u), 4 * v, -4 * v},
            {1 - 4 * w, 0, 4 * v - 1, -4 * u, 4 * u, 4 * (w - v)}};
}

ShapeFunctions triangle3(double u, double v) { return {{1 - u - v, u, v}, {-1, 1, 0}, {-1, 0, 1}}; }

ShapeFunctions quadrangle4(double u, double v) {
    return {{0.25 * (1 - u) * (1 - v), 0.25 * (1 + u) * (1 - v), 0.25 * (1 + u) * (1 + v),
             0.25 * (1 - u) * (1 + v)},
            {-0.25 * (1 - v), 0.25 * (1 - v), 0.25 * (1 + v), -0.25 * (1 + v)},
            {-0.25 * (1 - u), -0.25 * (1 + u), 0.25 * (1 + u), 0.25 * (1 - u)}};
}

ShapeFunctions functions_of(CellShape shape, double u, double v) {
    switch (shape) {
    case CellShape::triangle3:
        return triangle3(u, v);
    case CellShape::triangle6:
        return triangle6(u, v);
    case CellShape::quadrangle4:
        return quadrangle4(u, v);
    default:
        return quadrangle8(u, v);
    }
}

/// Gauss's rules: of 3 points for straight faces, whose integrands are polynomials, and of 10 for
/// curved ones, whose area is the integral of a root.
constexpr std::array<double, 3> straight_point{-0.774596669241483377, 0.0, 0.774596669241483377};
constexpr std::array<double, 3> straight_weight{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
constexpr std::array<double, 10> curved_point{
    -0.973906528517171720, -0.865063366688984511, -0.679409568299024406, -0.433395394129247191,
    -0.148874338981631211, 0.148874338981631211,  0.433395394129247191,  0.679409568299024406,
    0.865063366688984511,  0.973906528517171720};
constexpr std::array<double, 10> curved_weight{
    0.0666713443086881376, 0.149451349150580593, 0.219086362515982044, 0.269266719309996355,
    0.295524224714752870,  0.295524224714752870, 0.269266719309996355, 0.219086362515982044,
    0.149451349150580593,  0.0666713443086881376};

} // namespace

SurfaceMeasures surface_measures_of(const Mesh& mesh, const Patch& patch) {
    SurfaceMeasures sum;
    for (std::size_t face = patch.first; face < patch.first + patch.count; ++face) {
        const CellShape shape = mesh.faces.shape(face);
        const auto nodes = mesh.faces.nodes(face);
        const bool is_triangle = corner_count(shape) == 3;
        const bool is_curved = shape != straight(shape);
        const std::span<const double> point_at =
            is_curved ? std::span<const double>{curved_point} : straight_point;
        const std::span<const double> weight_at =
            is_curved ? std::span<const double>{curved_weight} : straight_weight;
        for (std::size_t i = 0; i < point_at.size(); ++i)
            for (std::size_t j = 0; j < point_at.size(); ++j) {
                double u = point_at[i];
                double v = point_at[j];
                double weight = weight_at[i] * weight_at[j];
                if (is_triangle) { // the square folded onto the triangle
                    const double a = 0.5 * (1 + u);
                    const double b = 0.5 * (1 + v);
                    u = a;
                    v = b * (1 - a);
                    weight *= 0.25 * (1 - a);
                }
                const ShapeFunctions at = functions_of(shape, u, v);
                Point place;
                Point first;
                Point second;
                for (std::size_t node = 0; node < nodes.size(); ++node) {
                    const Point& point = mesh.points[nodes[node]];
                    place = place + at.value[node] * point;
                    first = first + at.along_first[node] * point;
                    second = second + at.along_second[node] * point;
                }
                const Point normal = cross(first, second);
                sum.area += weight * length(normal);
                sum.volume += weight * dot(place, normal) / 3.0;
            }
    }
    return sum;
}

} // namespace searle::geometry
