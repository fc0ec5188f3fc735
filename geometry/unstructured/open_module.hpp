#pragma once

namespace searle::geometry {

/// A function of the module that holds gmsh, see gmsh_module/module.hpp; null: gmsh is not here.
[[nodiscard]] void* find_gmsh_module_function(const char* symbol);

/// The same; throws MeshToolMissing when gmsh is not here.
[[nodiscard]] void* gmsh_module_function(const char* symbol);

} // namespace searle::geometry
