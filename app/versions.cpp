#include "app/versions.hpp"

namespace searle::app {

std::string_view program_version() { return SEARLE_VERSION; }

std::string compiler() { return SEARLE_COMPILER ", " SEARLE_BUILD_TYPE; }

Versions library_versions() {
    return {{"Boost", BOOST_VERSION_TEXT},        {"CLI11", CLI11_VERSION_TEXT},
            {"Eigen", EIGEN_VERSION_TEXT},        {"fmt", FMT_VERSION_TEXT},
            {"FreeXL", FREEXL_VERSION_TEXT},      {"libzip", ZIP_VERSION_TEXT},
            {"nlohmann-json", JSON_VERSION_TEXT}, {"pugixml", PUGIXML_VERSION_TEXT},
            {"toml++", TOML_VERSION_TEXT},        {"UDUNITS-2", UDUNITS2_VERSION_TEXT}};
}

Versions all_versions() {
    Versions versions = library_versions();
    versions["searle"] = program_version();
    versions["compiler"] = compiler();
    return versions;
}

} // namespace searle::app
