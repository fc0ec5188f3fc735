// Format: VTK User's Guide, "VTK File Formats"; arrays as base64 of a UInt64 byte count and the
// data, uncompressed.
#include "rheometry/fields/vtu_text.hpp"

#include "rheometry/fields/base64.hpp"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cstring>
#include <stdexcept>

namespace searle::rheometry::fields {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say LittleEndian");

constexpr std::int64_t vtk_line = 3;
constexpr std::int64_t vtk_quadrilateral = 9;

template <class Number>
constexpr std::string_view type_name() {
    if constexpr (std::is_same_v<Number, double>) {
        return "Float64";
    } else if constexpr (std::is_same_v<Number, std::int64_t>) {
        return "Int64";
    } else {
        return "UInt8";
    }
}

template <class Number>
std::string encoded(const std::vector<Number>& items) {
    const auto bytes = static_cast<std::uint64_t>(items.size() * sizeof(Number));
    std::string raw(sizeof bytes + bytes, '\0');
    std::memcpy(raw.data(), &bytes, sizeof bytes);
    if (bytes > 0) {
        std::memcpy(raw.data() + sizeof bytes, items.data(), bytes);
    }
    return base64(raw);
}

template <class Number>
void add_array(std::string& out, std::string_view name, int components,
               const std::vector<Number>& items, std::string_view unit = {}) {
    out += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} "
                       "format=\"binary\">{}</DataArray>\n",
                       type_name<Number>(), name, components,
                       unit.empty() ? "" : fmt::format(" unit=\"{}\"", unit), encoded(items));
}

void add_number(std::string& out, std::string_view name, double value) {
    out += fmt::format("<DataArray type=\"Float64\" Name=\"{}\" NumberOfTuples=\"1\" "
                       "format=\"ascii\">{}</DataArray>\n",
                       name, value);
}

/// The text between two marks, from `at` on; `at` moves behind it.
std::string_view between(std::string_view text, std::string_view from, std::string_view to,
                         std::size_t& at) {
    const std::size_t start = text.find(from, at);
    const std::size_t end = start == text.npos ? text.npos : text.find(to, start + from.size());
    if (end == text.npos) {
        throw std::runtime_error(fmt::format("not a file of fields: {} is missing", from));
    }
    at = end + to.size();
    return text.substr(start + from.size(), end - start - from.size());
}

struct Array {
    std::string name;
    std::string unit;
    int components = 1;
    std::string_view content;
};

std::string attribute_of(std::string_view head, std::string_view name) {
    const std::string key = fmt::format(" {}=\"", name);
    if (head.find(key) == head.npos) {
        return {};
    }
    std::size_t at = 0;
    return std::string{between(head, key, "\"", at)};
}

int components_of(std::string_view digits) {
    constexpr int most = 9; // of a tensor
    int count = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), count);
    if (read.ec != std::errc{} || count < 1 || count > most) {
        throw std::runtime_error("not a file of fields: NumberOfComponents is wrong");
    }
    return count;
}

/// The arrays of one element such as PointData.
std::vector<Array> arrays_in(std::string_view text, std::string_view element) {
    std::size_t at = 0;
    const std::string_view inside =
        between(text, fmt::format("<{}", element), fmt::format("</{}>", element), at);
    std::vector<Array> arrays;
    for (std::size_t next = 0; inside.find("<DataArray", next) != inside.npos;) {
        const std::string_view head = between(inside, "<DataArray", ">", next);
        Array array{
            .name = attribute_of(head, "Name"), .unit = attribute_of(head, "unit"), .content = {}};
        if (const std::string count = attribute_of(head, "NumberOfComponents"); !count.empty()) {
            array.components = components_of(count);
        }
        const std::size_t end = inside.find("</DataArray>", next);
        if (end == inside.npos) {
            throw std::runtime_error("not a file of fields: </DataArray> is missing");
        }
        array.content = inside.substr(next, end - next);
        arrays.push_back(std::move(array));
    }
    return arrays;
}

const Array& named(const std::vector<Array>& arrays, std::string_view name) {
    for (const Array& array : arrays) {
        if (array.name == name) {
            return array;
        }
    }
    throw std::runtime_error(fmt::format("not a file of fields: the array {} is missing", name));
}

template <class Number>
std::vector<Number> decoded(const Array& array, std::size_t expected) {
    const std::string raw = from_base64(array.content);
    std::uint64_t bytes = 0;
    if (raw.size() >= sizeof bytes) {
        std::memcpy(&bytes, raw.data(), sizeof bytes);
    }
    if (raw.size() != sizeof bytes + bytes || bytes != expected * sizeof(Number)) {
        throw std::runtime_error(
            fmt::format("the array {} is not as long as the file says", array.name));
    }
    std::vector<Number> items(expected);
    if (bytes > 0) {
        std::memcpy(items.data(), raw.data() + sizeof bytes, bytes);
    }
    return items;
}

double number_in(const Array& array) {
    double value = 0.0;
    const auto read =
        std::from_chars(array.content.data(), array.content.data() + array.content.size(), value);
    if (read.ec != std::errc{}) {
        throw std::runtime_error(fmt::format("{} is not a number", array.name));
    }
    return value;
}

std::size_t whole_number_in(const Array& array) {
    constexpr double most = 9007199254740992.0; // 2^53: whole numbers are exact below
    const double value = number_in(array);
    if (!(value >= 0.0 && value <= most)) {
        throw std::runtime_error(fmt::format("{} is not a number of rows", array.name));
    }
    return static_cast<std::size_t>(value);
}

} // namespace

std::string vtu_text(const SectionFields& section) {
    std::vector<double> points;
    for (const SectionPoint& point : section.points) {
        points.insert(points.end(), {point.r, 0.0, point.z});
    }
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets;
    std::vector<std::uint8_t> types;
    std::vector<std::int64_t> part;
    const auto add_cell = [&](auto corners, std::int64_t type, std::int64_t number) {
        connectivity.insert(connectivity.end(), corners.begin(), corners.end());
        offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
        types.push_back(static_cast<std::uint8_t>(type));
        part.push_back(number);
    };
    for (const auto& cell : section.cells) {
        add_cell(cell, vtk_quadrilateral, 0);
    }
    for (const OutlineEdge& edge : section.outline) {
        add_cell(edge.ends, vtk_line, 1 + static_cast<std::int64_t>(edge.kind));
    }
    std::string out = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
                      "<!-- theta = 0: x = r, y along theta, z = z; part: 0 fluid";
    for (std::size_t kind = 0; kind < outline_kind_names.size(); ++kind) {
        out += fmt::format(", {} {}", kind + 1, outline_kind_names[kind]);
    }
    out += " -->\n<FieldData>\n";
    add_number(out, "TimeValue", section.time);
    add_number(out, "row", static_cast<double>(section.row));
    add_number(out, "speed_rad_s", section.speed);
    add_number(out, "yield_stress_Pa", section.yield_stress);
    add_number(out, "rigid_rate_1_s", section.rigid_rate);
    out +=
        fmt::format("</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
                    section.points.size(), types.size());
    add_array(out, "points", 3, points, "m");
    out += "</Points>\n<Cells>\n";
    add_array(out, "connectivity", 1, connectivity);
    add_array(out, "offsets", 1, offsets);
    add_array(out, "types", 1, types);
    out += "</Cells>\n<CellData>\n";
    add_array(out, "part", 1, part);
    out += "</CellData>\n<PointData>\n";
    for (const NodalField& field : section.fields) {
        add_array(out, field.name, field.components, field.values, field.unit);
    }
    out += "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    return out;
}

SectionFields read_vtu_text(std::string_view text) {
    std::size_t at = 0;
    const std::string_view piece = between(text, "<Piece", ">", at);
    const auto count_of = [&](std::string_view name) {
        const std::string digits = attribute_of(piece, name);
        std::size_t count = 0;
        const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), count);
        if (read.ec != std::errc{} || count > text.size()) {
            throw std::runtime_error(fmt::format("not a file of fields: {} is wrong", name));
        }
        return count;
    };
    const std::size_t points = count_of("NumberOfPoints");
    const std::size_t cells = count_of("NumberOfCells");
    SectionFields section;
    const std::vector<Array> data = arrays_in(text, "FieldData");
    section.time = number_in(named(data, "TimeValue"));
    section.row = whole_number_in(named(data, "row"));
    section.speed = number_in(named(data, "speed_rad_s"));
    section.yield_stress = number_in(named(data, "yield_stress_Pa"));
    section.rigid_rate = number_in(named(data, "rigid_rate_1_s"));

    const auto place = decoded<double>(named(arrays_in(text, "Points"), "points"), 3 * points);
    for (std::size_t point = 0; point < points; ++point) {
        section.points.push_back({place[3 * point], place[3 * point + 2]});
    }
    const std::vector<Array> topology = arrays_in(text, "Cells");
    const auto part = decoded<std::int64_t>(named(arrays_in(text, "CellData"), "part"), cells);
    std::size_t corners = 0;
    for (const std::int64_t number : part) {
        corners += number == 0 ? 4 : 2;
    }
    const auto nodes = decoded<std::int64_t>(named(topology, "connectivity"), corners);
    std::size_t next = 0;
    const auto node = [&] {
        const std::int64_t index = nodes[next++];
        if (index < 0 || static_cast<std::size_t>(index) >= points) {
            throw std::runtime_error("a cell of a point that is not there");
        }
        return static_cast<std::uint32_t>(index);
    };
    for (const std::int64_t number : part) {
        if (number == 0) {
            auto& cell = section.cells.emplace_back();
            for (std::uint32_t& corner : cell) {
                corner = node();
            }
        } else {
            if (number < 0 || static_cast<std::size_t>(number) > outline_kind_names.size()) {
                throw std::runtime_error("an outline of an unknown kind");
            }
            OutlineEdge edge{.kind = static_cast<OutlineKind>(number - 1)};
            edge.ends[0] = node();
            edge.ends[1] = node();
            section.outline.push_back(edge);
        }
    }
    for (const Array& array : arrays_in(text, "PointData")) {
        section.fields.push_back({.name = array.name,
                                  .unit = array.unit,
                                  .components = array.components,
                                  .values = decoded<double>(
                                      array, points * static_cast<std::size_t>(array.components))});
    }
    return section;
}

std::string pvd_text(const std::vector<TimedFile>& files) {
    std::string out = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
                      "byte_order=\"LittleEndian\">\n<Collection>\n";
    for (const TimedFile& file : files) {
        out += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", file.time,
                           file.name);
    }
    out += "</Collection>\n</VTKFile>\n";
    return out;
}

} // namespace searle::rheometry::fields
