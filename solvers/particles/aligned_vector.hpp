#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace searle::solvers::particles {

/// Memory that starts on a cache line, for loops over whole vector registers.
template <class Value>
struct CacheLineAllocator {
    using value_type = Value;
    static constexpr std::align_val_t alignment{64};

    CacheLineAllocator() = default;
    template <class Other>
    explicit CacheLineAllocator(const CacheLineAllocator<Other>&) {}

    [[nodiscard]] Value* allocate(std::size_t count) {
        return static_cast<Value*>(::operator new(count * sizeof(Value), alignment));
    }
    void deallocate(Value* memory, std::size_t) { ::operator delete(memory, alignment); }
    template <class Other>
    bool operator==(const CacheLineAllocator<Other>&) const {
        return true;
    }
};

template <class Value>
using AlignedVector = std::vector<Value, CacheLineAllocator<Value>>;
using Column = AlignedVector<double>;

} // namespace searle::solvers::particles
