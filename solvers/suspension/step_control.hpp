#pragma once

namespace searle::solvers::suspension {

/// Chooses the particles' step from the change of the forces: with F held over a step h the place
/// is off by h |dF| / (2 drag), dF the change of F within the step. The control keeps the largest
/// of these at `allowed`, which also keeps the step inside the region of stability, because the
/// error grows there.
class StepControl {
public:
    /// @param start, longest s, > 0  @param allowed m, > 0
    StepControl(double start, double longest, double allowed)
        : step_(start), longest_(longest), allowed_(allowed) {}

    [[nodiscard]] double step() const { return step_; }
    [[nodiscard]] double longest() const { return longest_; }
    void set_longest(double longest) {
        longest_ = longest;
        if (step_ > longest_)
            step_ = longest_;
    }
    /// @param error largest displacement error of the last step, m, >= 0
    void adapt(double error);
    void restore(double step) { step_ = step; }

private:
    double step_;
    double longest_;
    double allowed_;
};

} // namespace searle::solvers::suspension
