#pragma once

#include <bit>
#include <cstring>
#include <initializer_list>
#if defined(__AVX512F__) && defined(__AVX512VL__)
#include <immintrin.h>
#endif

namespace searle::solvers::particles {

/// Eight numbers that the compiler keeps in as few registers as the processor allows: for turning
/// rows into columns, which it does not find by itself. Loops over columns need nothing of this.
using Lanes = double __attribute__((vector_size(64)));

inline void load(Lanes& lanes, const double* from) { std::memcpy(&lanes, from, sizeof lanes); }

inline void store(const Lanes& lanes, double* to) { std::memcpy(to, &lanes, sizeof lanes); }

/// Rows into columns: pairs of rows change single numbers, then twos, then fours.
inline void transpose(Lanes (&r)[8]) {
    Lanes a[8];
    for (int k = 0; k < 8; k += 2) {
        a[k] = __builtin_shufflevector(r[k], r[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        a[k + 1] = __builtin_shufflevector(r[k], r[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    Lanes b[8];
    for (const int k : {0, 1, 4, 5}) {
        b[k] = __builtin_shufflevector(a[k], a[k + 2], 0, 1, 8, 9, 4, 5, 12, 13);
        b[k + 2] = __builtin_shufflevector(a[k], a[k + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
    for (int k = 0; k < 4; ++k) {
        r[k] = __builtin_shufflevector(b[k], b[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        r[k + 4] = __builtin_shufflevector(b[k], b[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    }
}

/// Writes those of `count` indices whose value is negative, in their order. May write up to eight
/// places beyond them, and reads as far beyond `count`.
/// @return how many
inline int keep_negative(const double* values, const int* indices, int count, int* to) {
    int found = 0;
#if defined(__AVX512F__) && defined(__AVX512VL__)
    for (int m = 0; m < count; m += 8) {
        const unsigned valid = count - m < 8 ? (1U << (count - m)) - 1U : 0xffU;
        const __mmask8 negative =
            _mm512_mask_cmp_pd_mask(static_cast<__mmask8>(valid), _mm512_loadu_pd(values + m),
                                    _mm512_setzero_pd(), _CMP_LT_OQ);
        const __m256i some = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(indices + m));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(to + found),
                            _mm256_maskz_compress_epi32(negative, some));
        found += std::popcount(static_cast<unsigned>(negative));
    }
#else
    // Writing always and going on sometimes: no branch to guess wrongly.
    for (int m = 0; m < count; ++m) {
        to[found] = indices[m];
        found += values[m] < 0.0 ? 1 : 0;
    }
#endif
    return found;
}

} // namespace searle::solvers::particles
