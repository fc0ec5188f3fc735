#pragma once

#include <array>
#include <cstddef>

namespace searle::solvers::suspension {

/// What shear stress is made of, Pa; the parts sum to the whole.
struct StressParts {
    double fluid{};
    double hydrodynamic{}; ///< drag, stresslets, lubrication
    double contact{};
    double colloid{};
    double brownian{};

    [[nodiscard]] double total() const {
        return fluid + hydrodynamic + contact + colloid + brownian;
    }
};

/// Means over a short time.
struct StressSample {
    double time{};       ///< middle of it, s
    double duration{};   ///< s
    double shear_rate{}; ///< mean, 1/s
    StressParts wall;    ///< force on the moving wall along the flow over its area; with walls
    StressParts bulk;    ///< mean over the box
    double first_normal_difference{};  ///< sigma_xx - sigma_yy of the particles, Pa
    double second_normal_difference{}; ///< sigma_yy - sigma_zz of the particles, Pa
    double particle_pressure{};        ///< minus a third of the trace of the particles' stress, Pa
    double contact_number{};           ///< touching partners of a particle, walls included

    static constexpr std::size_t size = 17;
    /// All of them as numbers in a fixed order, for sums and files.
    [[nodiscard]] std::array<double, size> values() const {
        return {time,
                duration,
                shear_rate,
                wall.fluid,
                wall.hydrodynamic,
                wall.contact,
                wall.colloid,
                wall.brownian,
                bulk.fluid,
                bulk.hydrodynamic,
                bulk.contact,
                bulk.colloid,
                bulk.brownian,
                first_normal_difference,
                second_normal_difference,
                particle_pressure,
                contact_number};
    }
    static StressSample from(const std::array<double, size>& v) {
        return {v[0],
                v[1],
                v[2],
                {v[3], v[4], v[5], v[6], v[7]},
                {v[8], v[9], v[10], v[11], v[12]},
                v[13],
                v[14],
                v[15],
                v[16]};
    }
};

/// Collects samples, weighted with their durations, into means.
class SampleMean {
public:
    void add(const StressSample& sample) {
        const auto values = sample.values();
        for (std::size_t k = 0; k < StressSample::size; ++k)
            sums_[k] += values[k] * (k == 1 ? 1.0 : sample.duration);
    }
    [[nodiscard]] double duration() const { return sums_[1]; }
    [[nodiscard]] StressSample mean() const {
        auto values = sums_;
        for (std::size_t k = 0; k < StressSample::size; ++k)
            if (k != 1)
                values[k] /= sums_[1];
        return StressSample::from(values);
    }
    void clear() { sums_ = {}; }
    [[nodiscard]] const std::array<double, StressSample::size>& sums() const { return sums_; }
    void restore(const std::array<double, StressSample::size>& sums) { sums_ = sums; }

private:
    std::array<double, StressSample::size> sums_{};
};

} // namespace searle::solvers::suspension
