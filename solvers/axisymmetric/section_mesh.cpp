#include "solvers/axisymmetric/section_mesh.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace searle::solvers::axisymmetric {
namespace {

/// Distances from a wall, increasing: 0, then the smallest element, then growing up to `length`.
std::vector<double> graded(double length, double smallest, double ratio) {
    std::vector<double> points{length};
    while (points.back() * ratio > smallest) {
        points.push_back(points.back() * ratio);
    }
    points.push_back(0.0);
    std::reverse(points.begin(), points.end());
    return points;
}

/// From `from` (exactly) to `to` (exactly), small elements at `from`; either may be the larger.
std::vector<double> line_from(double from, double to, const std::vector<double>& distances) {
    std::vector<double> line;
    const double direction = to > from ? 1.0 : -1.0;
    for (const double distance : distances) {
        line.push_back(from + direction * distance);
    }
    line.back() = to;
    if (to < from) {
        std::reverse(line.begin(), line.end());
    }
    return line;
}

/// Small elements at both ends.
std::vector<double> line_between(double from, double to, const std::vector<double>& half) {
    std::vector<double> line;
    for (const double distance : half) {
        line.push_back(from + distance);
    }
    for (std::size_t k = half.size() - 1; k-- > 0;) {
        line.push_back(to - half[k]);
    }
    return line;
}

struct Sides {
    unsigned bottom = interior_side;
    unsigned top = interior_side;
    unsigned left = interior_side;
    unsigned right = interior_side;
};

class Builder {
public:
    /// Adds the block between two families of lines; row j at the radius r is at z_at(r, j).
    template <class HeightAt>
    void add_block(LineFamily columns, LineFamily rows, const SectionLines& lines,
                   const HeightAt& z_at, const Sides& sides) {
        const std::vector<double>& r = lines[static_cast<std::size_t>(columns)];
        const std::size_t row_count = lines[static_cast<std::size_t>(rows)].size() - 1;
        for (std::size_t j = 0; j < row_count; ++j) {
            for (std::size_t i = 0; i + 1 < r.size(); ++i) {
                SectionElement element{
                    .left = r[i],
                    .right = r[i + 1],
                    .bottom_left = z_at(r[i], j),
                    .bottom_right = z_at(r[i + 1], j),
                    .top_left = z_at(r[i], j + 1),
                    .top_right = z_at(r[i + 1], j + 1),
                    .vertex = {},
                    .edge = {},
                    .family = {static_cast<std::size_t>(columns), static_cast<std::size_t>(rows)},
                    .interval = {i, j}};
                element.vertex = {vertex(element.left, element.bottom_left),
                                  vertex(element.right, element.bottom_right),
                                  vertex(element.left, element.top_left),
                                  vertex(element.right, element.top_right)};
                const auto& v = element.vertex;
                element.edge = {edge(v[0], v[1], j == 0 ? sides.bottom : 0U),
                                edge(v[2], v[3], j + 1 == row_count ? sides.top : 0U),
                                edge(v[0], v[2], i == 0 ? sides.left : 0U),
                                edge(v[1], v[3], i + 2 == r.size() ? sides.right : 0U)};
                mesh_.elements.push_back(element);
            }
        }
    }
    [[nodiscard]] SectionMesh take() { return std::move(mesh_); }

private:
    /// Blocks meet in points that come from the same arithmetic, so equality is exact.
    int vertex(double r, double z) {
        const auto [place, added] =
            vertices_.try_emplace({r, z}, static_cast<int>(mesh_.vertex_boundary.size()));
        if (added) {
            mesh_.vertex_boundary.push_back(interior_side);
        }
        return place->second;
    }
    int edge(int from, int to, unsigned boundary) {
        const auto [place, added] =
            edges_.try_emplace({from, to}, static_cast<int>(mesh_.edge_boundary.size()));
        if (added) {
            mesh_.edge_boundary.push_back(interior_side);
        }
        mesh_.edge_boundary[static_cast<std::size_t>(place->second)] |= boundary;
        mesh_.vertex_boundary[static_cast<std::size_t>(from)] |= boundary;
        mesh_.vertex_boundary[static_cast<std::size_t>(to)] |= boundary;
        return place->second;
    }

    SectionMesh mesh_;
    std::map<std::pair<double, double>, int> vertices_;
    std::map<std::pair<int, int>, int> edges_;
};

} // namespace

namespace {

SectionLines lines_of_bob(const geometry::DinBob& bob, const Grading& grading) {
    const double cup = bob.radius_ratio();
    const double length = bob.length_ratio;
    const double smallest = grading.smallest * std::min({cup - 1.0, length, bob.bottom_ratio});
    const auto distances = [&](double span) { return graded(span, smallest, grading.ratio); };
    SectionLines lines;
    const auto family = [&](LineFamily which) -> auto& {
        return lines[static_cast<std::size_t>(which)];
    };
    family(LineFamily::under_bob) = line_from(1.0, 0.0, distances(1.0));
    family(LineFamily::across_gap) = line_from(1.0, cup, distances(cup - 1.0));
    family(LineFamily::below) = line_from(1.0, 0.0, distances(1.0));
    family(LineFamily::beside) = line_between(0.0, length, distances(0.5 * length));
    if (bob.top_ratio > 0.0) {
        const double shaft = bob.shaft_ratio;
        family(LineFamily::over_bob) = line_between(shaft, 1.0, distances(0.5 * (1.0 - shaft)));
        family(LineFamily::above) =
            line_from(length, length + bob.top_ratio, distances(bob.top_ratio));
    }
    return lines;
}

/// Small elements at the rotor's four corners; the free surfaces stand at its straight walls.
SectionLines lines_of_double_gap(const DoubleGapSection& gap, const Grading& grading) {
    const auto& [post, inside, outside, cup] = gap.radii;
    const double unit = outside;
    const double smallest =
        grading.smallest *
        std::min({inside - post, outside - inside, cup - outside, gap.height, gap.bottom_gap}) /
        unit;
    const auto distances = [&](double span) { return graded(span, smallest, grading.ratio); };
    SectionLines lines;
    const auto family = [&](LineFamily which) -> auto& {
        return lines[static_cast<std::size_t>(which)];
    };
    family(LineFamily::over_bob) =
        line_from(inside / unit, post / unit, distances((inside - post) / unit));
    family(LineFamily::under_bob) =
        line_between(inside / unit, 1.0, distances(0.5 * (outside - inside) / unit));
    family(LineFamily::across_gap) = line_from(1.0, cup / unit, distances((cup - outside) / unit));
    // A share of the height under the rotor.
    const double share = smallest * unit / gap.bottom_gap;
    family(LineFamily::below) = line_from(1.0, 0.0, graded(1.0, share, grading.ratio));
    family(LineFamily::beside) = line_from(0.0, gap.height / unit, distances(gap.height / unit));
    return lines;
}

SectionMesh mesh_of_double_gap(const DoubleGapSection& gap, const SectionLines& lines) {
    using enum LineFamily;
    const double depth = gap.bottom_gap / gap.radii[2];
    const auto rows = [&](LineFamily which) -> const auto& {
        return lines[static_cast<std::size_t>(which)];
    };
    const auto z_below = [&](double, std::size_t row) { return -depth * (1.0 - rows(below)[row]); };
    const auto z_beside = [&](double, std::size_t row) { return rows(beside)[row]; };
    Builder builder;
    builder.add_block(over_bob, below, lines, z_below,
                      {.bottom = cup_wall, .top = 0U, .left = cup_wall, .right = 0U});
    builder.add_block(under_bob, below, lines, z_below,
                      {.bottom = cup_wall, .top = rotor_wall, .left = 0U, .right = 0U});
    builder.add_block(across_gap, below, lines, z_below,
                      {.bottom = cup_wall, .top = 0U, .left = 0U, .right = cup_wall});
    builder.add_block(over_bob, beside, lines, z_beside,
                      {.bottom = 0U, .top = inner_surface, .left = cup_wall, .right = rotor_wall});
    builder.add_block(across_gap, beside, lines, z_beside,
                      {.bottom = 0U, .top = free_surface, .left = rotor_wall, .right = cup_wall});
    return builder.take();
}

} // namespace

SectionLines graded_lines(const SectionShape& shape, const Grading& grading) {
    return shape.bob() != nullptr ? lines_of_bob(*shape.bob(), grading)
                                  : lines_of_double_gap(*shape.double_gap(), grading);
}

SectionLines refined(const SectionLines& lines, const LineMarks& marks, double ratio) {
    SectionLines finer;
    for (std::size_t family = 0; family < line_families; ++family) {
        if (lines[family].empty()) {
            continue;
        }
        const auto which = static_cast<LineFamily>(family);
        // Under a bob the first line is the axis, under a rotor of a double gap it is an edge.
        const bool edge_first = which == LineFamily::under_bob && lines[family].front() > 0.0;
        const bool rotor_first =
            edge_first || (which != LineFamily::under_bob && which != LineFamily::below);
        const bool rotor_last = which != LineFamily::across_gap && which != LineFamily::above;
        const std::size_t intervals = lines[family].size() - 1;
        finer[family].push_back(lines[family].front());
        for (std::size_t k = 0; k < intervals; ++k) {
            const double from = lines[family][k];
            const double to = lines[family][k + 1];
            if (marks[family][k]) {
                const bool at_first = rotor_first && k == 0;
                const bool at_last = rotor_last && k + 1 == intervals;
                finer[family].push_back(from + (to - from) * (at_first  ? ratio
                                                              : at_last ? 1.0 - ratio
                                                                        : 0.5));
            }
            finer[family].push_back(to);
        }
    }
    return finer;
}

SectionMesh section_of(const SectionShape& shape, const SectionLines& lines) {
    using enum LineFamily;
    if (shape.double_gap() != nullptr) {
        return mesh_of_double_gap(*shape.double_gap(), lines);
    }
    const geometry::DinBob& bob = *shape.bob();
    const double depth = bob.bottom_ratio;
    const double cone = bob.cone_height() / shape.unit();
    const auto rows = [&](LineFamily which) -> const auto& {
        return lines[static_cast<std::size_t>(which)];
    };
    const auto z_below = [&](double r, std::size_t row) {
        const double share = rows(below)[row];
        const double ceiling = r < 1.0 ? -cone * (1.0 - r) : 0.0;
        return share == 1.0 ? ceiling : -depth + (ceiling + depth) * share;
    };
    const auto z_beside = [&](double, std::size_t row) { return rows(beside)[row]; };
    const auto z_above = [&](double, std::size_t row) { return rows(above)[row]; };
    const bool covered = bob.top_ratio > 0.0;

    Builder builder;
    builder.add_block(under_bob, below, lines, z_below,
                      {.bottom = cup_wall, .top = rotor_wall, .left = symmetry_axis, .right = 0U});
    builder.add_block(across_gap, below, lines, z_below,
                      {.bottom = cup_wall, .top = 0U, .left = 0U, .right = cup_wall});
    builder.add_block(
        across_gap, beside, lines, z_beside,
        {.bottom = 0U, .top = covered ? 0U : free_surface, .left = rotor_wall, .right = cup_wall});
    if (covered) {
        builder.add_block(across_gap, above, lines, z_above,
                          {.bottom = 0U, .top = free_surface, .left = 0U, .right = cup_wall});
        builder.add_block(
            over_bob, above, lines, z_above,
            {.bottom = rotor_wall, .top = free_surface, .left = rotor_wall, .right = 0U});
    }
    return builder.take();
}

} // namespace searle::solvers::axisymmetric
