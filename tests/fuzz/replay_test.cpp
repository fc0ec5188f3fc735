#include "places.hpp"
#include "tests/fuzz/harness.hpp"

#include <gtest/gtest.h>

#include <iterator>

namespace searle::fuzz {
namespace {

/// Every kept input, seeds and former findings, is read or refused with the reader's own message.
TEST(FuzzInputs, are_read_or_refused) {
    for (const Reader& reader : readers) {
        int count = 0;
        const std::filesystem::path folder =
            std::filesystem::path(SEARLE_SOURCE_DIR) / "tests/fuzz/inputs" / reader.name;
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            std::ifstream stream(entry.path(), std::ios::binary);
            const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
            SCOPED_TRACE(entry.path().string());
            EXPECT_NO_THROW(reader.read(bytes));
            ++count;
        }
        EXPECT_GT(count, 0) << reader.name;
    }
    std::filesystem::remove_all(file_of("", "none").parent_path());
}

} // namespace
} // namespace searle::fuzz
