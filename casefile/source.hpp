#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace searle::casefile {

/// A text that values come from: a case file, or one `--set key=value`.
struct Source {
    std::string name;               ///< path as the user gave it, or "--set key=value"
    std::vector<std::string> lines; ///< without line ends; one line for an override
    bool is_file = true;

    [[nodiscard]] static std::shared_ptr<const Source> of_file(std::string name,
                                                               std::string_view text);
    [[nodiscard]] static std::shared_ptr<const Source> of_override(std::string_view assignment);
};

/// A stretch of one line of a source. Line and column count from 1 (columns in characters); line 0
/// means the source as a whole.
struct Place {
    std::shared_ptr<const Source> source;
    int line{};
    int column{};
    int length = 1; ///< characters to underline, >= 1
};

} // namespace searle::casefile
