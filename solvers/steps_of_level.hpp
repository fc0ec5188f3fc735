#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace searle::solvers {

/// The steps in time that one level of resolution took. The next level's are a share shorter
/// everywhere: two levels that happen to take the same steps, because their errors foresee none or
/// a rule sets them, agree on what those steps miss. With this share the difference between two
/// levels shows errors of the first order, which stops and turns leave, within the bars' safety.
class StepsOfLevel {
public:
    static constexpr double share = 0.65;

    /// @param end_time  of the next step, > the one before
    void add(double end_time) { ends_.push_back(end_time); }

    /// Longest step of the next level from a time on; infinite where this level took none.
    [[nodiscard]] double longest_from(double time) const {
        const auto end = std::upper_bound(ends_.begin(), ends_.end(), time);
        if (end == ends_.end()) {
            return std::numeric_limits<double>::infinity();
        }
        const double start = end == ends_.begin() ? 0.0 : *(end - 1);
        return share * (*end - start);
    }

private:
    std::vector<double> ends_;
};

} // namespace searle::solvers
