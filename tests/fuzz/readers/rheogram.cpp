#include "rheometry/rheogram_csv.hpp"
#include "rheometry/tables/table_error.hpp"
#include "tests/fuzz/readers.hpp"
#include "tests/fuzz/temporary_file.hpp"

namespace searle::fuzz {

void read_rheogram(std::string_view bytes) {
    try {
        static_cast<void>(rheometry::read_rheogram_csv(file_of(bytes, "rheogram.csv")));
    } catch (const rheometry::TableError&) {
    }
}

} // namespace searle::fuzz
