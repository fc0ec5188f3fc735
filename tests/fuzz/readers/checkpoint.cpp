#include "app/stored_columns.hpp"
#include "tests/fuzz/readers.hpp"
#include "tests/fuzz/temporary_file.hpp"

namespace searle::fuzz {

void read_checkpoint(std::string_view bytes) {
    static_cast<void>(app::read_columns(file_of(bytes, "checkpoint.h5")));
}

} // namespace searle::fuzz
