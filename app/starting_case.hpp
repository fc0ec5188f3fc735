#pragma once

#include <string>
#include <vector>

namespace searle::app {

/// Names of the geometries that a case file may have, in the order of their declaration.
[[nodiscard]] std::vector<std::string> geometry_names();

/// A commented case file for water in this geometry, one of geometry_names(), made from the
/// declarations: every key that the case uses, in usual units, with what it means.
[[nodiscard]] std::string starting_case(const std::string& geometry);

} // namespace searle::app
