#include "tests/fuzz/readers.hpp"
#include "tests/fuzz/readers/measured_file.hpp"
#include "tests/fuzz/temporary_file.hpp"

namespace searle::fuzz {

void read_xls(std::string_view bytes) { read_measured_file(file_of(bytes, "workbook.xls")); }

} // namespace searle::fuzz
