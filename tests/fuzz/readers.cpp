#include "app/case_reader.hpp"
#include "app/checkpoint_file.hpp"
#include "rheometry/rheogram_csv.hpp"
#include "rheometry/tables/measured_data.hpp"
#include "solvers/openfoam/moment_file.hpp"
#include "tests/fuzz/harness.hpp"

namespace searle::fuzz {

void read_case_file(std::string_view bytes) {
    try {
        static_cast<void>(app::read_cases_text(bytes, "case.toml"));
    } catch (const app::CaseError&) {
    }
}

void read_measured_csv(std::string_view bytes) {
    for (const auto motion : {rheometry::DriveMotion::turning, rheometry::DriveMotion::sliding})
        try {
            static_cast<void>(rheometry::measured_from_table(
                rheometry::CsvTable::parse(bytes, "data.csv"), motion));
        } catch (const rheometry::TableError&) {
        }
}

void read_measured_json(std::string_view bytes) {
    try {
        static_cast<void>(rheometry::read_measured_data(file_of(bytes, "export.json"),
                                                        rheometry::DriveMotion::turning));
    } catch (const rheometry::TableError&) {
    }
}

void read_rheogram(std::string_view bytes) {
    try {
        static_cast<void>(rheometry::read_rheogram_csv(file_of(bytes, "rheogram.csv")));
    } catch (const rheometry::TableError&) {
    }
}

void read_moments(std::string_view bytes) {
    const auto file = file_of(bytes, "rotor/0/moment.dat");
    file_of(bytes, "rotor/0/force.dat");
    const auto folder = file.parent_path().parent_path();
    for (const auto component :
         {solvers::openfoam::LoadComponent::moment_z, solvers::openfoam::LoadComponent::force_x})
        static_cast<void>(solvers::openfoam::load_history(folder, component));
}

void read_checkpoint_file(std::string_view bytes) {
    try {
        static_cast<void>(
            app::read_checkpoint(file_of(bytes, "checkpoint.h5"), "0123456789abcdef"));
    } catch (const app::CheckpointError&) {
    }
}

} // namespace searle::fuzz
