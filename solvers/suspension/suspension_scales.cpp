#include "solvers/suspension/suspension_scales.hpp"

#include "solvers/suspension/suspension_input.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <vector>

namespace searle::solvers::suspension {

Sizes sizes_of(const ParticleSettings& settings) {
    Sizes sizes{1e300, 0.0, 0.0};
    double per_volume = 0.0;
    std::vector<SizeClass> classes = settings.diameters;
    if (settings.diameter)
        classes = {{*settings.diameter, 1.0}};
    for (const SizeClass& size : classes) {
        sizes.smallest = std::min(sizes.smallest, size.diameter);
        sizes.largest = std::max(sizes.largest, size.diameter);
        per_volume += size.share * 6.0 / (std::numbers::pi * std::pow(size.diameter, 3));
    }
    // A lognormal spread by number: <d^3> = d^3 exp(9 s^2 / 2); four deviations are the largest.
    const double spread = settings.spread;
    sizes.mean_volume = std::exp(4.5 * spread * spread) / per_volume;
    sizes.largest *= std::exp(4.0 * spread);
    return sizes;
}

double fastest_rate(const Forecast& forecast) {
    double fastest = 0.0;
    for (const RowForecast& row : forecast.rows)
        fastest = std::max(fastest, std::abs(row.shear_rate));
    return fastest;
}

double slowest_rate(const Forecast& forecast) {
    double slowest = 1e300;
    for (const RowForecast& row : forecast.rows)
        if (row.shear_rate != 0.0)
            slowest = std::min(slowest, std::abs(row.shear_rate));
    return slowest;
}

laws::colloid::DlvoCurve curve_of(const ParticleSettings& settings, double radius,
                                  double& attraction) {
    return std::visit(
        [&]<class Colloid>(const Colloid& colloid) -> laws::colloid::DlvoCurve {
            if constexpr (std::is_same_v<Colloid, particles::NoColloid>) {
                return {};
            } else {
                attraction = -colloid.repulsion(0.0, radius, radius);
                return laws::colloid::dlvo_curve(colloid, radius, radius);
            }
        },
        colloid_law(settings.dlvo, settings.temperature));
}

} // namespace searle::solvers::suspension
