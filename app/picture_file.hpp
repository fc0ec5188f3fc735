#pragma once

#include <filesystem>
#include <string>

namespace searle::app {

/// Writes an SVG text as .svg, or as .png through rsvg-convert. Throws geometry::MeshError for
/// another ending, geometry::MeshToolMissing without rsvg-convert, and
/// std::filesystem::filesystem_error where the path cannot be written.
void write_picture(const std::string& svg, const std::filesystem::path& file);

/// Refuses an ending that write_picture cannot write, before any work. Throws geometry::MeshError.
void check_picture_ending(const std::filesystem::path& file);

} // namespace searle::app
