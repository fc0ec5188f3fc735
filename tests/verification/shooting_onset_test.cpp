#include "verification/shooting_onset.hpp"

#include "solvers/stability/layer_onset.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace searle::verification {
namespace {

using namespace laws::flow;
namespace radial = solvers::radial;
using radial::AnnularGap;
using solvers::stability::layer_onset;
using solvers::stability::LayerOnset;

struct Scene {
    const char* name;
    double radius_ratio;
    AnyFlowLaw law;
    double speed;
    double tolerance;
};

// Origin: the same physics by another method (verification/shooting_onset): six equations of first
// order in strong form, shot from the bob to the cup by Runge and Kutta. Tolerances: what 2000
// steps leave; at a yield surface the shot fluid ends 1e-6 of the layer's width early.
TEST(ShootingOnset, shooting_finds_the_same_density_and_wave_number) {
    for (const auto& [name, radius_ratio, law, speed, tolerance] : std::vector<Scene>{
             {"power law 0.5", 1.1, PowerLaw{0.5, 0.5}, 20.0, 1e-9},
             {"power law 0.3, wide", 1.8, PowerLaw{0.5, 0.3}, 20.0, 1e-9},
             {"power law 1.6, wide", 2.0, PowerLaw{0.05, 1.6}, 20.0, 1e-9},
             {"Carreau", 2.0, CarreauYasuda{0.5, 0.001, 0.3, 0.4, 2.0}, 20.0, 1e-9},
             {"Cross", 1.2, Cross{0.5, 0.01, 0.3, 0.3}, 20.0, 1e-9},
             {"Casson, all sheared", 1.1, Casson{0.5, 0.01}, 20.0, 1e-9},
             {"Herschel-Bulkley, all sheared", 1.07, HerschelBulkley{5.0, 0.5, 0.5}, 30.0, 1e-9},
             {"Bingham, a plug", 2.0, Bingham{5.0, 0.05}, 20.0, 1e-8},
             {"Herschel-Bulkley, a plug", 1.5, HerschelBulkley{20.0, 2.0, 0.5}, 10.0, 1e-8},
             {"thickening, a plug", 1.5, HerschelBulkley{60.0, 0.2, 1.4}, 10.0, 2e-7},
             {"Casson, a plug", 1.5, Casson{20.0, 0.05}, 10.0, 1e-8}}) {
        const AnnularGap gap{0.01, 0.01 * radius_ratio};
        const LayerOnset found = layer_onset(gap, law, speed, 1e-8);
        const bool has_plug = radial::steady_gap_flow(gap, law, speed).partly_sheared;
        EXPECT_EQ(has_plug, std::string_view(name).ends_with("a plug")) << name;
        const ShotOnset shot = shooting_onset(gap, law, speed, found.critical_density,
                                              found.wave_number / gap.width());
        EXPECT_NEAR(found.critical_density / shot.density, 1.0, tolerance) << name;
        EXPECT_NEAR(found.wave_number / (shot.wave_number * gap.width()), 1.0, 5e-5) << name;
    }
}

// The plan looks at axisymmetric vortices alone. What depends on the angle (m = 1, and m = 2 later
// still) needs a denser fluid: in narrow gaps by little, as for a Newtonian fluid.
TEST(ShootingOnset, disturbances_that_run_around_come_after_the_axisymmetric_ones) {
    for (const auto& [name, radius_ratio, law, speed, margin] : std::vector<Scene>{
             {"Newtonian, narrow", 1.0 / 0.95, Newtonian{1.0}, 20.0, 1e-3},
             {"Newtonian, wide", 2.0, Newtonian{1.0}, 20.0, 1e-2},
             {"power law 0.5", 1.1, PowerLaw{0.5, 0.5}, 20.0, 1e-3},
             {"power law 0.3, wide", 1.8, PowerLaw{0.5, 0.3}, 20.0, 1e-2},
             {"power law 1.6, wide", 2.0, PowerLaw{0.05, 1.6}, 20.0, 1e-2},
             {"Herschel-Bulkley, a plug", 1.5, HerschelBulkley{20.0, 2.0, 0.5}, 10.0, 1e-2}}) {
        const AnnularGap gap{0.01, 0.01 * radius_ratio};
        const LayerOnset found = layer_onset(gap, law, speed, 1e-8);
        const ShotOnset axisymmetric{.density = found.critical_density,
                                     .wave_number = found.wave_number / gap.width()};
        const double running = running_wave_density(gap, law, speed, 1, axisymmetric);
        EXPECT_GT(running / found.critical_density, 1.0 + margin) << name;
        EXPECT_LT(running / found.critical_density, 1.3) << name;
    }
}

} // namespace
} // namespace searle::verification
