#pragma once

#include "rheometry/fit/flow_data.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace searle::rheometry {

/// One curve of a file of blocks.
struct CurveBlock {
    std::string name;
    std::vector<fit::MeasuredPoint> points;
};

/// True when the first lines are `number<TAB>text<TAB>anything` and then two numbers with a tab
/// between them.
[[nodiscard]] bool is_block_file(std::span<const std::string_view> lines);

/// Reads all blocks: a line `id<TAB>name[<TAB>code]`, rows `rate<TAB>stress` in 1/s and Pa with
/// decimal points or commas, and an empty line. Throws TableError with every fault.
/// @param file  name for messages
[[nodiscard]] std::vector<CurveBlock> read_curve_blocks(std::span<const std::string_view> lines,
                                                        const std::string& file);

} // namespace searle::rheometry
