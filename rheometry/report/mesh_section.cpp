#include "rheometry/report/mesh_section.hpp"

#include "rheometry/report/property_rows.hpp"
#include "rheometry/report/prose.hpp"
#include "rheometry/report/rich_text.hpp"

namespace searle::rheometry::report {

std::string mesh_section(const MeshDescription& mesh, int figure, int table) {
    std::string out = "<h2>Mesh</h2>\n<figure class=\"mesh\">" + mesh.picture +
                      "<figcaption><b>Figure " + std::to_string(figure) + ".</b> " +
                      prose_html(mesh.caption) + "</figcaption></figure>\n";
    std::vector<PropertyRow> rows;
    for (const Fact& fact : mesh.facts) {
        rows.push_back({escaped(fact.name), "", prose_html(fact.value)});
    }
    out += property_table(rows, "<b>Table " + std::to_string(table) + ".</b> The mesh, checked.");
    return out;
}

} // namespace searle::rheometry::report
