#include "app/case_reader.hpp"
#include "tests/fuzz/readers.hpp"
#include "tests/fuzz/temporary_file.hpp"

namespace searle::fuzz {

void read_case(std::string_view bytes) {
    const std::filesystem::path file = file_of(bytes, "case.toml");
    try {
        // What was read can be written and read again.
        const std::vector<app::Case> cases = app::read_cases(file);
        static_cast<void>(app::read_cases_text(cases.front().resolved_toml, "resolved.toml"));
    } catch (const app::CaseError&) {
    }
    try {
        static_cast<void>(app::read_mesh_case(file));
    } catch (const app::CaseError&) {
    }
}

} // namespace searle::fuzz
