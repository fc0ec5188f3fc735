#include "solvers/radial/gap_fields.hpp"

#include "rheometry/schedule.hpp"
#include "solvers/radial/gap_run.hpp"
#include "solvers/radial/gap_system.hpp"
#include "solvers/radial/gauss_rule.hpp"
#include "solvers/radial/rotor_gaps.hpp"
#include "solvers/radial/transient_levels.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace searle::solvers::radial {
namespace {

namespace fields = rheometry::fields;

constexpr int steady_elements = 24;
constexpr int most_elements = 96;
constexpr int parts = 4; ///< points in an element
constexpr double step_tolerance = 1e-6;

/// The flux over a gap: see run_gap.
struct GapProfile {
    GapShape shape;
    std::vector<double> grid;
    std::function<double(double x)> flux;
};

class StripWriter {
public:
    StripWriter(const Scene& scene, fields::SectionFields& section)
        : law_(scene.fluid.law), section_(section), has_axis_(geometry::rotates(scene.instrument)) {
        section.yield_stress = laws::flow::yield_stress(law_);
        add("velocity", "m/s", 3);
        if (has_axis_) {
            add("angular_velocity", "rad/s", 1);
        }
        add("shear_rate", "1/s", 1);
        add("shear_stress", "Pa", 1);
        add("swirl_stress", "Pa", 3);
        add("viscosity", "Pa.s", 1);
        add("yielded", "1", 1);
    }

    void add_strip(const GapProfile& gap, double height) {
        std::vector<double> x;
        for (std::size_t e = 0; e + 1 < gap.grid.size(); ++e) {
            for (int k = 0; k < parts; ++k) {
                x.push_back(gap.grid[e] + (gap.grid[e + 1] - gap.grid[e]) * k / parts);
            }
        }
        x.push_back(gap.grid.back());
        const std::vector<double> speed = speeds(gap, x);
        const std::uint32_t first =
            fields::add_patch(section_, x.size(), 2, [&](std::size_t column, std::size_t row) {
                return fields::SectionPoint{x[column], row == 0 ? 0.0 : height};
            });
        const auto columns = static_cast<std::uint32_t>(x.size());
        const auto wall = [&](bool moves, std::uint32_t column) {
            section_.outline.push_back(
                {moves ? fields::OutlineKind::rotor : fields::OutlineKind::fixed_wall,
                 {first + column, first + columns + column}});
        };
        wall(!gap.shape.outer_wall_moves, 0);
        wall(gap.shape.outer_wall_moves, columns - 1);
        for (std::uint32_t k = 0; k + 1 < columns; ++k) {
            for (const std::uint32_t row : {0U, columns}) {
                section_.outline.push_back(
                    {fields::OutlineKind::open_end, {first + row + k, first + row + k + 1}});
            }
        }
        for (int row = 0; row < 2; ++row) {
            for (std::size_t k = 0; k < x.size(); ++k) {
                add_point(gap, x[k], speed[k]);
            }
        }
    }

private:
    void add(std::string_view name, std::string_view unit, int components) {
        section_.fields.push_back({std::string{name}, std::string{unit}, components, {}});
    }
    void append(std::string_view name, std::initializer_list<double> values) {
        for (fields::NodalField& field : section_.fields) {
            if (field.name == name) {
                field.values.insert(field.values.end(), values);
            }
        }
    }

    [[nodiscard]] double stress_at(const GapProfile& gap, double x) const {
        return gap.flux(x) / (gap.shape.planar ? 1.0 : x * x);
    }

    /// w at the points, by integrating dw/dx = rate / b from the wall at rest.
    [[nodiscard]] std::vector<double> speeds(const GapProfile& gap,
                                             const std::vector<double>& x) const {
        const auto& rule = gauss_rule<5>();
        std::vector<double> sum(x.size(), 0.0);
        for (std::size_t k = 1; k < x.size(); ++k) {
            const double half = 0.5 * (x[k] - x[k - 1]);
            double change = 0.0;
            for (std::size_t q = 0; q < rule.node.size(); ++q) {
                const double at = 0.5 * (x[k] + x[k - 1]) + half * rule.node[q];
                const double stress = stress_at(gap, at);
                change += half * rule.weight[q] *
                          std::copysign(laws::flow::rate(law_, std::abs(stress)), stress) /
                          (gap.shape.planar ? 1.0 : at);
            }
            sum[k] = sum[k - 1] + change;
        }
        if (!gap.shape.outer_wall_moves) {
            const double at_rest = sum.back();
            for (double& each : sum) {
                each -= at_rest;
            }
        }
        return sum;
    }

    void add_point(const GapProfile& gap, double x, double w) {
        const double stress = stress_at(gap, x);
        const double rate = laws::flow::rate(law_, std::abs(stress));
        const bool flows = section_.yield_stress == 0.0 || std::abs(stress) > section_.yield_stress;
        append("velocity", {0.0, gap.shape.planar ? w : x * w, 0.0});
        append("angular_velocity", {w});
        append("shear_rate", {rate});
        append("shear_stress", {std::abs(stress)});
        append("swirl_stress", {stress, 0.0, 0.0});
        append("viscosity", {flows && rate > 0.0 ? std::abs(stress) / rate
                                                 : std::numeric_limits<double>::quiet_NaN()});
        append("yielded", {flows ? 1.0 : 0.0});
    }

    const laws::flow::AnyFlowLaw& law_;
    fields::SectionFields& section_;
    bool has_axis_;
};

/// The height of the strip: the wetted length, of the box its width.
double height_of(const geometry::Instrument& instrument) {
    return std::visit(
        [](const auto& chosen) -> double {
            using Kind = std::decay_t<decltype(chosen)>;
            if constexpr (std::is_same_v<Kind, geometry::Box>) {
                return chosen.width;
            } else if constexpr (std::is_same_v<Kind, geometry::DinBob>) {
                return chosen.height();
            } else {
                return chosen.height;
            }
        },
        instrument);
}

GapProfile steady_profile(const GapShape& shape, const laws::flow::AnyFlowLaw& law, double speed) {
    GapProfile gap{shape, {}, {}};
    for (int k = 0; k <= steady_elements; ++k) {
        gap.grid.push_back(shape.inner + shape.width() * k / steady_elements);
    }
    double flux = 0.0;
    if (speed != 0.0) {
        const double sign = (speed > 0.0) == shape.outer_wall_moves ? 1.0 : -1.0;
        flux = sign * steady_flux_size(shape, law, std::abs(speed));
    }
    gap.flux = [flux](double) { return flux; };
    return gap;
}

GapProfile transient_profile(const GapShape& shape, const std::vector<double>& grid,
                             const FluxField& flux) {
    GapProfile gap{shape, grid, {}};
    gap.flux = [grid, flux](double x) {
        const auto after = std::upper_bound(grid.begin(), grid.end(), x);
        const auto e = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
            after - grid.begin() - 1, 0, static_cast<std::ptrdiff_t>(grid.size()) - 2));
        const double xi = 2.0 * (x - grid[e]) / (grid[e + 1] - grid[e]) - 1.0;
        return 0.5 * (1.0 - xi) * flux.node[e] + 0.5 * (1.0 + xi) * flux.node[e + 1] +
               (1.0 - xi * xi) * flux.bubble[e];
    };
    return gap;
}

} // namespace

std::vector<fields::SectionFields> gap_fields(const Scene& scene, const RadialReport& solution,
                                              std::span<const std::size_t> rows) {
    if (rows.empty()) // most cases: a second run of the flow would be for nothing
        return {};
    const std::vector<RotorGap> gaps = rotor_gaps(scene.instrument, scene.fluid.density);
    const double height = height_of(scene.instrument);
    std::vector<fields::SectionFields> sections;
    for (const std::size_t row : rows) {
        const rheometry::TorqueRow& found = solution.history.rows.at(row - 1);
        fields::SectionFields section;
        section.row = row;
        section.time = found.time;
        section.speed = found.speed;
        sections.push_back(std::move(section));
    }
    std::vector<StripWriter> writers;
    writers.reserve(sections.size());
    for (fields::SectionFields& section : sections) {
        writers.emplace_back(scene, section);
    }
    if (!solution.transient) {
        for (std::size_t k = 0; k < sections.size(); ++k) {
            for (const RotorGap& gap : gaps) {
                writers[k].add_strip(steady_profile(gap.shape, scene.fluid.law, sections[k].speed),
                                     height);
            }
        }
        return sections;
    }
    const auto schedule = rheometry::schedule(
        scene.protocol, rheometry::conversion_for(scene.instrument, scene.conversion));
    const auto& history = std::get<rheometry::SpeedHistory>(schedule);
    for (const RotorGap& gap : gaps) {
        const GapResolution resolution{
            .elements = std::clamp(solution.elements, steady_elements, most_elements),
            .layer = thinnest_layer(gap.shape, scene.fluid.law, history),
            .step_tolerance = step_tolerance};
        const std::vector<double> grid =
            graded_grid(gap.shape, resolution.layer, resolution.elements);
        const GapRun run =
            run_gap(gap.shape, scene.fluid.law, history, resolution,
                    [&](std::size_t row, const GapRow& at_row) {
                        const auto found = std::ranges::find(rows, row + 1);
                        if (found != rows.end()) {
                            writers[static_cast<std::size_t>(found - rows.begin())].add_strip(
                                transient_profile(gap.shape, grid, *at_row.profile), height);
                        }
                    });
        static_cast<void>(run);
    }
    return sections;
}

} // namespace searle::solvers::radial
