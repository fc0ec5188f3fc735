#include "rheometry/fit/model.hpp"

#include "laws/flow/ellis.hpp"
#include "laws/flow/flow_law.hpp"
#include "laws/flow/sisko.hpp"
#include "laws/flow/windhab.hpp"

#include <ceres/jet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

namespace searle::rheometry::fit {
namespace {

namespace flow = laws::flow;

/// How the search sees each parameter of a law, in the law's order.
template <template <class> class Law>
struct SearchOf;
template <>
struct SearchOf<flow::NewtonianLaw> {
    static constexpr std::array transforms{Transform::logarithm};
};
template <>
struct SearchOf<flow::BinghamLaw> {
    static constexpr std::array transforms{Transform::identity, Transform::logarithm};
};
template <>
struct SearchOf<flow::PowerLawLaw> {
    static constexpr std::array transforms{Transform::logarithm, Transform::identity};
};
template <>
struct SearchOf<flow::HerschelBulkleyLaw> {
    static constexpr std::array transforms{Transform::identity, Transform::logarithm,
                                           Transform::identity};
};
template <>
struct SearchOf<flow::CassonLaw> {
    static constexpr std::array transforms{Transform::square_root, Transform::logarithm};
};
template <>
struct SearchOf<flow::CarreauYasudaLaw> {
    static constexpr std::array transforms{Transform::logarithm, Transform::identity,
                                           Transform::logarithm, Transform::identity,
                                           Transform::logarithm};
};
template <>
struct SearchOf<flow::CrossLaw> {
    static constexpr std::array transforms{Transform::logarithm, Transform::identity,
                                           Transform::logarithm, Transform::identity};
};
template <>
struct SearchOf<flow::SiskoLaw> {
    static constexpr std::array transforms{Transform::identity, Transform::logarithm,
                                           Transform::identity};
};
template <>
struct SearchOf<flow::EllisLaw> {
    static constexpr std::array transforms{Transform::logarithm, Transform::logarithm,
                                           Transform::identity};
};
template <>
struct SearchOf<flow::WindhabLaw> {
    static constexpr std::array transforms{Transform::identity, Transform::identity,
                                           Transform::logarithm, Transform::logarithm};
};

template <class Scalar>
Scalar in_si(Transform transform, const Scalar& coordinate) {
    using std::exp;
    switch (transform) {
    case Transform::logarithm:
        return exp(coordinate);
    case Transform::square_root:
        return coordinate * coordinate;
    case Transform::identity:
        break;
    }
    return coordinate;
}

template <class Law, std::size_t... Index>
Law law_from(std::span<const double> values, std::index_sequence<Index...> /*unused*/) {
    return Law{values[Index]...};
}

template <template <class> class Law>
struct Bound {
    static constexpr std::size_t count = Law<double>::parameters.size();
    static constexpr auto transforms = SearchOf<Law>::transforms;
    static_assert(transforms.size() == count);

    static Law<double> from_values(std::span<const double> values) {
        return law_from<Law<double>>(values, std::make_index_sequence<count>());
    }
    template <class Scalar, std::size_t... Index>
    static Law<Scalar> from_search(const std::array<Scalar, count>& search,
                                   std::index_sequence<Index...> /*unused*/) {
        return Law<Scalar>{in_si(transforms[Index], search[Index])...};
    }

    static void stresses(std::span<const double> search, std::span<const double> rates,
                         std::span<double> stress, std::span<double> jacobian) {
        constexpr auto all = std::make_index_sequence<count>();
        if (jacobian.empty()) {
            std::array<double, count> plain{};
            std::copy_n(search.begin(), count, plain.begin());
            const Law<double> law = from_search<double>(plain, all);
            for (std::size_t k = 0; k < rates.size(); ++k)
                stress[k] = law.stress(rates[k]);
            return;
        }
        using Jet = ceres::Jet<double, static_cast<int>(count)>;
        std::array<Jet, count> seeded;
        for (std::size_t i = 0; i < count; ++i)
            seeded[i] = Jet(search[i], static_cast<int>(i));
        const Law<Jet> law = from_search<Jet>(seeded, all);
        for (std::size_t k = 0; k < rates.size(); ++k) {
            const Jet value = law.stress(rates[k]);
            stress[k] = value.a;
            for (std::size_t i = 0; i < count; ++i)
                jacobian[k * count + i] = value.v[static_cast<int>(i)];
        }
    }
    static double stress(std::span<const double> values, double rate) {
        return from_values(values).stress(rate);
    }
    static double rate(std::span<const double> values, double stress) {
        const Law<double> law = from_values(values);
        const double excess = stress - law.yield_stress_value();
        return excess > 0.0 ? law.rate_at_excess(excess) : 0.0;
    }
    static double yield_stress(std::span<const double> values) {
        return from_values(values).yield_stress_value();
    }
    static double log_slope(std::span<const double> values, double rate) {
        return from_values(values).log_slope(rate);
    }
    static std::optional<flow::AnyFlowLaw> for_solvers(std::span<const double> values) {
        if constexpr (std::is_constructible_v<flow::AnyFlowLaw, Law<double>>)
            return flow::AnyFlowLaw{from_values(values)};
        else
            return std::nullopt;
    }

    static Model model(std::string_view formula) {
        Model made{.name = Law<double>::name,
                   .formula = formula,
                   .parameters = {},
                   .stresses = stresses,
                   .stress = stress,
                   .rate = rate,
                   .yield_stress = yield_stress,
                   .log_slope = log_slope,
                   .for_solvers = for_solvers};
        for (std::size_t i = 0; i < count; ++i)
            made.parameters.push_back({.key = std::string(Law<double>::parameters[i].key),
                                       .unit = std::string(Law<double>::parameters[i].unit),
                                       .transform = transforms[i]});
        return made;
    }
};

} // namespace

std::optional<std::size_t> Model::find(std::string_view key) const {
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (parameters[i].key == key)
            return i;
    return std::nullopt;
}

std::vector<double> Model::values(std::span<const double> search) const {
    std::vector<double> result(search.size());
    for (std::size_t i = 0; i < search.size(); ++i)
        result[i] = from_search(parameters[i].transform, search[i]);
    return result;
}

std::vector<double> Model::search(std::span<const double> values) const {
    std::vector<double> result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        result[i] = to_search(parameters[i].transform, values[i]);
    return result;
}

std::span<const Model> models() {
    static const std::array all{
        Bound<flow::NewtonianLaw>::model("viscosity rate"),
        Bound<flow::BinghamLaw>::model("yield_stress + plastic_viscosity rate"),
        Bound<flow::PowerLawLaw>::model("consistency rate^flow_index"),
        Bound<flow::HerschelBulkleyLaw>::model("yield_stress + consistency rate^flow_index"),
        Bound<flow::CassonLaw>::model("(sqrt(yield_stress) + sqrt(plastic_viscosity rate))^2"),
        Bound<flow::CarreauYasudaLaw>::model(
            "rate (infinite + (zero - infinite) [1 + (time_constant "
            "rate)^transition]^((flow_index - 1)/transition))"),
        Bound<flow::CrossLaw>::model(
            "rate (infinite + (zero - infinite) / [1 + (time_constant rate)^(1 - flow_index)])"),
        Bound<flow::SiskoLaw>::model("infinite_viscosity rate + consistency rate^flow_index"),
        Bound<flow::EllisLaw>::model(
            "zero_viscosity rate / [1 + (stress / half_stress)^(exponent - 1)]"),
        Bound<flow::WindhabLaw>::model(
            "yield_stress + (extrapolated_stress - yield_stress) [1 - exp(-rate / "
            "characteristic_rate)] + infinite_viscosity rate")};
    return all;
}

const Model* model_named(std::string_view name) {
    for (const Model& model : models())
        if (model.name == name)
            return &model;
    return nullptr;
}

} // namespace searle::rheometry::fit
