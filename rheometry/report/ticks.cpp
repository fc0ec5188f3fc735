#include "rheometry/report/ticks.hpp"

#include "rheometry/report/rich_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>

namespace searle::rheometry::report {

namespace {

// Limits of the exponents at which plain digits are easier to read than a power of ten.
constexpr int plain_from = -4;
constexpr int plain_to = 5;

std::string with_minus_sign(std::string digits) {
    if (!digits.empty() && digits.front() == '-') {
        digits.replace(0, 1, "\u2212");
    }
    return digits;
}

RichText power_of_ten(int exponent) {
    return RichText{"10"}.superscript(with_minus_sign(std::to_string(exponent)));
}

struct Step {
    double mantissa = 1.0; // 1, 2 or 5
    int exponent{};
    [[nodiscard]] double value() const {
        return exponent >= 0 ? mantissa * std::pow(10.0, exponent)
                             : mantissa / std::pow(10.0, -exponent);
    }
    // A multiple of the step, with the rounding of a division rather than of a product.
    [[nodiscard]] double times(double count) const {
        return exponent >= 0 ? count * mantissa * std::pow(10.0, exponent)
                             : count * mantissa / std::pow(10.0, -exponent);
    }
};

Step nice_step(double span, int most) {
    const double raw = span / std::max(1, most - 1);
    Step step;
    step.exponent = static_cast<int>(std::floor(std::log10(raw)));
    for (const double mantissa : {1.0, 2.0, 5.0, 10.0}) {
        step.mantissa = mantissa;
        if (step.value() >= raw * (1.0 - 1e-9)) {
            break;
        }
    }
    if (step.mantissa == 10.0) {
        step.mantissa = 1.0;
        ++step.exponent;
    }
    return step;
}

Step finer(Step step) {
    if (step.mantissa == 1.0) {
        return {5.0, step.exponent - 1};
    }
    return {step.mantissa == 5.0 ? 2.0 : 1.0, step.exponent};
}

RichText linear_label(double value, const Step& step, double largest) {
    if (value == 0.0) {
        return RichText{"0"};
    }
    const int top = static_cast<int>(std::floor(std::log10(largest) + 1e-12));
    if (top <= plain_to && step.exponent >= -6 && top >= plain_from) {
        return RichText{
            with_minus_sign(fmt::format("{:.{}f}", value, std::max(0, -step.exponent)))};
    }
    const int digits = std::clamp(top - step.exponent, 0, 15);
    const double mantissa = top >= 0 ? value / std::pow(10.0, top) : value * std::pow(10.0, -top);
    const std::string text = with_minus_sign(fmt::format("{:.{}f}", mantissa, digits));
    if (text == "1") {
        return power_of_ten(top);
    }
    return RichText{text + "\u00d7"}.append(power_of_ten(top));
}

std::vector<double> multiples(const Step& step, double low, double high) {
    constexpr double slack = 1e-9;
    std::vector<double> out;
    const double first = std::ceil(low / step.value() - slack);
    const double last = std::floor(high / step.value() + slack);
    for (double count = first; count <= last && out.size() < 1000; count += 1.0) {
        out.push_back(count == 0.0 ? 0.0 : step.times(count));
    }
    return out;
}

RichText decade_label(double mantissa, int exponent, bool plain) {
    if (plain) {
        const double value = exponent >= 0 ? mantissa * std::pow(10.0, exponent)
                                           : mantissa / std::pow(10.0, -exponent);
        return RichText{fmt::format("{:.{}f}", value, std::max(0, -exponent))};
    }
    if (mantissa == 1.0) {
        return power_of_ten(exponent);
    }
    return RichText{fmt::format("{:.0f}\u00d7", mantissa)}.append(power_of_ten(exponent));
}

} // namespace

TickMarks linear_ticks(double low, double high, int most) {
    Step step = nice_step(high - low, most);
    std::vector<double> major = multiples(step, low, high);
    for (int attempt = 0; major.size() < 2 && attempt < 3; ++attempt) {
        step = finer(step);
        major = multiples(step, low, high);
    }
    TickMarks out;
    const double largest = std::max(std::abs(low), std::abs(high));
    for (const double value : major) {
        out.major.push_back({value, linear_label(value, step, largest)});
    }
    const Step between{step.mantissa == 2.0   ? 5.0
                       : step.mantissa == 5.0 ? 1.0
                                              : 2.0,
                       step.mantissa == 5.0 ? step.exponent : step.exponent - 1};
    for (const double value : multiples(between, low, high)) {
        const double count = value / step.value();
        if (std::abs(count - std::round(count)) > 1e-6) {
            out.minor.push_back(value);
        }
    }
    return out;
}

TickMarks logarithmic_ticks(double low, double high, int most) {
    const double decades = std::log10(high / low);
    if (decades < 0.5) {
        return linear_ticks(low, high, most);
    }
    const int first = static_cast<int>(std::floor(std::log10(low) + 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(high) + 1e-9));
    const bool plain = first >= -3 && last <= 4 && (decades < 1.5 || (first >= -2 && last <= 3));
    const int stride = std::max(1, static_cast<int>(std::ceil(decades / std::max(1, most - 1))));
    TickMarks out;
    const auto inside = [&](double value) {
        return value >= low * (1.0 - 1e-9) && value <= high * (1.0 + 1e-9);
    };
    const auto is_labelled = [&](int exponent) {
        return ((exponent % stride) + stride) % stride == 0;
    };
    int labelled_powers = 0;
    for (int exponent = first; exponent <= last; ++exponent) {
        if (is_labelled(exponent) && inside(std::pow(10.0, exponent))) {
            ++labelled_powers;
        }
    }
    const bool labels_between = decades < 1.5 || (labelled_powers < 2 && stride == 1);
    for (int exponent = first; exponent <= last; ++exponent) {
        for (int mantissa = 1; mantissa <= 9; ++mantissa) {
            const double value = exponent >= 0 ? mantissa * std::pow(10.0, exponent)
                                               : mantissa / std::pow(10.0, -exponent);
            if (!inside(value)) {
                continue;
            }
            const bool step_of_few = labels_between && (mantissa == 2 || mantissa == 5);
            if ((mantissa == 1 && is_labelled(exponent)) || step_of_few) {
                out.major.push_back({value, decade_label(mantissa, exponent, plain)});
            } else if (stride <= 2 || mantissa == 1) {
                out.minor.push_back(value);
            }
        }
    }
    return out.major.size() < 3 && decades < 1.0 ? linear_ticks(low, high, most) : out;
}

} // namespace searle::rheometry::report
