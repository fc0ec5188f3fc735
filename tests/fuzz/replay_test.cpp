#include "places.hpp"
#include "tests/fuzz/readers.hpp"
#include "tests/fuzz/temporary_file.hpp"

#include <gtest/gtest.h>

#include <iterator>
#include <ostream>

namespace searle::fuzz {

/// For the names of the tests.
static std::ostream& operator<<(std::ostream& stream, const Reader& reader) {
    return stream << reader.name;
}

namespace {

namespace fs = std::filesystem;

class FuzzInputs : public ::testing::TestWithParam<Reader> {
protected:
    ~FuzzInputs() override {
        std::error_code ignored;
        fs::remove_all(temporary_folder(), ignored);
    }
};

/// Seeds and former findings are read, or refused with the reader's own message.
TEST_P(FuzzInputs, are_read_or_refused) {
    const Reader& reader = GetParam();
    int count = 0;
    for (const char* kind : {"corpus", "regressions"}) {
        const fs::path folder =
            fs::path(SEARLE_SOURCE_DIR) / "tests/fuzz" / kind / std::string(reader.name);
        if (!fs::is_directory(folder))
            continue;
        for (const auto& entry : fs::directory_iterator(folder)) {
            std::ifstream stream(entry.path(), std::ios::binary);
            const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
            SCOPED_TRACE(entry.path().string());
            EXPECT_NO_THROW(reader.read(bytes));
            ++count;
        }
    }
    EXPECT_GT(count, 0) << "no seeds in tests/fuzz/corpus/" << reader.name;
}

INSTANTIATE_TEST_SUITE_P(Readers, FuzzInputs, ::testing::ValuesIn(readers),
                         [](const auto& reader) { return std::string(reader.param.name); });

} // namespace
} // namespace searle::fuzz
