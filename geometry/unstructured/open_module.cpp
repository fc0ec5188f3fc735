#include "geometry/unstructured/open_module.hpp"

#include "geometry/mesh_error.hpp"

#include <dlfcn.h>
#include <filesystem>
#include <system_error>

namespace searle::geometry {
namespace {

namespace fs = std::filesystem;

/// Beside the program, or where it was built.
void* opened_module() {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    const fs::path beside = program.parent_path() / "searle_gmsh.so";
    for (const fs::path& path : {beside, fs::path{SEARLE_GMSH_MODULE}})
        if (fs::exists(path, ignored))
            if (void* const module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL))
                return module;
    return nullptr;
}

} // namespace

void* find_gmsh_module_function(const char* symbol) {
    static void* const module = opened_module();
    return module == nullptr ? nullptr : dlsym(module, symbol);
}

void* gmsh_module_function(const char* symbol) {
    void* const function = find_gmsh_module_function(symbol);
    if (function == nullptr)
        throw MeshToolMissing("triangles and tetrahedra are made by gmsh, which is not here; to "
                              "get it: apt-get install libgmsh-dev, and build Searle again");
    return function;
}

} // namespace searle::geometry
