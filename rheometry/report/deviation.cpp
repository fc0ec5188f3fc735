#include "rheometry/report/deviation.hpp"

#include "rheometry/report/number_text.hpp"
#include "rheometry/report/particle_stress.hpp"
#include "rheometry/report/regime_shading.hpp"
#include "rheometry/report/rich_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace searle::rheometry::report {

namespace {

struct DeviationPoint {
    double total{};
    double inertia{};
    double definition{};
    double particles{};
};

DeviationPoint deviation_of(const RheogramPoint& point, const StressOfRate& law) {
    const double rate = point.shear_rate;
    const double true_stress = std::copysign(law(std::abs(rate)), rate);
    const double undefined = std::numeric_limits<double>::quiet_NaN();
    if (rate == 0.0 || true_stress == 0.0) {
        return {undefined, undefined, undefined, undefined};
    }
    if (point.suspension) {
        const ParticleShares shares = particle_shares(point, law);
        const double particles = shares.whole - 1.0 - shares.inertia;
        return {shares.whole - 1.0, shares.inertia, 0.0, particles};
    }
    return {point.shear_stress / true_stress - 1.0, point.shear_stress / point.steady_stress - 1.0,
            point.steady_stress / true_stress - 1.0, 0.0};
}

} // namespace

Deviation largest_deviation(const Rheogram& rheogram, const StressOfRate& law) {
    Deviation out{std::numeric_limits<double>::quiet_NaN(), 0.0};
    if (!law) {
        return out;
    }
    for (const RheogramPoint& point : rheogram.points) {
        const double total = std::abs(deviation_of(point, law).total);
        if (!std::isfinite(total) || total <= out.largest) {
            continue;
        }
        out = {total, point.shear_rate};
    }
    return out;
}

DeviationParts deviation_parts(const ReportInput& input) {
    constexpr double visible = 1e-6;
    DeviationParts parts;
    if (!input.fluid.true_stress) {
        return parts;
    }
    for (const RheogramPoint& point : input.rheogram.points) {
        const DeviationPoint deviation = deviation_of(point, input.fluid.true_stress);
        parts.inertia = parts.inertia || (input.transient && std::abs(deviation.inertia) > visible);
        parts.particles = parts.particles || std::abs(deviation.particles) > visible;
        parts.convention = parts.convention || std::abs(deviation.definition) > visible;
    }
    return parts;
}

bool deviation_matters(const ReportInput& input) {
    const double largest = largest_deviation(input.rheogram, input.fluid.true_stress).largest;
    return largest > std::max(input.accuracy, 1e-6);
}

Plot deviation_plot(const ReportInput& input, const CurveView& flow_view) {
    constexpr double percent = 100.0;
    Plot plot;
    plot.id = "deviation";
    plot.title = "Deviation of the apparent viscosity from the law's";
    Series total;
    total.name = RichText{"apparent viscosity"};
    total.marker = Marker::circle;
    Series inertia;
    inertia.name = RichText{"part of inertia"};
    inertia.colour = 1;
    inertia.stroke = Stroke::dashed;
    Series definition;
    definition.name = RichText{"part of the convention"};
    definition.colour = 2;
    definition.stroke = Stroke::dotted;
    Series particles;
    particles.name = RichText{"part of the particles"};
    particles.colour = 3;
    particles.stroke = Stroke::dashed;
    for (const RheogramPoint& point : input.rheogram.points) {
        const DeviationPoint deviation = deviation_of(point, input.fluid.true_stress);
        const double rate = point.shear_rate * flow_view.x_unit.per_si;
        total.x.push_back(rate);
        total.y.push_back(percent * deviation.total);
        total.error.push_back(percent * (std::abs(point.stress_error) + scatter_of(point)) /
                              std::abs(point.shear_stress) * (1.0 + deviation.total));
        inertia.x.push_back(rate);
        inertia.y.push_back(percent * deviation.inertia);
        definition.x.push_back(rate);
        definition.y.push_back(percent * deviation.definition);
        particles.x.push_back(rate);
        particles.y.push_back(percent * deviation.particles);
    }
    total.tip = [&input](std::size_t k) {
        const RheogramPoint& point = input.rheogram.points[k];
        return "\u03b3\u0307 = " + quantity_text(point.shear_rate, "1/s", 4) +
               "\n\u03b7/\u03b7_law \u2212 1 = " +
               relative_text(deviation_of(point, input.fluid.true_stress).total, 4);
    };
    const bool positive =
        has_positive_pair(input.rheogram, Quantity::shear_rate, Quantity::shear_rate);
    plot.x = x_axis(flow_view, positive ? Scale::logarithmic : Scale::linear);
    plot.y.scale = suitable_scale(total.y);
    if (plot.y.scale == Scale::logarithmic) {
        // A deviation far below the accuracy is noise.
        const double least = percent * std::max(input.accuracy, 1e-6) * 1e-2;
        const double lowest = *std::min_element(total.y.begin(), total.y.end());
        if (lowest < least) {
            plot.y.low = least;
        }
    }
    plot.y.name.italic("\u03b7").upright("/").italic("\u03b7").subscript("law").upright(
        " \u2212 1 (%)");
    plot.zero_line = plot.y.scale == Scale::linear;
    const bool loop = passes_rates_twice(input.rheogram);
    if (loop && input.transient) {
        total.stroke = Stroke::solid;
        total.thin = true;
        total.shows_direction = true;
    }
    plot.series.push_back(std::move(total));
    const DeviationParts parts = deviation_parts(input);
    if (parts.inertia) {
        plot.series.push_back(std::move(inertia));
    }
    if (parts.particles) {
        plot.series.push_back(std::move(particles));
    }
    if (parts.convention) {
        plot.series.push_back(std::move(definition));
    }
    return plot;
}

} // namespace searle::rheometry::report
