#pragma once

#include "geometry/instrument.hpp"
#include "rheometry/fit/forward_model.hpp"
#include "rheometry/fit/model.hpp"
#include "solvers/fit_instrument/gap_response.hpp"

#include <memory>
#include <vector>

namespace searle::solvers::fit_instrument {

/// Steady torques of one instrument.
struct Measurement {
    geometry::Instrument instrument;
    /// c_L of each row, or one for all: torque over that of the endless cylinder.
    std::vector<double> end_factors;
    std::vector<double> speeds;  ///< rad/s (m/s for the box), > 0
    std::vector<double> torques; ///< N m (N for the box), > 0

    /// How c_L changes with the law: d ln c_L / d parameter, row by row, about the parameters
    /// `end_factor_search` that `end_factors` belong to (search's coordinates). Empty: not at all.
    std::vector<double> end_factor_slopes{};
    std::vector<double> end_factor_search{};
    /// What is in each row's torque beside the steady flow (inertia), N m; empty: nothing.
    std::vector<double> added_torques{};
};

/// Torques that a flow law gives in one or several instruments: gap curvature, plug and, with
/// `slip`, a slip at all walls in proportion to the stress there. The parameters are the law's in
/// their order, then the slip coefficient (m/(Pa s)) if there is one.
class InstrumentForward final : public rheometry::fit::ForwardModel {
public:
    InstrumentForward(const rheometry::fit::Model& law,
                      const std::vector<Measurement>& measurements, bool slip);

    [[nodiscard]] std::size_t size() const override { return size_; }
    [[nodiscard]] bool predict(std::span<const double> search, std::span<double> values,
                               std::span<double> jacobian) const override;

private:
    /// One gap of an instrument: what its inner wall's stress adds to the torque.
    struct Part {
        GapCurve curve;
        double torque_per_stress{};
    };
    struct Device {
        std::vector<Part> parts;
        std::vector<double> end_factors;
        std::vector<double> end_factor_slopes;
        std::vector<double> end_factor_search;
        std::vector<double> added_torques;
        std::vector<double> speeds;
        /// For the box: wall area and gap; the rate is the speed over the gap.
        double area{};
        double gap{};
    };
    /// ln of what the parameters make of a row's c_L, over that at end_factor_search.
    [[nodiscard]] double end_factor_change(const Device& device, std::size_t row,
                                           std::span<const double> search) const;
    [[nodiscard]] bool predict_box(const Device& device, std::span<const double> search,
                                   std::span<double> values, std::span<double> jacobian) const;
    [[nodiscard]] bool predict_gaps(const Device& device, std::span<const double> search,
                                    std::span<double> values, std::span<double> jacobian) const;

    const rheometry::fit::Model& law_;
    bool slip_;
    std::size_t size_ = 0;
    std::vector<Device> devices_;
};

} // namespace searle::solvers::fit_instrument
