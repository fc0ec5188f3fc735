#include "rheometry/report/flow_series.hpp"

#include "rheometry/report/regime_shading.hpp"
#include "rheometry/report/rich_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace searle::rheometry::report {

namespace {

constexpr double hole = std::numeric_limits<double>::quiet_NaN();

// Beyond this the order of the points is scatter, not a protocol worth arrows.
constexpr std::size_t most_branches = 12;

struct Branch {
    std::size_t first{};
    std::size_t last{}; ///< included; the next branch starts here
    bool rising{};
};

std::vector<Branch> branches_of(const Rheogram& rheogram) {
    std::vector<Branch> branches;
    const auto& points = rheogram.points;
    for (std::size_t k = 1; k < points.size(); ++k) {
        const double step = points[k].shear_rate - points[k - 1].shear_rate;
        const bool moves = step > 0.0 || step < 0.0;
        if (branches.empty() || (moves && branches.back().rising != (step > 0.0))) {
            if (!branches.empty()) {
                branches.back().last = k - 1;
            }
            branches.push_back({k - 1, k, step > 0.0});
        }
        branches.back().last = k;
    }
    return branches;
}

void add_point(Series& series, const RheogramPoint& point, const CurveView& view) {
    series.x.push_back(value_of(point, view.x) * view.x_unit.per_si);
    series.y.push_back(value_of(point, view.y) * view.y_unit.per_si);
}

// Gives a series the points with these indices, with error bars and tips.
void mark_points(Series& series, const Rheogram& rheogram, std::vector<std::size_t> indices,
                 const Conversion& conversion, const CurveView& view, bool has_time) {
    for (const std::size_t k : indices) {
        const RheogramPoint& point = rheogram.points[k];
        add_point(series, point, view);
        series.error.push_back(error_of(point, view.y, conversion) * view.y_unit.per_si);
    }
    series.tip = [&points = rheogram.points, chosen = std::move(indices), has_time,
                  rotates = view.rotates](std::size_t k) {
        return point_tip(points[chosen[k]], rotates, has_time);
    };
}

} // namespace

CurveView view_of(const Rheogram& rheogram, Quantity x, Quantity y, bool rotates) {
    CurveView view;
    view.x = x;
    view.y = y;
    view.rotates = rotates;
    view.x_unit = display_unit(look_of(x, rotates).si_unit, largest_value(rheogram, x));
    view.y_unit = display_unit(look_of(y, rotates).si_unit, largest_value(rheogram, y));
    return view;
}

Axis x_axis(const CurveView& view, Scale scale) {
    Axis axis;
    axis.name = axis_name(look_of(view.x, view.rotates), view.x_unit);
    axis.scale = scale;
    return axis;
}

Axis y_axis(const CurveView& view, Scale scale) {
    Axis axis;
    axis.name = axis_name(look_of(view.y, view.rotates), view.y_unit);
    axis.scale = scale;
    // A constant viscosity is to look constant.
    if (view.y == Quantity::viscosity) {
        axis.least_relative_span = 0.3;
    }
    return axis;
}

std::vector<Series> computed_series(const Rheogram& rheogram, const Conversion& conversion,
                                    const CurveView& view, bool transient, const RichText& name,
                                    int colour) {
    Series marked;
    marked.name = name;
    marked.colour = colour;
    marked.marker = Marker::circle;
    const bool follows_time = view.x == Quantity::time;
    if (!transient || follows_time || !passes_rates_twice(rheogram)) {
        std::vector<std::size_t> every(rheogram.points.size());
        std::iota(every.begin(), every.end(), std::size_t{0});
        mark_points(marked, rheogram, std::move(every), conversion, view, transient);
        return {marked};
    }

    Series falling = marked;
    falling.open_marker = true;
    marked.name.upright(", rising rate");
    falling.name.upright(", falling rate");
    const std::vector<Branch> branches = branches_of(rheogram);
    std::vector<Series> all;
    std::vector<std::size_t> on_rising;
    std::vector<std::size_t> on_falling;
    for (const Branch& branch : branches) {
        Series line;
        line.colour = colour;
        line.stroke = Stroke::solid;
        line.thin = true;
        line.shows_direction = branches.size() <= most_branches;
        for (std::size_t k = branch.first; k <= branch.last; ++k) {
            add_point(line, rheogram.points[k], view);
            const bool is_start = k == branch.first && &branch != &branches.front();
            if (!is_start) {
                (branch.rising ? on_rising : on_falling).push_back(k);
            }
        }
        all.push_back(std::move(line));
    }
    mark_points(marked, rheogram, std::move(on_rising), conversion, view, transient);
    mark_points(falling, rheogram, std::move(on_falling), conversion, view, transient);
    all.push_back(std::move(marked));
    all.push_back(std::move(falling));
    return all;
}

Series law_series(const StressOfRate& law, double lowest_rate, double highest_rate,
                  const CurveView& view, Scale rate_scale) {
    constexpr int samples = 160;
    Series series;
    series.name = RichText{"flow law of the fluid"};
    series.colour = 7;
    series.stroke = Stroke::solid;
    series.thin = true;
    // The viscosity of a yield-stress law has no end towards zero rate.
    series.sets_range = view.y != Quantity::viscosity || rate_scale == Scale::logarithmic;
    const auto add = [&](double rate) {
        double value = law(std::abs(rate));
        if (view.y == Quantity::viscosity) {
            value = value / std::abs(rate);
        } else if (rate < 0.0) {
            value = -value;
        }
        series.x.push_back(rate * view.x_unit.per_si);
        series.y.push_back(value * view.y_unit.per_si);
    };
    const auto add_hole = [&] {
        series.x.push_back(hole);
        series.y.push_back(hole);
    };
    if (!law || !(highest_rate >= lowest_rate)) {
        return series;
    }
    if (rate_scale == Scale::logarithmic) {
        if (!(lowest_rate > 0.0)) {
            return series;
        }
        const double ratio = highest_rate / lowest_rate;
        for (int k = 0; k <= samples; ++k) {
            add(lowest_rate * std::pow(ratio, static_cast<double>(k) / samples));
        }
        return series;
    }
    // Quadratic spacing away from zero, where yield-stress laws bend most.
    if (lowest_rate < 0.0) {
        for (int k = samples; k > 0; --k) {
            const double share = static_cast<double>(k) / samples;
            const double rate = lowest_rate * share * share;
            if (rate <= highest_rate) {
                add(rate);
            }
        }
        add_hole();
    }
    for (int k = 0; k <= samples; ++k) {
        const double share = static_cast<double>(k) / samples;
        const double rate = highest_rate * share * share;
        const bool defined = rate > 0.0 || view.y != Quantity::viscosity;
        if (rate >= std::max(0.0, lowest_rate) && defined && highest_rate >= 0.0) {
            add(rate);
        }
    }
    return series;
}

Series inertia_free_series(const Rheogram& rheogram, const Conversion& conversion,
                           const CurveView& view) {
    Series series;
    const bool particles = !rheogram.points.empty() && rheogram.points.front().suspension;
    series.name = RichText{particles ? "the fluid alone, without inertia" : "without inertia"};
    series.colour = 1;
    series.stroke = Stroke::dashed;
    for (const RheogramPoint& point : rheogram.points) {
        double value = point.steady_stress;
        if (view.y == Quantity::viscosity) {
            value /= point.shear_rate;
        }
        if (view.y == Quantity::torque) {
            value /= conversion.stress_per_torque;
        }
        series.x.push_back(value_of(point, view.x) * view.x_unit.per_si);
        series.y.push_back(value * view.y_unit.per_si);
    }
    return series;
}

Series measured_series(const MeasuredSeries& measured, const CurveView& view, int index) {
    constexpr Marker markers[] = {Marker::diamond, Marker::square, Marker::triangle, Marker::cross};
    constexpr int colours[] = {2, 3, 4, 6};
    Series series;
    series.name = RichText{measured.name};
    series.colour = colours[index % 4];
    series.marker = markers[index % 4];
    series.open_marker = true;
    series.reports_error_bars = false;
    const std::size_t count = std::min(measured.shear_rate.size(), measured.shear_stress.size());
    for (std::size_t k = 0; k < count; ++k) {
        const double rate = measured.shear_rate[k];
        const double divisor = view.y == Quantity::viscosity ? rate : 1.0;
        series.x.push_back(rate * view.x_unit.per_si);
        series.y.push_back(measured.shear_stress[k] / divisor * view.y_unit.per_si);
        if (measured.stress_error.size() == count) {
            series.error.push_back(
                std::abs(measured.stress_error[k] / divisor * view.y_unit.per_si));
        }
    }
    series.tip = [&measured](std::size_t k) {
        return measured.name +
               "\n\u03b3\u0307 = " + quantity_text(measured.shear_rate[k], "1/s", 4) +
               "\n\u03c4 = " + quantity_text(measured.shear_stress[k], "Pa", 4);
    };
    return series;
}

RateRange rate_range(const Rheogram& rheogram) {
    RateRange range{hole, hole, hole};
    for (const RheogramPoint& point : rheogram.points) {
        const double rate = point.shear_rate;
        if (!std::isfinite(rate)) {
            continue;
        }
        range.lowest = std::fmin(range.lowest, rate);
        range.highest = std::fmax(range.highest, rate);
        if (rate > 0.0) {
            range.lowest_positive = std::fmin(range.lowest_positive, rate);
        }
    }
    return range;
}

Scale suitable_scale(const std::vector<double>& values) {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = 0.0;
    for (const double value : values) {
        if (!std::isfinite(value)) {
            continue;
        }
        if (value <= 0.0) {
            return Scale::linear;
        }
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
    }
    return highest > 30.0 * lowest ? Scale::logarithmic : Scale::linear;
}

std::vector<double> column(const Rheogram& rheogram, Quantity quantity, double factor) {
    std::vector<double> values;
    values.reserve(rheogram.points.size());
    for (const RheogramPoint& point : rheogram.points) {
        values.push_back(value_of(point, quantity) * factor);
    }
    return values;
}

bool has_positive_pair(const Rheogram& rheogram, Quantity x, Quantity y) {
    return std::any_of(
        rheogram.points.begin(), rheogram.points.end(), [&](const RheogramPoint& point) {
            const double first = value_of(point, x);
            const double second = value_of(point, y);
            return first > 0.0 && second > 0.0 && std::isfinite(first) && std::isfinite(second);
        });
}

void add_regimes(Plot& plot, const Rheogram& rheogram, const CurveView& view, bool transient) {
    if (view.x != Quantity::time && transient && passes_rates_twice(rheogram)) {
        return;
    }
    const std::vector<double> x = column(rheogram, view.x, view.x_unit.per_si);
    RegimeShading shading = shade_regimes(rheogram.points, x);
    plot.bands = std::move(shading.bands);
    plot.band_kinds = std::move(shading.kinds);
}

} // namespace searle::rheometry::report
