#include "rheometry/fields/vtu_text.hpp"
#include "tests/fuzz/readers.hpp"

#include <stdexcept>

namespace searle::fuzz {

void read_fields(std::string_view bytes) {
    try {
        const auto section = rheometry::fields::read_vtu_text(bytes);
        static_cast<void>(rheometry::fields::vtu_text(section));
    } catch (const std::runtime_error&) {
    }
}

} // namespace searle::fuzz
