#include "app/verify/check.hpp"
#include "solvers/stability/layer_onset.hpp"
#include "solvers/stability/taylor_threshold.hpp"
#include "verification/shooting_onset.hpp"

#include <algorithm>
#include <array>

namespace searle::app::verify {
namespace {

using namespace laws::flow;
using solvers::radial::AnnularGap;

Found taylor_onset() {
    using solvers::stability::taylor_threshold;
    return {std::max({std::abs(taylor_threshold(1.0).reynolds - 68.1863),
                      std::abs(taylor_threshold(1.0 / 0.875 - 1.0).reynolds - 118.1571),
                      std::abs(taylor_threshold(1.0 / 0.95 - 1.0).reynolds - 184.9856),
                      std::abs(taylor_threshold(1.0).wave_number - 3.1625)})};
}

Found taylor_onset_thirty_digits() {
    double worst = 0.0;
    for (const auto& [gap, reynolds] :
         {std::array{0.0005, 1841.70303886496}, std::array{1.0 / 14.0, 160.50432850405},
          std::array{1.0, 68.1862683463863}, std::array{9.0, 140.492148428144}})
        worst =
            std::max(worst, relative(solvers::stability::taylor_threshold(gap).reynolds, reynolds));
    return {worst};
}

/// Critical Re of power-law fluids over a Newtonian one's: radius ratio, flow index, threshold.
Found power_law_onset() {
    double worst = 0.0;
    for (const auto& [ratio, index, threshold] :
         {std::array{1.0005, 0.9, 0.974}, std::array{1.0005, 0.3, 0.780},
          std::array{1.0714, 0.7, 0.949}, std::array{1.0714, 1.5, 1.087},
          std::array{1.2, 0.5, 1.050}, std::array{2.0, 0.5, 1.913}, std::array{2.0, 1.5, 0.828}}) {
        const AnnularGap gap{0.01, 0.01 * ratio};
        const double found =
            solvers::stability::layer_onset(gap, PowerLaw{0.01, index}, 10.0, 1e-6).reynolds /
            solvers::stability::taylor_threshold(ratio - 1.0).reynolds;
        worst = std::max(worst, std::abs(found - threshold));
    }
    return {worst};
}

double distance_to_shooting(const AnnularGap& gap, const AnyFlowLaw& law, double speed) {
    const auto found = solvers::stability::layer_onset(gap, law, speed, 1e-8);
    const auto shot = verification::shooting_onset(gap, law, speed, found.critical_density,
                                                   found.wave_number / gap.width());
    return relative(found.critical_density, shot.density);
}

Found sheared_onset_by_shooting() {
    return {std::max(
        {distance_to_shooting({0.01, 0.018}, PowerLaw{0.5, 0.3}, 20.0),
         distance_to_shooting({0.01, 0.020}, CarreauYasuda{0.5, 0.001, 0.3, 0.4, 2.0}, 20.0),
         distance_to_shooting({0.01, 0.0107}, HerschelBulkley{5.0, 0.5, 0.5}, 30.0)})};
}

Found plug_onset_by_shooting() {
    return {std::max({distance_to_shooting({0.01, 0.020}, Bingham{5.0, 0.05}, 20.0),
                      distance_to_shooting({0.01, 0.015}, HerschelBulkley{20.0, 2.0, 0.5}, 10.0),
                      distance_to_shooting({0.01, 0.015}, Casson{20.0, 0.05}, 10.0)})};
}

} // namespace

std::vector<Check> onset_checks() {
    const std::string onset = "tests/solvers/stability_taylor_threshold_test.cpp";
    const std::string shooting = "tests/verification/shooting_onset_test.cpp";
    return {
        {.name = "taylor-onset",
         .subject = "onset of Taylor vortices, R_bob/R_cup 0.5, 0.875 and 0.95",
         .against = "published values 68.1863, 118.1571 and 184.9856, k d 3.1625",
         .tolerance = 5e-5,
         .origin = "half the values' last digit",
         .file = onset,
         .test = "TaylorThreshold.published_values_are_met",
         .run = taylor_onset},
        {.name = "taylor-onset-thirty-digits",
         .subject = "onset of Taylor vortices in gaps of 0.05 % to nine radii",
         .against = "Chebyshev collocation with 30 digits",
         .tolerance = 3e-10,
         .origin = "the resolution at which the solver stops",
         .file = onset,
         .test = "TaylorThreshold.ten_digits_agree_with_collocation_in_thirty_digits",
         .run = taylor_onset_thirty_digits},
        {.name = "onset-power-law",
         .subject = "onset of vortices of power-law fluids, n 0.3 to 1.5, over a Newtonian one's",
         .against = "an independent program (Legendre-Galerkin, numpy), three digits",
         .tolerance = 5e-4,
         .origin = "half the values' last digit",
         .file = "tests/solvers/stability_layer_onset_test.cpp",
         .test = "LayerOnset.power_law_fluids_agree_with_an_independent_program",
         .run = power_law_onset},
        {.name = "onset-sheared-shooting",
         .subject = "onset of vortices: power law, Carreau, Herschel-Bulkley sheared throughout",
         .against = "six equations of first order shot from wall to wall, 2000 steps",
         .tolerance = 1e-9,
         .origin = "the steps of the reference, fourth order",
         .file = shooting,
         .test = "ShootingOnset.shooting_finds_the_same_density_and_wave_number",
         .run = sheared_onset_by_shooting},
        {.name = "onset-plug-shooting",
         .subject = "onset of vortices beside a plug: Bingham, Herschel-Bulkley, Casson",
         .against = "the same shooting, to 1e-6 of the layer's width before the yield surface",
         .tolerance = 1e-8,
         .origin = "the sliver that the reference leaves out",
         .file = shooting,
         .test = "ShootingOnset.shooting_finds_the_same_density_and_wave_number",
         .run = plug_onset_by_shooting},
    };
}

} // namespace searle::app::verify
