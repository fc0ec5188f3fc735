#include "rheometry/report/quantity.hpp"

#include "rheometry/report/rich_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace searle::rheometry::report {

QuantityLook look_of(Quantity quantity, bool rotates) {
    switch (quantity) {
    case Quantity::time:
        return {"Time", "t", "s"};
    case Quantity::drive_speed:
        return rotates ? QuantityLook{"Angular velocity", "\u03c9", "rad/s"}
                       : QuantityLook{"Wall speed", "U", "m/s"};
    case Quantity::torque:
        return rotates ? QuantityLook{"Torque", "M", "N m"} : QuantityLook{"Wall force", "F", "N"};
    case Quantity::shear_rate:
        return {"Shear rate", "\u03b3\u0307", "1/s"};
    case Quantity::shear_stress:
        return {"Shear stress", "\u03c4", "Pa"};
    case Quantity::viscosity:
        return {"Viscosity", "\u03b7", "Pa.s"};
    }
    return {};
}

double value_of(const RheogramPoint& point, Quantity quantity) {
    switch (quantity) {
    case Quantity::time:
        return point.time;
    case Quantity::drive_speed:
        return point.speed;
    case Quantity::torque:
        return point.torque;
    case Quantity::shear_rate:
        return point.shear_rate;
    case Quantity::shear_stress:
        return point.shear_stress;
    case Quantity::viscosity:
        return point.viscosity;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

double scatter_of(const RheogramPoint& point) {
    const double scatter = point.suspension ? point.suspension->statistical_error : 0.0;
    return std::isfinite(scatter) ? std::abs(scatter) : 0.0;
}

double error_of(const RheogramPoint& point, Quantity quantity, const Conversion& conversion) {
    const auto finite_or_zero = [](double value) { return std::isfinite(value) ? value : 0.0; };
    const double error = finite_or_zero(std::abs(point.stress_error)) + scatter_of(point);
    switch (quantity) {
    case Quantity::torque:
        return finite_or_zero(error / std::abs(conversion.stress_per_torque));
    case Quantity::shear_stress:
        return error;
    case Quantity::viscosity:
        return finite_or_zero(error / std::abs(point.shear_rate));
    default:
        return 0.0;
    }
}

double relative_error(const RheogramPoint& point) {
    if (point.shear_stress == 0.0) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return std::abs(point.stress_error / point.shear_stress);
}

double largest_relative_error(const Rheogram& rheogram) {
    double largest = std::numeric_limits<double>::quiet_NaN();
    for (const RheogramPoint& point : rheogram.points) {
        const double error = relative_error(point);
        if (std::isfinite(error)) {
            largest = std::fmax(largest, error);
        }
    }
    return largest;
}

double largest_value(const Rheogram& rheogram, Quantity quantity) {
    double largest = 0.0;
    for (const RheogramPoint& point : rheogram.points) {
        const double size = std::abs(value_of(point, quantity));
        if (std::isfinite(size)) {
            largest = std::max(largest, size);
        }
    }
    return largest;
}

RichText axis_name(const QuantityLook& look, const DisplayUnit& unit) {
    RichText name{look.name + " "};
    name.italic(look.symbol);
    if (!unit.name.empty()) {
        name.upright(" (" + unit.name + ")");
    }
    return name;
}

std::string point_tip(const RheogramPoint& point, bool rotates, bool has_time) {
    constexpr int digits = 6;
    std::string out;
    const auto add = [&](Quantity quantity) {
        const QuantityLook look = look_of(quantity, rotates);
        if (!out.empty()) {
            out += "\n";
        }
        out += look.symbol + " = " + quantity_text(value_of(point, quantity), look.si_unit, digits);
    };
    if (has_time) {
        add(Quantity::time);
    }
    add(Quantity::shear_rate);
    add(Quantity::shear_stress);
    const double error = relative_error(point);
    if (std::isfinite(error)) {
        out += " \u00b1 " + relative_text(error);
    }
    if (scatter_of(point) > 0.0) {
        out += ", scatter " + relative_text(scatter_of(point) / std::abs(point.shear_stress));
    }
    add(Quantity::viscosity);
    add(Quantity::torque);
    if (!point.regime.empty()) {
        out += "\n" + point.regime;
    }
    return out;
}

} // namespace searle::rheometry::report
