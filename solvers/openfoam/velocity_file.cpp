// Format: OpenFOAM v1912, a volVectorField in ASCII: among other entries
//     internalField nonuniform List<vector> N ( (x y z) (x y z) ... );

#include "solvers/openfoam/velocity_file.hpp"

#include "solvers/openfoam/file_text.hpp"

#include <charconv>

namespace searle::solvers::openfoam {

namespace fs = std::filesystem;

std::vector<geometry::Point> velocity_at(const fs::path& folder, const std::string& time,
                                         std::size_t cells) {
    const std::string text = text_of(folder / time / "U");
    const std::size_t field = text.find("internalField");
    const std::size_t open = text.find("\n(\n", field == std::string::npos ? 0 : field);
    std::vector<geometry::Point> velocity;
    if (field == std::string::npos || open == std::string::npos ||
        text.find("nonuniform", field) > open)
        return velocity;
    velocity.reserve(cells);
    const char* at = text.data() + open + 3;
    const char* const end = text.data() + text.size();
    for (std::size_t cell = 0; cell < cells; ++cell) {
        double value[3]{};
        for (double& component : value) {
            while (at < end && (*at == ' ' || *at == '(' || *at == ')' || *at == '\n'))
                ++at;
            const auto [next, error] = std::from_chars(at, end, component);
            if (error != std::errc{})
                return {};
            at = next;
        }
        velocity.push_back({value[0], value[1], value[2]});
    }
    return velocity;
}

} // namespace searle::solvers::openfoam
