#pragma once

#include "casefile/keys.hpp"
#include "casefile/sweep.hpp"
#include "geometry/instrument_keys.hpp"
#include "rheometry/conversion/conversion_keys.hpp"
#include "rheometry/protocol_keys.hpp"
#include "solvers/settings_keys.hpp"
#include "solvers/suspension/suspension_keys.hpp"

#include <optional>
#include <string>

namespace searle::app {

/// A case file in the words of its author: what each section says, defaults filled in.
struct CaseAsWritten {
    std::string title;
    geometry::GeometryAsWritten geometry;
    solvers::Fluid fluid;
    rheometry::ProtocolAsWritten protocol;
    rheometry::ConversionSettings conversion;
    solvers::SolverSettings solver;
    solvers::OutputSettings output;
    geometry::MeshSettings mesh;
    std::optional<solvers::suspension::ParticleSettings> particles;
    std::optional<solvers::suspension::CouplingSettings> coupling;
    std::optional<casefile::Sweep> sweep;
};

/// Every key of a case file, and the checks that concern several sections.
[[nodiscard]] const casefile::Keys<CaseAsWritten>& case_keys();

/// The same keys for a case that is only meshed: [fluid] and [protocol] may be left out.
[[nodiscard]] const casefile::Keys<CaseAsWritten>& mesh_case_keys();

/// Fills in what depends on other sections: definition and end factor of the conversion.
void resolve(CaseAsWritten& written);

/// The scene that a resolved case without faults describes.
[[nodiscard]] solvers::Scene scene_of(const CaseAsWritten& written);

} // namespace searle::app
