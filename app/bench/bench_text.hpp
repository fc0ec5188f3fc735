#pragma once

#include "app/bench/measurement.hpp"

#include <string>

namespace searle::app::bench {

/// The result as a table for the terminal.
[[nodiscard]] std::string bench_text(const BenchResult& result);

/// bench.csv: one row a point.
[[nodiscard]] std::string bench_csv(const BenchResult& result);

/// The result as JSON (`searle bench --json`, bench.json).
[[nodiscard]] std::string bench_json(const BenchResult& result);

/// The README's table between its markers: error and time against the peers.
[[nodiscard]] std::string readme_block(const BenchResult& result);

inline constexpr const char* readme_begin = "<!-- made by `searle bench --readme`: begin -->";
inline constexpr const char* readme_end = "<!-- made by `searle bench --readme`: end -->";

/// docs/benchmarks.md's tables: every point of every scene.
[[nodiscard]] std::string benchmark_tables(const BenchResult& result);

/// bench.html: the curves and tables, self-contained.
[[nodiscard]] std::string bench_page(const BenchResult& result);

/// "12.3 ms": CPU time with three digits.
[[nodiscard]] std::string time_text(double seconds);
[[nodiscard]] std::string error_text(double error);

} // namespace searle::app::bench
