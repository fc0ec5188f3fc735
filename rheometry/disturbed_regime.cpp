#include "rheometry/disturbed_regime.hpp"

#include <array>

namespace searle::rheometry {

std::string_view disturbance_in(std::string_view regime) {
    constexpr std::array<std::string_view, 3> disturbances{"lag", "taylor-vortices", "end-flow"};
    for (const std::string_view disturbance : disturbances) {
        std::string_view rest = regime;
        while (!rest.empty()) {
            const std::size_t end = rest.find('+');
            if (rest.substr(0, end) == disturbance)
                return disturbance;
            rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        }
    }
    return {};
}

} // namespace searle::rheometry
