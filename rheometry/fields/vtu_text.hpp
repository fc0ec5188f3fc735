#pragma once

#include "rheometry/fields/section_fields.hpp"

#include <string>
#include <string_view>

namespace searle::rheometry::fields {

/// A section as VTK's XML file for unstructured grids (.vtu), which ParaView and meshio read. The
/// half-plane is theta = 0: x = r, y = 0, z = z, so that vectors (r, theta, z) are (x, y, z).
/// Quadrilaterals, then the outline's lines; the cell array "part" is 0 in the fluid and
/// 1 + OutlineKind on the outline. Field data: TimeValue (s), row, speed_rad_s, yield_stress_Pa,
/// rigid_rate_1_s.
/// Units stand in a comment. Floating-point numbers keep all their bits (base64).
[[nodiscard]] std::string vtu_text(const SectionFields& section);

/// Reads what vtu_text wrote. Throws std::runtime_error that says what is wrong.
[[nodiscard]] SectionFields read_vtu_text(std::string_view text);

/// A file of fields and its time, for a collection.
struct TimedFile {
    double time{}; ///< s
    std::string name;
};

/// ParaView's collection (.pvd) that lists files by time.
[[nodiscard]] std::string pvd_text(const std::vector<TimedFile>& files);

} // namespace searle::rheometry::fields
