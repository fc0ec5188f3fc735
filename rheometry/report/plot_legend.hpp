#pragma once

#include "rheometry/report/plot.hpp"
#include "rheometry/report/svg_path.hpp"

#include <string>
#include <vector>

namespace searle::rheometry::report {

/// The legend over a plot: named series, then the kinds of bands, in rows.
class Legend {
public:
    /// Lays the entries out in rows of at most `width` pixels.
    Legend(const Plot& plot, double width);

    [[nodiscard]] double height() const;
    /// Draws the legend with its upper left corner at `corner`.
    void draw(std::string& out, const Plot& plot, Pixel corner) const;

private:
    struct Entry {
        RichText name;
        std::string full_name;
        const Series* series{}; ///< null for a band kind
        std::size_t band_kind{};
        double x{};
        int row{};
    };
    std::vector<Entry> entries_;
    int rows_{};
};

/// Id of the hatch pattern of a band's kind within a plot.
[[nodiscard]] std::string hatch_id(const Plot& plot, int shade);

/// Hatch patterns of all band kinds of the plot, for its <defs>.
void define_hatches(std::string& out, const Plot& plot);

/// A rectangle with the shade and the hatch of a band kind.
void draw_shade(std::string& out, const Plot& plot, const BandKind& kind, Pixel corner,
                double width, double height);

} // namespace searle::rheometry::report
