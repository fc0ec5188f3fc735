#include "casefile/nearest_name.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace searle::casefile {
namespace {

std::string folded(std::string_view text) {
    std::string result{text};
    for (char& sign : result) {
        sign = static_cast<char>(std::tolower(static_cast<unsigned char>(sign)));
        if (sign == '_' || sign == ' ')
            sign = '-';
    }
    return result;
}

} // namespace

int spelling_distance(std::string_view one, std::string_view other) {
    const std::string from = folded(one);
    const std::string to = folded(other);
    const std::size_t width = to.size() + 1;
    std::vector<int> distance((from.size() + 1) * width);
    for (std::size_t column = 0; column < width; ++column)
        distance[column] = static_cast<int>(column);
    for (std::size_t row = 1; row <= from.size(); ++row) {
        distance[row * width] = static_cast<int>(row);
        for (std::size_t column = 1; column < width; ++column) {
            const int replace = from[row - 1] == to[column - 1] ? 0 : 1;
            int best = std::min({distance[(row - 1) * width + column] + 1,
                                 distance[row * width + column - 1] + 1,
                                 distance[(row - 1) * width + column - 1] + replace});
            if (row > 1 && column > 1 && from[row - 1] == to[column - 2] &&
                from[row - 2] == to[column - 1])
                best = std::min(best, distance[(row - 2) * width + column - 2] + 1);
            distance[row * width + column] = best;
        }
    }
    return distance.back();
}

std::optional<std::string> nearest_name(std::string_view meant,
                                        std::span<const std::string> names) {
    constexpr std::size_t longest = 64;
    if (meant.empty() || meant.size() > longest)
        return std::nullopt;
    std::optional<std::string> nearest;
    int smallest = 0;
    for (const std::string& name : names) {
        const int distance = spelling_distance(meant, name);
        const int allowed = std::max(1, static_cast<int>(std::max(meant.size(), name.size())) / 3);
        if (distance <= allowed && (!nearest || distance < smallest)) {
            nearest = name;
            smallest = distance;
        }
    }
    return nearest;
}

} // namespace searle::casefile
