#include "app/case_reader.hpp"
#include "tests/fuzz/readers.hpp"
#include "tests/fuzz/temporary_file.hpp"

namespace searle::fuzz {

void read_case(std::string_view bytes) {
    const std::filesystem::path file = file_of(bytes, "case.toml");
    try {
        for (const app::Case& read : app::read_cases(file))
            // What was read can be written and read again.
            static_cast<void>(app::read_cases_text(read.resolved_toml, "resolved.toml"));
    } catch (const app::CaseError&) {
    }
    try {
        static_cast<void>(app::read_mesh_case(file));
    } catch (const app::CaseError&) {
    }
}

} // namespace searle::fuzz
