#pragma once

#include "solvers/axisymmetric/creeping_swirl.hpp"
#include "solvers/axisymmetric/section_shape.hpp"

#include <span>
#include <vector>

namespace searle::solvers::axisymmetric {

/// c_L of one bob and fluid over a range of speeds, without inertia. A Newtonian or power-law fluid
/// has one value; others are solved at each speed, or for many speeds at Chebyshev points of ln c_L
/// over ln speed, whose number is doubled until the curve no longer moves or the work is beyond its
/// bound.
class EndFactorCurve {
public:
    /// @param speeds    rad/s; signs are left out, zeros are skipped
    /// @param accuracy  asked-for relative error of the torque
    /// @param most_work_at_ease  as CreepingSettings::most_work, of all speeds, beyond which each
    ///                  further one gets a tenth of what one may take: some twenty seconds
    EndFactorCurve(const SectionShape& shape, const laws::flow::AnyFlowLaw& law,
                   std::span<const double> speeds, double accuracy, const ProgressSink& progress,
                   double most_work_at_ease = 3.0 * CreepingSettings{}.most_work);

    struct Value {
        double end_factor = 1.0;
        double relative_error{};
        double lower{}; ///< bounds of c_L where it was solved at this very speed, else 0
        double upper{};
    };
    /// At one of the speeds given, != 0.
    [[nodiscard]] Value at(double speed) const;
    /// Whether at() has a value for a speed: false for those that an interruption left out.
    [[nodiscard]] bool has(double speed) const;
    /// The progress sink threw Interrupted; what was solved before is there.
    [[nodiscard]] bool interrupted() const { return interrupted_; }

    [[nodiscard]] int solutions() const { return static_cast<int>(solved_.size()); }
    [[nodiscard]] int elements() const { return elements_; } ///< most of one solution
    [[nodiscard]] int levels() const { return levels_; }
    [[nodiscard]] long newton_steps() const { return newton_steps_; }
    [[nodiscard]] long unknowns() const { return unknowns_; }
    /// Of the solution with the most unknowns; without lines when nothing was solved.
    [[nodiscard]] const SectionDivision& division() const { return division_; }
    /// False when a solution or the curve is less accurate than was asked.
    [[nodiscard]] bool reached() const { return reached_; }

private:
    struct Solved {
        double speed;
        int degree; ///< of the interpolation that asked for it
        Value value;
    };
    void solve_all(std::span<const double> speeds);
    void keep_whole_degree();
    void solve(double speed);
    [[nodiscard]] double interpolated(double speed) const;

    const SectionShape& shape_;
    const laws::flow::AnyFlowLaw& law_;
    double accuracy_;
    double most_work_at_ease_;
    const ProgressSink& progress_;
    std::vector<Solved> solved_; ///< by growing speed; the Chebyshev points where interpolated
    bool interpolates_{};
    double interpolation_error_{};
    int degree_{};
    int whole_degree_{};
    bool interrupted_{};
    int elements_{};
    int levels_{};
    long newton_steps_{};
    double work_{}; ///< of all solutions
    long unknowns_{};
    SectionDivision division_;
    bool reached_ = true;
};

} // namespace searle::solvers::axisymmetric
