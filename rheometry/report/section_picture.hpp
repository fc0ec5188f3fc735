#pragma once

#include "rheometry/fields/section_fields.hpp"
#include "rheometry/report/plot.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace searle::rheometry::report {

/// Lines of constant value of a scalar field, drawn over the colours.
struct ContourLines {
    std::string field; ///< name of a NodalField with one component
    std::vector<double> levels;
    /// Style of the line, as in svg_style: "yield-surface", "streamline".
    std::string css_class;
    bool dashes_negative = false; ///< levels below zero dashed: flow that turns the other way
};

/// A part of the half-plane, m.
struct SectionWindow {
    double r_low{}, r_high{}, z_low{}, z_high{};
};

/// One scalar as colours on the section, with a labelled colour scale, the outline of the
/// instrument, and contour lines. Lengths are to scale.
struct SectionPicture {
    const fields::SectionFields* section{}; ///< not null
    std::string field{};                    ///< name of a NodalField with one component
    RichText name{};                        ///< for the colour scale, with the unit
    Scale scale = Scale::logarithmic;
    std::optional<double> low{};  ///< ends of the colour scale; absent: from the field, without
    std::optional<double> high{}; ///< the extremes that fill less than 0.5 % of the area
    std::vector<ContourLines> lines{};
    /// Where not empty: the part of the section below `blank_below` in this field is shaded as
    /// rigid (the field shear_rate and SectionFields::rigid_rate).
    std::string blank_field{};
    double blank_below{};
    std::optional<SectionWindow> window{}; ///< absent: the whole section
    std::string id{};                      ///< unique within a page: letters, digits, hyphens
    std::string title{};                   ///< what a screen reader says
    std::string letter{};                  ///< "a" for panel (a); empty: none
    double width = 480.0;                  ///< pixels, colour scale included
    double most_height = 560.0;            ///< pixels
};

/// Draws it as an <svg> element that needs figure_style() in the page. A field that is missing or
/// nowhere finite gives the outline alone.
[[nodiscard]] std::string draw(const SectionPicture& picture);

/// Levels for contour lines of a field that changes sign or not: `count` of them, evenly between
/// the extremes, both left out.
[[nodiscard]] std::vector<double> even_levels(const fields::SectionFields& section,
                                              std::string_view field, int count);

} // namespace searle::rheometry::report
