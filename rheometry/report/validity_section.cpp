#include "rheometry/report/validity_section.hpp"

#include "rheometry/report/number_text.hpp"
#include "rheometry/report/prose.hpp"
#include "rheometry/report/regime_shading.hpp"
#include "rheometry/report/rich_text.hpp"

#include <map>

namespace searle::rheometry::report {

namespace {

std::string sentence(std::string text) {
    const bool ended =
        text.empty() || text.back() == '.' || text.back() == '!' || text.back() == '?';
    return ended ? text : text + ".";
}

std::string row(std::string_view what, std::string_view verdict, bool solved,
                const std::string& reason_html) {
    return "<tr><th scope=\"row\">" + escaped(what) + "</th><td class=\"" +
           (solved ? "yes" : "no") + "\">" + std::string{verdict} + "</td><td>" + reason_html +
           "</td></tr>\n";
}

std::string vortex_text(const VortexOnset& onset) {
    const double ratio = onset.reynolds / onset.critical_reynolds;
    std::string out = "Re = " + significant(onset.reynolds, 4) +
                      " at the highest speed, onset at Re<sub>c</sub> = " +
                      significant(onset.critical_reynolds, 6) +
                      " (Re/Re<sub>c</sub> = " + significant(ratio, 3) + ")";
    if (onset.critical_shear_rate > 0.0) {
        out += ", that is at " + quantity_text(onset.critical_shear_rate, "1/s", 4);
    }
    if (onset.wave_number > 0.0) {
        out += "; axial wave number <i>k d</i> = " + significant(onset.wave_number, 4);
    }
    out += ". ";
    if (!onset.basis.empty()) {
        out += prose_html(sentence(onset.basis)) + " ";
    }
    return out + "Re = <i>R</i><sub>bob</sub> <i>\u03c9 d</i>/<i>\u03bd</i>.";
}

std::string regime_counts(const Rheogram& rheogram) {
    std::map<std::string, std::size_t> counts;
    for (const RheogramPoint& point : rheogram.points) {
        for (const std::string& name : regime_names(point.regime)) {
            ++counts[name];
        }
    }
    std::string out;
    for (const auto& [name, count] : counts) {
        if (!out.empty()) {
            out += ", ";
        }
        out += escaped(regime_label(name)) + " " + std::to_string(count);
    }
    return out;
}

} // namespace

bool has_validity(const ReportInput& input) {
    return !input.validity.empty() || input.vortex_onset.has_value();
}

std::string validity_section(const ReportInput& input, int table_number) {
    if (!has_validity(input)) {
        return "";
    }
    std::string out =
        "<div class=\"table\"><table class=\"properties validity\"><caption><b>Table " +
        std::to_string(table_number) + ".</b> What was solved, and what was left out and why.";
    const std::string counts = regime_counts(input.rheogram);
    if (!counts.empty()) {
        out += " Points by regime: " + counts + ".";
    }
    out += "</caption><tbody>\n";
    for (const ValidityNote& note : input.validity) {
        out += row(note.what, note.solved ? "\u2713\u00a0solved" : "\u25cb\u00a0left out",
                   note.solved, prose_html(sentence(note.reason)));
    }
    if (input.vortex_onset) {
        out += row("Onset of Taylor vortices", "", false, vortex_text(*input.vortex_onset));
    }
    return out + "</tbody></table></div>\n";
}

} // namespace searle::rheometry::report
