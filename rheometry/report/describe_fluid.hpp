#pragma once

#include "laws/flow/flow_law.hpp"
#include "rheometry/report/report_input.hpp"

#include <optional>

namespace searle::rheometry::report {

/// A flow law with its parameters and itself as a callable, for the report.
[[nodiscard]] FluidDescription describe_fluid(const laws::flow::AnyFlowLaw& law,
                                              std::optional<double> density);

} // namespace searle::rheometry::report
