#include "rheometry/tables/flow_curves.hpp"
#include "tests/fuzz/readers.hpp"
#include "tests/fuzz/temporary_file.hpp"

namespace searle::fuzz {

void read_curves(std::string_view bytes) {
    const std::filesystem::path file = file_of(bytes, "curves.txt");
    for (const auto& deviation : {std::optional<std::string>(), std::optional<std::string>("sd")})
        try {
            static_cast<void>(rheometry::read_flow_curves(file, deviation));
        } catch (const rheometry::TableError&) {
        }
}

} // namespace searle::fuzz
