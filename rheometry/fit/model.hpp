#pragma once

#include "laws/flow/flow_law.hpp"
#include "rheometry/fit/forward_model.hpp"
#include "rheometry/fit/parameter.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace searle::rheometry::fit {

/// What a data set's size says about where parameters can lie.
struct DataScale {
    double lowest_rate{};       ///< 1/s, > 0
    double highest_rate{};      ///< 1/s
    double lowest_stress{};     ///< Pa, > 0
    double highest_stress{};    ///< Pa
    double lowest_viscosity{};  ///< Pa s
    double highest_viscosity{}; ///< Pa s
};

/// @param rates, stresses  > 0, at least one of each
[[nodiscard]] DataScale scale_of(std::span<const double> rates, std::span<const double> stresses);

/// A flow law as the fit sees it: the law's own text with the parameters as numbers in a row.
/// "search" parameters are in the search's coordinates, "values" in SI; both in the law's order.
struct Model {
    std::string_view name;    ///< as in case files
    std::string_view formula; ///< for people
    /// Bounds left open; see parameters_for.
    std::vector<Parameter> parameters;

    /// Stress at each rate > 0, Pa, and (where `jacobian` is not empty) its derivatives by the
    /// search's coordinates, exact, row by row.
    void (*stresses)(std::span<const double> search, std::span<const double> rates,
                     std::span<double> stress, std::span<double> jacobian);
    double (*stress)(std::span<const double> values, double rate);
    /// Shear rate at a stress, 1/s; 0 up to the yield stress.
    double (*rate)(std::span<const double> values, double stress);
    double (*yield_stress)(std::span<const double> values);
    /// d ln stress / d ln rate.
    double (*log_slope)(std::span<const double> values, double rate);
    /// The law as the solvers take it; none for the laws that cases do not know (sisko, ellis,
    /// windhab).
    std::optional<laws::flow::AnyFlowLaw> (*for_solvers)(std::span<const double> values);

    [[nodiscard]] std::size_t size() const { return parameters.size(); }
    [[nodiscard]] std::optional<std::size_t> find(std::string_view key) const;
    [[nodiscard]] std::vector<double> values(std::span<const double> search) const;
    [[nodiscard]] std::vector<double> search(std::span<const double> values) const;
};

/// newtonian, bingham, power-law, herschel-bulkley, casson, carreau-yasuda, cross, sisko, ellis,
/// windhab.
[[nodiscard]] std::span<const Model> models();
/// The model of exactly this name; null for any other text.
[[nodiscard]] const Model* model_named(std::string_view name);

/// The parameters with bounds wide enough for anything that such data can determine.
[[nodiscard]] std::vector<Parameter> parameters_for(const Model& model, const DataScale& scale);

/// False where the bounds cannot keep the law within its definition (an infinite viscosity above
/// the zero viscosity); the law's simpler relative is then the better description.
[[nodiscard]] bool within_definition(const Model& model, std::span<const double> values);

/// Stress at a list of rates.
class FlowCurveModel final : public ForwardModel {
public:
    /// @param rates  1/s, > 0
    FlowCurveModel(const Model& model, std::vector<double> rates)
        : model_(&model), rates_(std::move(rates)) {}

    [[nodiscard]] std::size_t size() const override { return rates_.size(); }
    [[nodiscard]] bool predict(std::span<const double> search, std::span<double> values,
                               std::span<double> jacobian) const override {
        model_->stresses(search, rates_, values, jacobian);
        return true;
    }

private:
    const Model* model_;
    std::vector<double> rates_;
};

} // namespace searle::rheometry::fit
