#pragma once

#include "solvers/particles/aligned_vector.hpp"
#include "solvers/particles/lanes.hpp"
#include "solvers/particles/particle_store.hpp"
#include "solvers/particles/shear_box.hpp"

#include <algorithm>
#include <cstddef>

namespace searle::solvers::particles {

/// Writes down the pairs of a cell's particles with all that may be near them. These are copied
/// side by side once for the cell, so that each of its particles looks at them in whole vector
/// registers.
class PairSearch {
public:
    /// @param margin surface distance up to which two are a pair, m
    PairSearch(const ParticleStore& particles, const ShearBox& box, double margin,
               AlignedVector<int>& first, AlignedVector<int>& second)
        : p_(particles), nearest_(box), margin_(margin), first_(first), second_(second) {}
    ~PairSearch() {
        first_.resize(found_);
        second_.resize(found_);
    }
    PairSearch(const PairSearch&) = delete;
    PairSearch& operator=(const PairSearch&) = delete;

    /// A new cell.
    void start() { count_ = 0; }

    void add_candidates(int begin, int end) {
        const auto more = static_cast<std::size_t>(end - begin);
        const std::size_t needed = count_ + more;
        if (needed + 2 * lanes > index_.size()) {
            for (Column* column : {&x_, &y_, &z_, &radius_, &excess_})
                column->resize(2 * needed + 2 * lanes);
            index_.resize(x_.size());
        }
        const double *px = p_.x.data() + begin, *py = p_.y.data() + begin;
        const double *pz = p_.z.data() + begin, *of_radius = p_.radius.data() + begin;
        double *x = x_.data() + count_, *y = y_.data() + count_, *z = z_.data() + count_;
        double* radius = radius_.data() + count_;
        int* index = index_.data() + count_;
        for (std::size_t m = 0; m < more; ++m) {
            x[m] = px[m];
            y[m] = py[m];
            z[m] = pz[m];
            radius[m] = of_radius[m];
            index[m] = begin + static_cast<int>(m);
        }
        count_ = needed;
    }

    /// Pairs of begin ... end - 1, which must be the first candidates, with the later candidates.
    /// @tparam images whether the nearest image of a candidate may be another; if not, candidates
    ///                must ascend
    template <bool images>
    void find(int begin, int end) {
        for (int i = begin; i < end; ++i)
            find_partners<images>(i, static_cast<std::size_t>(i - begin) + 1);
    }

private:
    static constexpr std::size_t lanes = 8;

    template <bool images>
    void find_partners(int i, std::size_t from) {
        const auto at = static_cast<std::size_t>(i);
        const double x = p_.x[at], y = p_.y[at], z = p_.z[at];
        const double own = p_.radius[at] + margin_;
        const double *cx = x_.data(), *cy = y_.data(), *cz = z_.data(), *radius = radius_.data();
        double* excess = excess_.data();
        const NearestImage nearest = nearest_;
        // Whole registers; what lies before `from` or beyond the candidates is not looked at below.
        const std::size_t padded = (count_ + lanes - 1) / lanes * lanes;
#pragma omp simd
        for (std::size_t m = from / lanes * lanes; m < padded; ++m) {
            double dx = cx[m] - x;
            double dy = cy[m] - y;
            double dz = cz[m] - z;
            if constexpr (images)
                nearest(dx, dy, dz);
            const double limit = own + radius[m];
            excess[m] = dx * dx + dy * dy + dz * dz - limit * limit;
        }
        if (found_ + count_ + lanes > first_.size()) {
            first_.resize(2 * (found_ + count_) + lanes);
            second_.resize(first_.size());
        }
        int* first = first_.data() + found_;
        int* second = second_.data() + found_;
        const int found = keep_negative(excess + from, index_.data() + from,
                                        static_cast<int>(count_ - from), second);
        for (int m = 0; m < found; ++m)
            first[m] = i;
        for (int m = 0; images && m < found; ++m) {
            first[m] = std::min(i, second[m]);
            second[m] = std::max(i, second[m]);
        }
        found_ += static_cast<std::size_t>(found);
    }

    const ParticleStore& p_;
    NearestImage nearest_;
    double margin_;
    AlignedVector<int>& first_;
    AlignedVector<int>& second_;
    std::size_t found_ = 0;
    Column x_, y_, z_, radius_; ///< of the candidates
    Column excess_;             ///< squared distance over the limit's square
    AlignedVector<int> index_;
    std::size_t count_ = 0;
};

} // namespace searle::solvers::particles
