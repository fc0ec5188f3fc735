#include "solvers/plan_items.hpp"
#include "solvers/plan_rows.hpp"
#include "solvers/plan_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <variant>

namespace searle::solvers {
namespace {

std::string taylor_warning(const Forecast& forecast, bool are_solved, bool has_ends) {
    const std::size_t above =
        count_rows(forecast, [&](std::size_t i) { return forecast.rows[i].taylor_ratio > 1.0; });
    return fmt::format(
        "Taylor vortices at {}, from a shear rate of {:.4g} 1/s on: {}.",
        rows_of(above, forecast.rows.size()), forecast.taylor->onset_shear_rate.value_or(0.0),
        are_solved ? "their torque is in the result, not in the fluid's flow curve"
        : has_ends
            ? "the result is one of several axisymmetric flows there, not surely the instrument's"
            : "the result has the laminar torque there, an instrument shows a larger one");
}

/// Of the gap that vortices are solved in, m.
double height_of_gap(const geometry::Instrument& instrument) {
    if (const auto* gaps = std::get_if<geometry::DoubleGap>(&instrument)) {
        return gaps->height;
    }
    return std::get<geometry::ConcentricCylinders>(instrument).height;
}

std::string partly_sheared_warning(const Forecast& forecast, std::size_t partly) {
    const auto rate_ratio = [&](std::size_t i) {
        const RowFacts& facts = forecast.facts[i];
        return facts.partly_sheared ? facts.rotor_wall_rate / std::abs(forecast.rows[i].shear_rate)
                                    : 0.0;
    };
    const std::size_t worst = row_of_largest(forecast, rate_ratio);
    return fmt::format(
        "The gap is partly sheared at {}: the rotor's true shear rate there is up to {:.3g} times "
        "the converted one; a fit of the curve needs the non-Newtonian rate correction.",
        rows_of(partly, forecast.rows.size()), rate_ratio(worst));
}

std::string definition_warning(const Scene& scene, const Forecast& forecast, std::size_t worst) {
    return fmt::format(
        "The conversion {} takes the rate of a Newtonian fluid: for this {} fluid the steady "
        "stresses lie off the true flow curve by up to {} (at {:.4g} 1/s) even in a perfect "
        "instrument.",
        rheometry::name_of(forecast.conversion.definition), laws::flow::name_of(scene.fluid.law),
        percent(std::abs(forecast.facts[worst].definition_error)),
        std::abs(forecast.rows[worst].shear_rate));
}

std::string lag_warning(const Forecast& forecast, std::size_t lagging) {
    const auto excess = [&](std::size_t i) {
        const double share = forecast.rows[i].lag_share;
        return forecast.rows[i].speed == 0.0 ? 0.0 : share / std::max(1.0 - share, 1e-9);
    };
    const std::size_t worst = row_of_largest(forecast, excess);
    return fmt::format(
        "Inertia of the fluid shows at {}: by the plan's estimate it changes the apparent "
        "viscosity by up to {} (t = {:.4g} s); this is part of the result, not of the fluid's flow "
        "curve.",
        rows_of(lagging, forecast.rows.size()), percent(excess(worst)), forecast.rows[worst].time);
}

} // namespace

std::vector<std::string> plan_warnings(const Scene& scene, const Forecast& forecast,
                                       bool vortices) {
    std::vector<std::string> warnings;
    const double accuracy = scene.solver.accuracy;
    if (forecast.taylor && forecast.taylor->largest_ratio > 1.0) {
        warnings.push_back(taylor_warning(forecast, vortices,
                                          has_ends(scene) && scene.solver.model != Model::radial));
    }
    if (const auto& wavelength = scene.solver.vortex_wavelength) {
        if (!vortices) {
            warnings.emplace_back(
                "solver.vortex_wavelength is not used: no Taylor vortices are solved for here.");
        } else if (const double height = height_of_gap(scene.instrument);
                   0.5 * *wavelength > height) {
            warnings.push_back(fmt::format(
                "Half of solver.vortex_wavelength, a vortex, is {:.4g} mm high, and the gap "
                "only {:.4g} mm: none fits in.",
                500.0 * *wavelength, 1e3 * height));
        }
    }
    if (is_box(scene)) {
        // Lower bound of sustained turbulence in plane Couette flow, Re = U h / (4 nu) = 325
        // (Dauchot & Daviaud 1995, Phys. Fluids 7, 335).
        constexpr double turbulence = 1300.0;
        const std::size_t above = count_rows(
            forecast, [&](std::size_t i) { return forecast.facts[i].reynolds > turbulence; });
        if (above > 0) {
            warnings.push_back(
                fmt::format("U h / nu is above {:.0f} at {}: plane shear flow can be "
                            "turbulent there, the radial model is laminar.",
                            turbulence, rows_of(above, forecast.rows.size())));
        }
    }
    if (const std::size_t lagging = rows_with_lag(scene, forecast); lagging > 0) {
        warnings.push_back(lag_warning(forecast, lagging));
    }
    const std::size_t partly =
        count_rows(forecast, [&](std::size_t i) { return forecast.facts[i].partly_sheared; });
    if (partly > 0) {
        warnings.push_back(partly_sheared_warning(forecast, partly));
    }
    const std::size_t furthest =
        row_of_largest(forecast, [&](std::size_t i) { return forecast.facts[i].definition_error; });
    if (!is_newtonian(scene) && std::abs(forecast.facts[furthest].definition_error) > accuracy) {
        warnings.push_back(definition_warning(scene, forecast, furthest));
    }
    if (has_ends(scene)) {
        const std::size_t ends = count_rows(
            forecast, [&](std::size_t i) { return forecast.facts[i].end_flow_share > accuracy; });
        if (ends > 0) {
            const std::size_t worst = row_of_largest(
                forecast, [&](std::size_t i) { return forecast.facts[i].end_reynolds; });
            warnings.push_back(fmt::format(
                "Secondary flow at the bob's ends at {}: omega R^2 / nu reaches {:.4g}.",
                rows_of(ends, forecast.rows.size()), forecast.facts[worst].end_reynolds));
        }
    } else if (forecast.conversion.end_factor != 1.0) {
        warnings.push_back(fmt::format(
            "end_factor = {:.5g} divides a torque that has no ends in it: the stresses read {} {} "
            "than the fluid's.",
            forecast.conversion.end_factor,
            percent(std::abs(1.0 / forecast.conversion.end_factor - 1.0)),
            forecast.conversion.end_factor > 1.0 ? "lower" : "higher"));
    }
    if (const double height = slenderness(scene.instrument);
        height > 0.0 && height < 10.0 && !has_ends(scene)) {
        warnings.push_back(
            fmt::format("The gap is only {:.3g} times as high as wide: the ends that "
                        "are left out would matter in an instrument.",
                        height));
    }
    return warnings;
}

} // namespace searle::solvers
