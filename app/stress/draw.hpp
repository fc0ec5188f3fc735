#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>

namespace searle::app {

/// The next number of SplitMix64 (Steele, Lea & Flood 2014).
inline std::uint64_t split_mix(std::uint64_t& state) {
    state += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
}

/// Random numbers that are the same everywhere: those of the
/// standard library's distributions differ from one library to the next.
class Draw {
public:
    Draw(std::uint64_t seed, std::uint64_t number) : state_(seed * 0x9e3779b97f4a7c15ULL + number) {
        (void)bits();
        state_ ^= number << 32U;
    }

    std::uint64_t bits() { return split_mix(state_); }
    /// 0 <= value < 1.
    double unit() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    /// Uniform in the logarithm.
    double log_between(double low, double high) { return low * std::pow(high / low, unit()); }
    int integer(int low, int high) {
        return low + static_cast<int>(unit() * static_cast<double>(high - low + 1));
    }
    bool chance(double probability) { return unit() < probability; }
    template <class T>
    T one_of(std::initializer_list<T> choices) {
        return *(choices.begin() + integer(0, static_cast<int>(choices.size()) - 1));
    }

private:
    std::uint64_t state_;
};

} // namespace searle::app
