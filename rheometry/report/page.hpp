#pragma once

#include "rheometry/report/report_input.hpp"

#include <string>
#include <vector>

namespace searle::rheometry::report {

/// A complete HTML document around `body` (HTML), with all styles inside. `title` is plain text.
[[nodiscard]] std::string page(std::string_view title, const std::string& body);

/// The head of a page: what it is, its title, and a lead paragraph (HTML).
[[nodiscard]] std::string page_header(std::string_view kind, std::string_view title,
                                      const std::string& lead);

/// A number with its name, for the strip of main results; value and note are HTML.
struct MainResult {
    std::string name;
    std::string value;
    std::string note;
};
[[nodiscard]] std::string main_results(const std::vector<MainResult>& results);

/// A box with warnings; nothing when there are none.
[[nodiscard]] std::string warning_box(const std::vector<std::string>& warnings);

/// Paragraphs of plain text.
[[nodiscard]] std::string paragraphs(const std::vector<std::string>& texts);

/// Where the result comes from: file, hash, version, date.
[[nodiscard]] std::string page_footer(const Provenance& provenance);

} // namespace searle::rheometry::report
