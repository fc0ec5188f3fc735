#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace searle::solvers::particles {

/// Random numbers by counting: the same key and counter give the same number on every machine, in
/// any order. Mixing after Steele, Lea & Flood 2014 (SplitMix64).
[[nodiscard]] inline std::uint64_t mixed(std::uint64_t value) {
    value += 0x9e3779b97f4a7c15ULL;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
    value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
    return value ^ (value >> 31);
}

/// 0 < number < 1.
[[nodiscard]] inline double uniform(std::uint64_t key, std::uint64_t counter) {
    const std::uint64_t bits = mixed(mixed(key) ^ mixed(counter * 0xd1342543de82ef95ULL + 1));
    return (static_cast<double>(bits >> 11) + 0.5) * 0x1.0p-53;
}

/// Mean 0, variance 1 (Box & Muller 1958); uses the counters 2 n and 2 n + 1.
[[nodiscard]] inline double normal(std::uint64_t key, std::uint64_t n) {
    const double radius = std::sqrt(-2.0 * std::log(uniform(key, 2 * n)));
    return radius * std::cos(2.0 * std::numbers::pi * uniform(key, 2 * n + 1));
}

} // namespace searle::solvers::particles
