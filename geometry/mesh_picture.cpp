#include "geometry/mesh_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace searle::geometry {
namespace {

constexpr double panel_height = 640;
constexpr double most_panel_width = 560;
/// A section that would be narrower is stretched across.
constexpr double least_panel_width = 110;
constexpr double margin = 24;
constexpr double title_height = 34;
constexpr double legend_width = 170;
/// Widest detail, in gaps.
constexpr double most_detail = 8.0;
/// More lines than this are one grey area at any size of screen.
constexpr std::size_t most_lines = 400'000;

// Colours that stay apart for colour-blind readers (Okabe and Ito). A name has the same colour in
// every picture; names that are not listed take the last ones in turn.
struct NamedColour {
    std::string_view patch;
    const char* colour;
};
constexpr std::array named_colours{
    NamedColour{"bob", "#d55e00"},          NamedColour{"bob_inner", "#d55e00"},
    NamedColour{"bob_outer", "#8c564b"},    NamedColour{"bob_cone", "#e69f00"},
    NamedColour{"bob_edge", "#e69f00"},     NamedColour{"bob_top", "#cc79a7"},
    NamedColour{"shaft", "#8c564b"},        NamedColour{"cup", "#0072b2"},
    NamedColour{"cup_floor", "#009e73"},    NamedColour{"post", "#000000"},
    NamedColour{"free_surface", "#56b4e9"}, NamedColour{"axis", "#000000"},
    NamedColour{"slice_bottom", "#009e73"}, NamedColour{"slice_top", "#56b4e9"}};
constexpr std::array further_colours{"#cc79a7", "#8c564b", "#f0e442", "#7f7f7f"};

const char* colour_of(std::string_view patch, std::size_t number) {
    for (const NamedColour& named : named_colours)
        if (named.patch == patch)
            return named.colour;
    return further_colours[number % further_colours.size()];
}

struct Window {
    double left{};
    double bottom{};
    double width{};
    double height{};

    [[nodiscard]] bool meets(const Point& a, const Point& b) const {
        const double rounding = 1e-9 * (width + height);
        return std::max(a.x, b.x) >= left - rounding &&
               std::min(a.x, b.x) <= left + width + rounding &&
               std::max(a.y, b.y) >= bottom - rounding &&
               std::min(a.y, b.y) <= bottom + height + rounding;
    }
};

/// One view of the section on the page.
class Panel {
public:
    Panel(const Mesh& mesh, const Window& window, double x, int number)
        : mesh_{mesh}, window_{window}, x_{x}, number_{number},
          scale_{std::min(panel_height / window.height, most_panel_width / window.width)},
          stretch_{std::max(1.0, least_panel_width / (scale_ * window.width))} {}

    [[nodiscard]] double width() const { return scale_ * stretch_ * window_.width; }
    /// Of lengths across over lengths along; 1: to scale.
    [[nodiscard]] double stretch() const { return stretch_; }
    [[nodiscard]] double height() const { return scale_ * window_.height; }
    [[nodiscard]] double scale() const { return scale_; }

    [[nodiscard]] std::string svg() const {
        std::string text = fmt::format(
            "<clipPath id=\"mesh-panel{0}\"><rect x=\"{1:.2f}\" y=\"{2:.2f}\" width=\"{3:.2f}\" "
            "height=\"{4:.2f}\"/></clipPath>\n<g clip-path=\"url(#mesh-panel{0})\">\n",
            number_, x_ - 3, title_height - 3, width() + 6, height() + 6);
        text += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#555\" stroke-width=\"0.5\"/>\n",
                            grid());
        for (std::size_t patch = 0; patch < mesh_.patches.size(); ++patch)
            text += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"3\" "
                                "stroke-linecap=\"round\"/>\n",
                                side(mesh_.patches[patch]),
                                colour_of(mesh_.patches[patch].name, patch));
        return text + "</g>\n";
    }
    /// The rectangle that another window covers here.
    [[nodiscard]] std::string frame(const Window& other) const {
        return fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
                           "fill=\"none\" stroke=\"#c00\" stroke-width=\"1\"/>\n",
                           x_at(other.left), y_at(other.bottom + other.height),
                           scale_ * stretch_ * other.width, scale_ * other.height);
    }

private:
    [[nodiscard]] double x_at(double r) const {
        return x_ + scale_ * stretch_ * (r - window_.left);
    }
    [[nodiscard]] double y_at(double z) const {
        return title_height + scale_ * (window_.bottom + window_.height - z);
    }
    void add_line(std::string& path, std::uint32_t from, std::uint32_t to) const {
        const Point& a = mesh_.points[from];
        const Point& b = mesh_.points[to];
        if (window_.meets(a, b))
            fmt::format_to(std::back_inserter(path), "M{:.2f} {:.2f}L{:.2f} {:.2f}", x_at(a.x),
                           y_at(a.y), x_at(b.x), y_at(b.y));
    }
    [[nodiscard]] std::string grid() const {
        std::string path;
        std::unordered_set<std::uint64_t> drawn;
        for (std::size_t cell = 0; cell < mesh_.cells.size() && drawn.size() < most_lines; ++cell) {
            const auto corners = mesh_.cells.corners(cell);
            for (std::size_t at = 0; at < corners.size(); ++at) {
                const std::uint32_t one = corners[at];
                const std::uint32_t two = corners[(at + 1) % corners.size()];
                const std::uint64_t key =
                    (static_cast<std::uint64_t>(std::min(one, two)) << 32) | std::max(one, two);
                if (drawn.insert(key).second)
                    add_line(path, one, two);
            }
        }
        return path;
    }
    [[nodiscard]] std::string side(const Patch& patch) const {
        std::string path;
        for (std::size_t face = patch.first; face < patch.first + patch.count; ++face)
            add_line(path, mesh_.faces.nodes(face)[0], mesh_.faces.nodes(face)[1]);
        return path;
    }

    const Mesh& mesh_;
    Window window_;
    double x_;
    int number_;
    double scale_;
    double stretch_;
};

Window whole_of(const Mesh& mesh) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    double left = infinite;
    double right = -infinite;
    double bottom = infinite;
    double top = -infinite;
    for (const Point& point : mesh.points) {
        left = std::min(left, point.x);
        right = std::max(right, point.x);
        bottom = std::min(bottom, point.y);
        top = std::max(top, point.y);
    }
    return {left, bottom, right - left, top - bottom};
}

/// The lower end of the patch "bob" (of the first patch where there is none).
Point lower_edge(const Mesh& mesh) {
    const Patch* bob = mesh.patch("bob");
    if (bob == nullptr)
        bob = mesh.patch("bob_inner");
    const Patch& patch = bob != nullptr ? *bob : mesh.patches.front();
    Point lowest = mesh.points[mesh.faces.nodes(patch.first)[0]];
    for (std::size_t face = patch.first; face < patch.first + patch.count; ++face)
        for (const std::uint32_t node : mesh.faces.corners(face)) {
            const Point& point = mesh.points[node];
            if (point.y < lowest.y || (point.y == lowest.y && point.x > lowest.x))
                lowest = point;
        }
    return lowest;
}

Window detail_of(const Point& around, double gap, const Window& whole) {
    // Both gaps of a thin double gap, else one with what is beside it.
    const double width = whole.width <= most_detail * gap ? whole.width : 2.2 * gap;
    const double height = std::min(1.2 * width, whole.height);
    const double left =
        std::clamp(around.x - 0.45 * width, whole.left, whole.left + whole.width - width);
    const double bottom =
        std::clamp(around.y - 0.5 * height, whole.bottom, whole.bottom + whole.height - height);
    return {left, bottom, width, height};
}

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char letter : text)
        switch (letter) {
        case '<':
            safe += "&lt;";
            break;
        case '>':
            safe += "&gt;";
            break;
        case '&':
            safe += "&amp;";
            break;
        default:
            safe += letter;
        }
    return safe;
}

std::string legend(const Mesh& mesh, double x) {
    std::string text;
    for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch) {
        const double y = title_height + 14 + 22 * static_cast<double>(patch);
        text += fmt::format("<path d=\"M{:.1f} {:.1f}h24\" stroke=\"{}\" stroke-width=\"4\"/>"
                            "<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                            x, y, colour_of(mesh.patches[patch].name, patch), x + 32, y + 5,
                            escaped(mesh.patches[patch].name));
    }
    return text;
}

} // namespace

std::string mesh_picture(const Mesh& section, double gap, const std::string& title,
                         std::optional<Point> around) {
    const Window whole = whole_of(section);
    const Window detail = detail_of(around ? *around : lower_edge(section), gap, whole);
    const Panel first{section, whole, margin, 1};
    const double second_x = 2 * margin + std::max(first.width(), 120.0);
    const Panel second{section, detail, second_x, 2};
    const double legend_x = second_x + second.width() + margin;
    const double width = legend_x + legend_width;
    const double height = title_height + std::max(first.height(), second.height()) + 2 * margin;
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"14\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
        "<text x=\"{2}\" y=\"22\" font-size=\"16\">{3}</text>\n",
        width, height, margin, escaped(title));
    text += first.svg() + first.frame(detail) + second.svg() + legend(section, legend_x);
    const double below = title_height + second.height() + 20;
    text += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\">magnified {:.3g} times; {:.4g} mm wide{}"
        "</text>\n",
        second_x, below, second.scale() / first.scale(), detail.width * 1e3,
        first.stretch() > 1.0
            ? fmt::format("; on the left widths are stretched {:.3g} times", first.stretch())
            : "");
    return text + "</svg>\n";
}

} // namespace searle::geometry
