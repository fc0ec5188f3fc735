#include "solvers/meridional/flow_material.hpp"
#include "solvers/meridional/flow_stability.hpp"
#include "solvers/meridional/steady_vortices.hpp"
#include "solvers/meridional/vortex_run.hpp"
#include "solvers/stability/layer_onset.hpp"
#include "solvers/stability/onset_curve.hpp"
#include "tests/solvers/vortex_growth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace searle::solvers::meridional {
namespace {

using namespace laws::flow;

struct Fluid {
    const char* name;
    AnyFlowLaw law;
};

constexpr double radius = 0.01;
constexpr double speed = 20.0;
/// Rates below this share of the wall's have their viscosity levelled off by the flow's solver;
/// nothing in these gaps is sheared so little.
constexpr double rounding = 1e-8;

const std::vector<Fluid>& fluids() {
    static const std::vector<Fluid> all{{"power law 0.5", PowerLaw{0.5, 0.5}},
                                        {"power law 1.5", PowerLaw{0.05, 1.5}},
                                        {"Carreau", CarreauYasuda{0.5, 0.001, 0.3, 0.4, 2.0}},
                                        {"Herschel-Bulkley", HerschelBulkley{2.0, 0.5, 0.6}}};
    return all;
}

/// The linear problem of one fluid as the flow in time meets it.
class OnsetCell {
public:
    OnsetCell(double radius_ratio, const AnyFlowLaw& law)
        : gap_{radius, radius / radius_ratio}, law_(law),
          flow_(radial::steady_gap_flow(gap_, law, speed)),
          onset_(stability::layer_onset(gap_, law, speed, 1e-8)) {}

    [[nodiscard]] double relative_gap() const { return gap_.width() / gap_.inner_radius; }
    [[nodiscard]] VortexCell cell() const { return cell_of(relative_gap(), onset_.wave_number); }
    [[nodiscard]] ScaledFluid fluid(double share) const {
        return {law_,  share * onset_.critical_density, radius,
                speed, flow_.inner_wall_rate,           rounding};
    }
    [[nodiscard]] double growth(double share, const CellResolution& resolution) const {
        const ScaledFluid scaled = fluid(share);
        const double viscous_time = relative_gap() * relative_gap() * scaled.reynolds();
        return vortex_growth(cell(), scaled.material(), viscous_time, resolution);
    }

private:
    radial::AnnularGap gap_;
    AnyFlowLaw law_;
    radial::SteadyGapFlow flow_;
    stability::LayerOnset onset_;
};

/// The linear theory and the flow in time share the flow laws alone: neither equations (the flow's
/// viscosity follows from the whole rate of shear), nor unknowns, nor discretisation.
TEST(OnsetOfFluids, time_steps_find_the_onset_of_linear_theory) {
    for (const auto& [name, law] : fluids()) {
        for (const double radius_ratio : {0.7, 0.9}) {
            const OnsetCell cell(radius_ratio, law);
            std::vector<double> errors;
            for (const int degree : {5, 7, 9}) {
                const CellResolution resolution{.degree = degree, .columns = 1, .rows = 1};
                errors.push_back(std::abs(
                    where_growth_vanishes(
                        [&](double share) { return cell.growth(share, resolution); }, 0.002) -
                    1.0));
            }
            EXPECT_GT(errors[0], 8.0 * errors[1]) << name << ' ' << radius_ratio;
            // The chord of the growth over +-0.2 % misses its curvature: 1.5e-6.
            EXPECT_LT(errors[2], 5e-6) << name << ' ' << radius_ratio;
        }
    }
}

/// Arnoldi's method looks at all axisymmetric disturbances of the cell, oscillating ones, too: just
/// below the onset all die, just above one grows without oscillating.
TEST(OnsetOfFluids, nothing_that_oscillates_grows_before_the_steady_vortices) {
    const CellResolution resolution{.degree = 8, .columns = 1, .rows = 1};
    for (const auto& [name, law] : fluids()) {
        const OnsetCell cell(0.7, law);
        for (const double share : {0.98, 1.02}) {
            const auto level = cell_level(cell.cell(), resolution);
            const ScaledFluid fluid = cell.fluid(share);
            static_cast<void>(level->solve_creeping(fluid.material().law, 1e-12));
            const LeadingDisturbance leading =
                leading_disturbance(*level, fluid.material(), {}, 40);
            EXPECT_EQ(leading.rate.real() > 0.0, share > 1.0) << name << ' ' << share;
            EXPECT_EQ(leading.rate.imag(), 0.0) << name << ' ' << share;
        }
    }
}

/// Weakly nonlinear theory: where the fork is supercritical, torque - 1 ~ density - critical
/// density. The flow solved for shares nothing with the linear theory that the speed comes from.
TEST(OnsetOfFluids, torque_of_vortices_grows_linearly_from_the_linear_onset) {
    for (const AnyFlowLaw& law :
         std::vector<AnyFlowLaw>{PowerLaw{0.02, 0.6}, PowerLaw{1e-4, 1.4},
                                 CarreauYasuda{0.01, 0.001, 0.05, 0.5, 2.0}}) {
        const radial::AnnularGap gap{0.014, 0.016};
        const double density = 1000.0;
        const auto onset = stability::critical_speed(gap, law, density, 10.0, 1e-8);
        ASSERT_TRUE(onset);
        SteadyVortices vortices(
            gap, 2.0 * std::numbers::pi * gap.width() / onset->onset.wave_number, law, density);
        EXPECT_EQ(vortices.at(0.998 * onset->speed, 1e-5).factor, 1.0) << name_of(law);
        const double one = vortices.at(1.005 * onset->speed, 1e-5).factor - 1.0;
        const double two = vortices.at(1.010 * onset->speed, 1e-5).factor - 1.0;
        EXPECT_GT(one, 1e-3) << name_of(law);
        EXPECT_NEAR(two / one, 2.0, 0.05) << name_of(law);
    }
}

/// A hold past the onset from a small unevenness ends with the torque of the steady vortices.
TEST(OnsetOfFluids, vortices_of_a_power_law_fluid_grow_into_the_steady_ones) {
    const radial::AnnularGap gap{0.014, 0.016};
    const PowerLaw law{0.02, 0.6};
    const double density = 1000.0;
    const auto onset = stability::critical_speed(gap, law, density, 10.0, 1e-8);
    ASSERT_TRUE(onset);
    const double wavelength = 2.0 * std::numbers::pi * gap.width() / onset->onset.wave_number;
    const double fast = 1.5 * onset->speed;
    rheometry::SpeedHistory hold;
    hold.pieces = {{0.0, 1.0, 0.0, fast}, {1.0, 60.0, fast, fast}};
    hold.row_times = {60.0};
    const VortexRun run =
        vortex_run(gap, wavelength, law, density, 1e-3, hold, std::vector<double>{1e-3});
    ASSERT_TRUE(run.reached);
    SteadyVortices vortices(gap, wavelength, law, density);
    const double laminar = radial::steady_gap_flow(gap, law, fast).torque_per_length;
    const double steady = vortices.at(fast, 1e-4).factor;
    EXPECT_GT(steady, 1.2);
    EXPECT_NEAR(run.torque[0] / laminar, steady, 2e-3);
}

} // namespace
} // namespace searle::solvers::meridional
