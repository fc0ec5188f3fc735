#include "solvers/openfoam/transport.hpp"

#include <fmt/format.h>

namespace searle::solvers::openfoam {
namespace {

namespace flow = laws::flow;

struct TransportText {
    double density{};
    double cap{}; ///< kinematic

    [[nodiscard]] std::string herschel_bulkley(double yield_stress, double consistency,
                                               double index) const {
        return fmt::format("transportModel  HerschelBulkley;\n\nnu              {0:.17g};\n\n"
                           "HerschelBulkleyCoeffs\n{{\n    nu0         {0:.17g};\n"
                           "    tau0        {1:.17g};\n    k           {2:.17g};\n"
                           "    n           {3:.17g};\n}}\n",
                           cap, yield_stress / density, consistency / density, index);
    }
    std::string operator()(const flow::Newtonian& law) const {
        return fmt::format("transportModel  Newtonian;\n\nnu              {:.17g};\n",
                           law.viscosity / density);
    }
    std::string operator()(const flow::Bingham& law) const {
        return herschel_bulkley(law.yield_stress, law.plastic_viscosity, 1.0);
    }
    std::string operator()(const flow::HerschelBulkley& law) const {
        return herschel_bulkley(law.yield_stress, law.consistency, law.flow_index);
    }
    std::string operator()(const flow::PowerLaw& law) const {
        // Of a thinning fluid the cap bounds it at rest; a thickening one's falls to zero there,
        // and is kept above a part of 1e12 of its consistency.
        const bool thins = law.flow_index < 1.0;
        const double consistency = law.consistency / density;
        return fmt::format("transportModel  powerLaw;\n\nnu              {0:.17g};\n\n"
                           "powerLawCoeffs\n{{\n    nuMax       {0:.17g};\n"
                           "    nuMin       {1:.17g};\n    k           {2:.17g};\n"
                           "    n           {3:.17g};\n}}\n",
                           thins ? cap : 1e12 * consistency, thins ? 0.0 : 1e-12 * consistency,
                           consistency, law.flow_index);
    }
    std::string operator()(const flow::Casson& law) const {
        return fmt::format("transportModel  Casson;\n\nnu              {0:.17g};\n\n"
                           "CassonCoeffs\n{{\n    nuMax       {0:.17g};\n"
                           "    nuMin       {1:.17g};\n    tau0        {2:.17g};\n"
                           "    m           {3:.17g};\n}}\n",
                           cap, 0.0, law.yield_stress / density, law.plastic_viscosity / density);
    }
    std::string operator()(const flow::CarreauYasuda& law) const {
        return fmt::format("transportModel  BirdCarreau;\n\nnu              {0:.17g};\n\n"
                           "BirdCarreauCoeffs\n{{\n    nu0         {0:.17g};\n"
                           "    nuInf       {1:.17g};\n    k           {2:.17g};\n"
                           "    n           {3:.17g};\n    a           {4:.17g};\n}}\n",
                           law.zero_viscosity / density, law.infinite_viscosity / density,
                           law.time_constant, law.flow_index, law.transition);
    }
    std::string operator()(const flow::Cross& law) const {
        return fmt::format("transportModel  CrossPowerLaw;\n\nnu              {0:.17g};\n\n"
                           "CrossPowerLawCoeffs\n{{\n    nu0         {0:.17g};\n"
                           "    nuInf       {1:.17g};\n    m           {2:.17g};\n"
                           "    n           {3:.17g};\n}}\n",
                           law.zero_viscosity / density, law.infinite_viscosity / density,
                           law.time_constant, 1.0 - law.flow_index);
    }
};

/// The same law without the yield stress where that is 0: OpenFOAM's models with one would be
/// capped at a viscosity that nothing asks for.
flow::AnyFlowLaw reduced(const flow::AnyFlowLaw& law) {
    if (flow::yield_stress(law) > 0.0)
        return law;
    if (const auto* bingham = std::get_if<flow::Bingham>(&law))
        return flow::Newtonian{bingham->plastic_viscosity};
    if (const auto* casson = std::get_if<flow::Casson>(&law))
        return flow::Newtonian{casson->plastic_viscosity};
    if (const auto* general = std::get_if<flow::HerschelBulkley>(&law))
        return flow::PowerLaw{general->consistency, general->flow_index};
    return law;
}

} // namespace

std::string transport_text(const flow::AnyFlowLaw& law, double density, double viscosity_cap) {
    return std::visit(TransportText{density, viscosity_cap / density}, reduced(law));
}

bool needs_viscosity_cap(const flow::AnyFlowLaw& law) {
    const flow::AnyFlowLaw simplest = reduced(law);
    if (const auto* power_law = std::get_if<flow::PowerLaw>(&simplest))
        return power_law->flow_index < 1.0;
    return flow::yield_stress(simplest) > 0.0;
}

} // namespace searle::solvers::openfoam
