#pragma once

#include "laws/flow/flow_law.hpp"

#include <memory>

namespace searle::solvers::radial {

/// ln(rate) over ln(stress) of a law whose rate has to be found by iteration, as quintic Hermite
/// pieces: relative error of the rate below 1e-11 (tests/solvers/tabulated_inverse_test.cpp), some
/// forty times quicker. Outside the table, which spans stresses of 1e-10 to 1e6 times
/// `typical_stress`, the law itself is inverted.
class InverseTable {
public:
    struct Point {
        double log_rate{};
        double log_slope{}; ///< d ln(rate) / d ln(stress)
    };

    template <class Law>
    InverseTable(const Law& law, double typical_stress);

    [[nodiscard]] bool covers(double log_stress) const {
        return log_stress > low_ && log_stress < high_;
    }
    [[nodiscard]] Point at(double log_stress) const;

private:
    struct Spline;

    double low_{};
    double high_{};
    std::shared_ptr<const Spline> spline_;
};

/// A flow law with the rate read from a table; everything else is the law's own.
template <class Law>
struct TabulatedLaw : Law {
    InverseTable table;

    TabulatedLaw(const Law& law, double typical_stress) : Law(law), table(law, typical_stress) {}

    [[nodiscard]] double rate_at_excess(double excess) const;
};

} // namespace searle::solvers::radial
