#include "rheometry/tables/measured_data.hpp"
#include "tests/fuzz/readers.hpp"

namespace searle::fuzz {

void read_measured(std::string_view bytes) {
    for (const auto motion : {rheometry::DriveMotion::turning, rheometry::DriveMotion::sliding})
        try {
            static_cast<void>(rheometry::measured_from_table(
                rheometry::CsvTable::parse(bytes, "data.csv"), motion));
        } catch (const rheometry::TableError&) {
        }
}

} // namespace searle::fuzz
