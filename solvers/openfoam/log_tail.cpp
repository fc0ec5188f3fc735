#include "solvers/openfoam/log_tail.hpp"

#include <charconv>
#include <fstream>
#include <sstream>
#include <string_view>

namespace searle::solvers::openfoam {
namespace {

constexpr std::streamoff tail_length = 16384;

std::optional<double> number_after(std::string_view line, std::string_view words) {
    const std::size_t at = line.find(words);
    if (at == std::string_view::npos)
        return std::nullopt;
    double value{};
    const auto [end, error] =
        std::from_chars(line.data() + at + words.size(), line.data() + line.size(), value);
    return error == std::errc{} ? std::optional(value) : std::nullopt;
}

} // namespace

LogTail log_tail(const std::filesystem::path& log) {
    LogTail tail;
    std::ifstream stream(log, std::ios::binary);
    stream.seekg(0, std::ios::end);
    const std::streamoff length = stream.tellg();
    stream.seekg(length > tail_length ? length - tail_length : 0);
    int lines_of_fatal = 0;
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("Time = "))
            tail.time = number_after(line, "Time = ");
        if (const auto courant = number_after(line, "max: ");
            courant && line.starts_with("Courant"))
            tail.courant = courant;
        if (line.find("FOAM FATAL") != std::string::npos)
            lines_of_fatal = 6;
        else if (lines_of_fatal > 0 && !line.empty() && line.find("From ") == std::string::npos) {
            const std::size_t start = line.find_first_not_of(" \t");
            tail.fatal += (tail.fatal.empty() ? "" : " ") +
                          line.substr(start == std::string::npos ? 0 : start);
        }
        lines_of_fatal -= lines_of_fatal > 0 ? 1 : 0;
    }
    return tail;
}

std::string version_in_log(const std::filesystem::path& log) {
    std::ifstream stream(log);
    std::string line;
    for (int lines = 0; lines < 40 && std::getline(stream, line); ++lines) {
        // "Build  : OPENFOAM=1912 patch=200626", or of others "Build  : 8-1c9b5879390b".
        if (!line.starts_with("Build "))
            continue;
        const std::size_t colon = line.find(": ");
        std::string value = colon == std::string::npos ? "" : line.substr(colon + 2);
        constexpr std::string_view name = "OPENFOAM=";
        if (value.starts_with(name))
            value.erase(0, name.size());
        return value.substr(0, value.find(' '));
    }
    return "";
}

} // namespace searle::solvers::openfoam
