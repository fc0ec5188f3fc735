#include "tests/fuzz/readers.hpp"

#include <cstddef>
#include <cstdint>

// One program a reader; SEARLE_FUZZED is its function.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    searle::fuzz::SEARLE_FUZZED({reinterpret_cast<const char*>(data), size});
    return 0;
}
