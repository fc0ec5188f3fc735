#include "solvers/meridional/flow_material.hpp"

#include <cmath>
#include <variant>

namespace searle::solvers::meridional {
namespace {

class ConstantViscosity final : public axisymmetric::EnergyDensity {
public:
    explicit ConstantViscosity(double viscosity) : viscosity_(viscosity) {}
    void slopes(const Eigen::ArrayXd& rate, Eigen::ArrayXd& secant,
                Eigen::ArrayXd& tangent) const override {
        secant.setConstant(rate.size(), viscosity_);
        tangent.setConstant(rate.size(), viscosity_);
    }

private:
    double viscosity_;
};

} // namespace

ScaledFluid::ScaledFluid(const laws::flow::AnyFlowLaw& law, double density, double radius,
                         double speed, double wall_rate, double rounding)
    : law_(std::make_unique<axisymmetric::SwirlLaw>(law, speed, wall_rate / speed)),
      inertia_(density * std::pow(speed * radius, 2) / law_->stress_scale()),
      reynolds_(inertia_ * wall_rate / speed) {
    if (std::holds_alternative<laws::flow::Newtonian>(law)) {
        density_ = std::make_unique<ConstantViscosity>(speed / wall_rate);
    } else {
        density_ = std::make_unique<axisymmetric::SwirlLaw::RoundedPotential>(
            *law_, rounding * wall_rate / speed);
    }
}

} // namespace searle::solvers::meridional
