#include "rheometry/end_effect.hpp"
#include "rheometry/tables/table_error.hpp"
#include "tests/fuzz/readers.hpp"
#include "tests/fuzz/temporary_file.hpp"

namespace searle::fuzz {

void read_ends(std::string_view bytes) {
    try {
        static_cast<void>(rheometry::read_end_effect_csv(file_of(bytes, "end_factor.csv")));
    } catch (const rheometry::TableError&) {
    }
}

} // namespace searle::fuzz
