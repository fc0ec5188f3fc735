#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace searle::rheometry::fields {

/// A point of the meridional half-plane, m: distance from the axis and height.
struct SectionPoint {
    double r{};
    double z{};
};

/// One quantity at every point of a section, SI. A value that does not exist there (the viscosity
/// of a rigid plug) is not a number.
struct NodalField {
    std::string name; ///< letters, digits, underscores: "shear_rate"; see the names below
    std::string unit; ///< as in case files: "1/s", "Pa", "1"
    /// 1: a scalar. 3: a vector along (r, theta, z).
    int components = 1;
    std::vector<double> values; ///< components of point 0, then of point 1, ...
};

/// Names that pictures and readers look for; further ones may be added freely.
namespace name {
inline constexpr std::string_view velocity = "velocity";                 ///< m/s, vector
inline constexpr std::string_view angular_velocity = "angular_velocity"; ///< rad/s
inline constexpr std::string_view shear_rate = "shear_rate";     ///< 1/s, of the whole flow, >= 0
inline constexpr std::string_view shear_stress = "shear_stress"; ///< Pa, its size, >= 0
inline constexpr std::string_view swirl_stress = "swirl_stress"; ///< Pa, (tau_rt, 0, tau_tz)
inline constexpr std::string_view viscosity = "viscosity";       ///< Pa s; nan where not sheared
inline constexpr std::string_view yielded = "yielded";           ///< 1 sheared, 0 rigid
inline constexpr std::string_view pressure = "pressure";         ///< Pa
inline constexpr std::string_view stream_function = "stream_function"; ///< m^3/s: u = curl / r
} // namespace name

/// What a line of the outline is.
enum class OutlineKind : std::uint8_t { rotor, fixed_wall, free_surface, axis, open_end };
inline constexpr std::array<std::string_view, 5> outline_kind_names{
    "rotor", "fixed_wall", "free_surface", "axis", "open_end"};

/// Two points of the section's boundary, as indices of points.
struct OutlineEdge {
    OutlineKind kind{};
    std::array<std::uint32_t, 2> ends{};
};

/// Fields on the section of an instrument at one row of its rheogram. Elements of any degree come
/// as patches of small quadrilaterals (add_patch); each patch has its own points, so that what
/// jumps between elements jumps here too.
struct SectionFields {
    std::size_t row{};     ///< of the rheogram, from 1
    double time{};         ///< s
    double speed{};        ///< rad/s, of the drive
    double yield_stress{}; ///< Pa; 0: the fluid has none
    /// Rate of shear up to which the fluid counts as rigid, 1/s: what a computed rate cannot tell
    /// from none. The yield surface is drawn where shear_rate crosses it.
    double rigid_rate{};
    std::vector<SectionPoint> points;
    /// Corners, anticlockwise seen with r to the right and z upwards.
    std::vector<std::array<std::uint32_t, 4>> cells;
    std::vector<OutlineEdge> outline;
    std::vector<NodalField> fields;

    /// Null where there is no field of that name.
    [[nodiscard]] const NodalField* find(std::string_view field_name) const;
};

/// A lattice of points, `columns` along r and `rows` along z, both >= 2, and the cells between
/// them; returns the index of its first point. Point (column, row) has the index
/// first + row columns + column. @param place  of point (column, row)
std::uint32_t
add_patch(SectionFields& section, std::size_t columns, std::size_t rows,
          const std::function<SectionPoint(std::size_t column, std::size_t row)>& place);

/// Where fields are written out: the numbers (from 1) of at most `most` of `count` rows, evenly
/// spread, the last included.
[[nodiscard]] std::vector<std::size_t> spread_rows(std::size_t count, std::size_t most);

} // namespace searle::rheometry::fields
