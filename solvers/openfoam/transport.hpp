#pragma once

#include "laws/flow/flow_law.hpp"

#include <string>

namespace searle::solvers::openfoam {

/// A flow law in the words of constant/transportProperties: `transportModel` with its coefficients,
/// all kinematic (over the density). OpenFOAM's models, with g the shear rate:
///   HerschelBulkley  nu = min(nu0, (tau0 + k g^n) / g)
///   powerLaw         nu = k g^(n - 1), kept between nuMin and nuMax
///   Casson           nu = (sqrt(tau0 / g) + sqrt(m))^2, kept between nuMin and nuMax
///   BirdCarreau      nu = nuInf + (nu0 - nuInf) [1 + (k g)^a]^((n - 1) / a)
///   CrossPowerLaw    nu = nuInf + (nu0 - nuInf) / (1 + (m g)^n), n = 1 - flow_index
/// @param density  kg/m^3
/// @param viscosity_cap  Pa s; used by the laws whose viscosity has no bound at rest
[[nodiscard]] std::string transport_text(const laws::flow::AnyFlowLaw& law, double density,
                                         double viscosity_cap);

/// Whether the law's viscosity grows without bound as the rate falls to zero.
[[nodiscard]] bool needs_viscosity_cap(const laws::flow::AnyFlowLaw& law);

} // namespace searle::solvers::openfoam
