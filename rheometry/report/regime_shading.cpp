#include "rheometry/report/regime_shading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace searle::rheometry::report {

namespace {

struct KnownRegime {
    std::string_view name;
    std::string_view label;
    int shade;
};
constexpr std::array<KnownRegime, 6> known_regimes{{{"laminar", "laminar", -1},
                                                    {"lag", "inertial lag", 0},
                                                    {"partly-sheared", "partly sheared", 1},
                                                    {"taylor-vortices", "Taylor vortices", 2},
                                                    {"end-flow", "end flow", 3},
                                                    {"rest", "at rest", 4}}};
constexpr int unknown_shade = 5;

const KnownRegime* find_known(std::string_view name) {
    const auto* found = std::find_if(known_regimes.begin(), known_regimes.end(),
                                     [&](const KnownRegime& known) { return known.name == name; });
    return found == known_regimes.end() ? nullptr : found;
}

bool holds(const RheogramPoint& point, std::string_view name) {
    const std::vector<std::string> names = regime_names(point.regime);
    return std::find(names.begin(), names.end(), name) != names.end();
}

} // namespace

std::vector<std::string> regime_names(std::string_view regime) {
    std::vector<std::string> names;
    while (!regime.empty()) {
        const std::size_t end = std::min(regime.find('+'), regime.size());
        if (end > 0) {
            names.emplace_back(regime.substr(0, end));
        }
        regime.remove_prefix(std::min(end + 1, regime.size()));
    }
    return names;
}

std::string regime_label(std::string_view name) {
    if (const KnownRegime* known = find_known(name)) {
        return std::string{known->label};
    }
    std::string label{name};
    std::replace(label.begin(), label.end(), '-', ' ');
    return label;
}

RegimeShading shade_regimes(std::span<const RheogramPoint> points, std::span<const double> x) {
    const std::size_t count = std::min(points.size(), x.size());
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < count; ++k) {
        if (std::isfinite(x[k])) {
            order.push_back(k);
        }
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });

    std::vector<std::string> names;
    std::string_view last_regime;
    for (const std::size_t k : order) {
        if (points[k].regime == last_regime) {
            continue;
        }
        last_regime = points[k].regime;
        for (const std::string& name : regime_names(last_regime)) {
            const bool seen = std::find(names.begin(), names.end(), name) != names.end();
            if (name != "laminar" && !seen) {
                names.push_back(name);
            }
        }
    }

    constexpr double beyond_every_axis = 1e300;
    RegimeShading shading;
    for (const std::string& name : names) {
        const std::size_t kind = shading.kinds.size();
        const KnownRegime* known = find_known(name);
        shading.kinds.push_back({regime_label(name), known ? known->shade : unknown_shade});
        for (std::size_t first = 0; first < order.size();) {
            if (!holds(points[order[first]], name)) {
                ++first;
                continue;
            }
            std::size_t after = first;
            while (after < order.size() && holds(points[order[after]], name)) {
                ++after;
            }
            const auto between = [&](std::size_t k) {
                return 0.5 * (x[order[k - 1]] + x[order[k]]);
            };
            shading.bands.push_back({first == 0 ? -beyond_every_axis : between(first),
                                     after == order.size() ? beyond_every_axis : between(after),
                                     kind});
            first = after;
        }
    }
    return shading;
}

bool passes_rates_twice(const Rheogram& rheogram) {
    bool rises = false;
    bool falls = false;
    double last = std::nan("");
    for (const RheogramPoint& point : rheogram.points) {
        if (!std::isfinite(point.shear_rate)) {
            continue;
        }
        rises = rises || point.shear_rate > last;
        falls = falls || point.shear_rate < last;
        last = point.shear_rate;
    }
    return rises && falls;
}

} // namespace searle::rheometry::report
