#include "solvers/plan_rows.hpp"

namespace searle::solvers {

double slenderness(const geometry::Instrument& instrument) {
    struct Ratio {
        double operator()(const geometry::ConcentricCylinders& c) const {
            return c.height / c.gap();
        }
        double operator()(const geometry::DoubleGap& g) const { return g.height / g.outer_gap(); }
        double operator()(const geometry::DinBob& b) const { return b.height() / b.gap(); }
        double operator()(const geometry::Box&) const { return 0.0; }
    };
    return std::visit(Ratio{}, instrument);
}

} // namespace searle::solvers
