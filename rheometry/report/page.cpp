#include "rheometry/report/page.hpp"

#include "rheometry/report/page_style.hpp"
#include "rheometry/report/prose.hpp"
#include "rheometry/report/rich_text.hpp"
#include "rheometry/report/svg_style.hpp"

namespace searle::rheometry::report {

std::string page(std::string_view title, const std::string& body) {
    std::string out =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>";
    out += escaped(title);
    out += "</title>\n<style>";
    out += page_style();
    out += figure_style();
    out += "</style>\n</head>\n<body>\n<main>\n";
    out += body;
    out += "</main>\n</body>\n</html>\n";
    return out;
}

std::string page_header(std::string_view kind, std::string_view title, const std::string& lead) {
    return "<header><p class=\"kind\">" + escaped(kind) + "</p><h1>" + escaped(title) +
           "</h1><p class=\"lead\">" + lead + "</p></header>\n";
}

std::string main_results(const std::vector<MainResult>& results) {
    std::string out = "<dl class=\"results\">";
    for (const MainResult& result : results) {
        out += "<div><dt>" + result.name + "</dt><dd>" + result.value;
        if (!result.note.empty()) {
            out += "<span class=\"note\">" + result.note + "</span>";
        }
        out += "</dd></div>";
    }
    return out + "</dl>\n";
}

std::string warning_box(const std::vector<std::string>& warnings) {
    if (warnings.empty()) {
        return "";
    }
    std::string out = "<div class=\"warnings\"><b>";
    out += warnings.size() == 1 ? "Warning" : "Warnings";
    out += "</b><ul>";
    for (const std::string& warning : warnings) {
        out += "<li>" + prose_html(warning) + "</li>";
    }
    return out + "</ul></div>\n";
}

std::string paragraphs(const std::vector<std::string>& texts) {
    std::string out;
    for (const std::string& text : texts) {
        out += "<p>" + prose_html(text) + "</p>\n";
    }
    return out;
}

std::string page_footer(const Provenance& provenance) {
    std::string out;
    const auto add = [&](std::string_view name, const std::string& value, bool code) {
        if (value.empty()) {
            return;
        }
        if (!out.empty()) {
            out += " \u00b7 ";
        }
        out +=
            std::string{name} + (code ? "<code>" : "") + escaped(value) + (code ? "</code>" : "");
    };
    add("Made by Searle ", provenance.program_version, false);
    add("case ", provenance.case_file, true);
    add("hash ", provenance.case_hash, true);
    add("", provenance.created, false);
    return out.empty() ? "" : "<footer>" + out + "</footer>\n";
}

} // namespace searle::rheometry::report
