#include "casefile/source.hpp"

#include <fmt/format.h>

namespace searle::casefile {

std::shared_ptr<const Source> Source::of_file(std::string name, std::string_view text) {
    Source source{std::move(name), {}, true};
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        source.lines.emplace_back(line);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return std::make_shared<const Source>(std::move(source));
}

std::shared_ptr<const Source> Source::of_override(std::string_view assignment) {
    return std::make_shared<const Source>(
        Source{fmt::format("--set {}", assignment), {std::string{assignment}}, false});
}

} // namespace searle::casefile
