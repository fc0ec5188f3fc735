// Format: OpenFOAM v1912, function object `forces`: a line a time step,
//     time  (total)  (pressure)  (viscous)
// each a vector; lines that open with '#' are comments.

#include "solvers/openfoam/moment_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>

namespace searle::solvers::openfoam {
namespace {

namespace fs = std::filesystem;

std::optional<double> number_from(std::string_view& text) {
    const std::size_t start = text.find_first_not_of(" \t(");
    if (start == std::string_view::npos)
        return std::nullopt;
    text.remove_prefix(start);
    double value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{})
        return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

std::optional<LoadSample> sample_of(std::string_view line, LoadComponent component) {
    if (line.empty() || line.front() == '#' || std::ranges::count(line, ')') != 3)
        return std::nullopt;
    const auto time = number_from(line);
    const auto x = time ? number_from(line) : std::nullopt;
    const auto y = x ? number_from(line) : std::nullopt;
    const auto z = y ? number_from(line) : std::nullopt;
    if (!z)
        return std::nullopt;
    return LoadSample{*time, component == LoadComponent::moment_z ? *z : *x};
}

std::optional<double> number_of(const std::string& name) {
    double value{};
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), value);
    if (error != std::errc{} || end != name.data() + name.size() || !std::isfinite(value))
        return std::nullopt; // "nan" has no place in an order
    return value;
}

std::vector<LoadSample> samples_from(std::istream& stream, LoadComponent component) {
    std::vector<LoadSample> samples;
    for (std::string line; std::getline(stream, line);)
        if (const auto sample = sample_of(line, component))
            samples.push_back(*sample);
    return samples;
}

std::vector<LoadSample> samples_in(const fs::path& file, LoadComponent component) {
    std::ifstream stream(file);
    return samples_from(stream, component);
}

std::string_view file_name(LoadComponent component) {
    return component == LoadComponent::moment_z ? "moment.dat" : "force.dat";
}

} // namespace

std::vector<LoadSample> load_history(const fs::path& object_folder, LoadComponent component) {
    std::vector<std::pair<double, fs::path>> starts;
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(object_folder, missing))
        if (const auto time = number_of(entry.path().filename().string()))
            starts.emplace_back(*time, entry.path());
    std::ranges::sort(starts);
    std::vector<LoadSample> all;
    for (const auto& [start, folder] : starts) {
        while (!all.empty() && all.back().time > start * (1 + 1e-12))
            all.pop_back();
        const std::vector<LoadSample> part = samples_in(folder / file_name(component), component);
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

std::vector<LoadSample> last_loads(const fs::path& object_folder, std::string_view start,
                                   LoadComponent component, int count) {
    constexpr std::streamoff line_length = 256; // a time, nine numbers of 22 characters, brackets
    std::ifstream stream(object_folder / start / file_name(component), std::ios::binary);
    stream.seekg(0, std::ios::end);
    const std::streamoff length = stream.tellg();
    const std::streamoff from = length - count * line_length;
    stream.seekg(std::max<std::streamoff>(0, from));
    if (std::string half_a_line; from > 0)
        std::getline(stream, half_a_line);
    return samples_from(stream, component);
}

} // namespace searle::solvers::openfoam
