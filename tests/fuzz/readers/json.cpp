#include "tests/fuzz/readers.hpp"
#include "tests/fuzz/readers/measured_file.hpp"
#include "tests/fuzz/temporary_file.hpp"

namespace searle::fuzz {

void read_json(std::string_view bytes) { read_measured_file(file_of(bytes, "export.json")); }

} // namespace searle::fuzz
