#include "tests/fuzz/readers.hpp"

#include <cstddef>
#include <cstdint>

// One program a reader; SEARLE_FUZZED is its function.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    searle::fuzz::SEARLE_FUZZED({reinterpret_cast<const char*>(data), size});
    return 0;
}

// The lexer of the unit database (udunits 2.2.28) leaks the word that it stops at.
extern "C" const char* __lsan_default_suppressions() { // NOLINT(bugprone-reserved-identifier)
    return "leak:utlex\n";
}
