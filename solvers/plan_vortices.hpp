#pragma once

#include "solvers/plan_forecast.hpp"
#include "solvers/plan_steady_curve.hpp"
#include "solvers/stability/threshold_curve.hpp"

#include <optional>
#include <string>
#include <vector>

namespace searle::solvers {

/// The sheared layer of a gap outside a bob or rotor, or of the box.
class Layer {
public:
    /// The references must outlive the layer.
    Layer(const InstrumentGap& gap, const Fluid& fluid, const GapState& state);

    [[nodiscard]] bool partly_sheared() const { return partly_sheared_; }
    /// Width over the inner radius.
    [[nodiscard]] double relative_width() const;
    [[nodiscard]] double outer_radius() const;
    /// The viscosity that vortices are guessed with where the linear problem is not solved, over
    /// the density: eta^(3/4) (d tau / d gamma)^(1/4) at the inner wall; for a fluid that thickens
    /// the smallest such value in the layer. Docs/plan.md has what this rests on.
    [[nodiscard]] double kinematic_viscosity(bool may_thicken) const;
    /// Stress over rate at the inner wall, over the density.
    [[nodiscard]] double wall_kinematic_viscosity() const;

private:
    [[nodiscard]] double viscosity_at(double stress, double rate) const;

    const InstrumentGap& gap_;
    const Fluid& fluid_;
    const GapState& state_;
    double depth_{};
    bool partly_sheared_{};
};

/// Judges the rows of an annulus with a turning inner wall by the onset of Taylor vortices. A
/// Newtonian fluid has one critical Reynolds number. For others the linear problem of their own
/// flow is solved at a few speeds, unless the energy method excludes vortices at every row: then
/// the rows get an estimate. Docs/plan.md, section Taylor vortices.
class VortexForecast {
public:
    /// The references must outlive the forecast.
    VortexForecast(const InstrumentGap& gap, const Fluid& fluid);

    /// Notes a row that moves and fills in its facts.
    void add(std::size_t index, const RowForecast& row, RowFacts& facts, const Layer& layer);

    /// Fills in the rows' taylor_ratio and the Reynolds numbers of their facts.
    [[nodiscard]] TaylorOnset judge(const geometry::Instrument& instrument,
                                    std::vector<RowForecast>& rows, std::vector<RowFacts>& facts);

private:
    struct Seen {
        std::size_t index;
        double speed;         ///< rad/s, magnitude
        double wall_reynolds; ///< R omega d / nu, nu of the inner wall
        double estimate;      ///< Re / Re_critical by the Newtonian threshold
    };
    [[nodiscard]] double energy_ratio(double speed) const;
    /// The slowest speed from which on the energy method does not exclude vortices.
    [[nodiscard]] double slowest_doubtful(double slowest, double fastest) const;
    /// @return  basis of the numbers
    std::string judge_by_linear_theory(std::vector<RowForecast>& rows, std::vector<RowFacts>& facts,
                                       TaylorOnset& onset) const;

    const InstrumentGap& gap_;
    const Fluid& fluid_;
    bool newtonian_;
    bool may_thicken_;
    double relative_gap_;
    std::optional<stability::ThresholdCurve> layers_;
    std::vector<Seen> seen_;
};

} // namespace searle::solvers
