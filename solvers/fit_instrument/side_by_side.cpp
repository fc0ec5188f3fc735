#include "solvers/fit_instrument/side_by_side.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace searle::solvers::fit_instrument {

void side_by_side(std::size_t count, const std::function<void(std::size_t)>& piece,
                  const std::function<void()>& between) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr first;
    std::mutex guard;
    const auto work = [&](bool is_caller) {
        try {
            for (std::size_t k = next++; k < count; k = next++) {
                piece(k);
                if (is_caller)
                    between();
            }
        } catch (...) {
            const std::scoped_lock lock(guard);
            next = count;
            if (!first)
                first = std::current_exception();
        }
    };
    {
        const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
        std::vector<std::jthread> others;
        for (std::size_t k = 1; k < std::min(processors, count); ++k)
            others.emplace_back(work, false);
        work(true);
    }
    if (first)
        std::rethrow_exception(first);
}

} // namespace searle::solvers::fit_instrument
