#include "app/bench/bench_scenes.hpp"

#include <fmt/format.h>

namespace searle::app::bench {
namespace {

constexpr const char* single_gap = "[geometry]\ntype = \"single-gap\"\nbob_radius = \"14 mm\"\n"
                                   "cup_radius = \"15 mm\"\nheight = \"42 mm\"\n";
constexpr const char* wide_gap = "[geometry]\ntype = \"single-gap\"\nbob_radius = \"14 mm\"\n"
                                 "cup_radius = \"16 mm\"\nheight = \"42 mm\"\n";
constexpr const char* double_gap =
    "[geometry]\ntype = \"double-gap\"\nheight = \"55 mm\"\n"
    "radii = [\"20 mm\", \"20.38 mm\", \"21.96 mm\", \"22.38 mm\"]\n";
constexpr const char* plates = "[geometry]\ntype = \"box\"\ngap = \"1 mm\"\nlength = \"100 mm\"\n"
                               "width = \"100 mm\"\n";
constexpr const char* iso_bob =
    "[geometry]\ntype = \"din-bob\"\nbob_radius = \"14 mm\"\nradius_ratio = 1.0847\n";

constexpr const char* water = "[fluid]\nmodel = \"newtonian\"\nviscosity = \"1.0016 mPa.s\"\n"
                              "density = \"998.2 kg/m^3\"\n";
constexpr const char* syrup = "[fluid]\nmodel = \"newtonian\"\nviscosity = \"10 Pa.s\"\n"
                              "density = \"1000 kg/m^3\"\n";
constexpr const char* slurry =
    "[fluid]\nmodel = \"herschel-bulkley\"\nyield_stress = \"5 Pa\"\n"
    "consistency = \"0.5 Pa.s^n\"\nflow_index = 0.5\ndensity = \"1250 kg/m^3\"\n";

/// From rest; a row a second.
std::string ramp(int to) {
    return fmt::format("[protocol]\ntype = \"ramp\"\nfrom = \"0 1/s\"\nto = \"{} 1/s\"\n"
                       "duration = \"35 s\"\npoints = 35\n",
                       to);
}
std::string steady(const char* rates) {
    return fmt::format("[protocol]\ntype = \"steps\"\nshear_rates = [{}]\nhold = \"steady\"\n",
                       rates);
}
std::string strained(double strain, double discarded) {
    return fmt::format("[protocol]\ntype = \"steps\"\nshear_rates = [\"180 1/s\"]\n"
                       "hold_strain = {}\ndiscard_strain = {}\n",
                       strain, discarded);
}
constexpr const char* at_bob_wall = "[conversion]\ndefinition = \"bob-wall\"\nend_factor = 1.0\n";

std::string cube(double micrometres) {
    return fmt::format("[geometry]\ntype = \"box\"\ngap = \"{0} um\"\nlength = \"{0} um\"\n"
                       "width = \"{0} um\"\n",
                       micrometres);
}
/// The zirconia of the paper's Figure 5 in its 50 um box.
std::string zirconia(const char* double_layer) {
    return cube(50) + water + strained(1.0, 0.2) +
           "[particles]\ndiameter = \"1.5 um\"\ndensity = \"5700 kg/m^3\"\n"
           "volume_fraction = 0.0468\ndrag = \"di-felice\"\nhydrodynamics = \"drag\"\n"
           "contact = { stiffness = \"1e-2 N/m\", restitution = 0.9, friction = 0.3 }\n" +
           double_layer;
}
/// N = 500, radii 1 : 1.4 in equal volumes: the scene of LF_DEM's table.
std::string dense(double side, double strain, double discarded, double friction) {
    return cube(side) + water + strained(strain, discarded) +
           fmt::format("[particles]\ndensity = \"998.2 kg/m^3\"\nvolume_fraction = 0.5\n"
                       "diameters = [{{ diameter = \"1.5 um\", share = 0.5 }}, "
                       "{{ diameter = \"2.1 um\", share = 0.5 }}]\n"
                       "boundary = \"lees-edwards\"\nhydrodynamics = \"lubrication\"\n"
                       "contact = {{ stiffness = \"1e-2 N/m\", friction = {} }}\n",
                       friction);
}

std::vector<BenchScene> fluids() {
    const std::vector<double> to_1e8{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
    const std::vector<double> to_1e6{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};
    const std::vector<double> to_1e5{1e-1, 1e-2, 1e-3, 1e-4, 1e-5};
    const std::vector<double> quick{1e-1, 1e-2, 1e-3, 1e-4, 1e-5};
    const std::vector<double> few{1e-1, 1e-2, 1e-3};
    return {
        {.name = "single-gap-ramp",
         .title = "water in a 1 mm gap, ramp 0 to 100 1/s in 35 s",
         .kind = "single gap, ramp",
         .case_text = std::string(single_gap) + water + ramp(100) + at_bob_wall,
         .accuracies = to_1e8,
         .quick_accuracies = quick,
         .truth = Truth::start_up_series},
        {.name = "double-gap-ramp",
         .title = "water in a double gap, ramp 0 to 100 1/s in 35 s",
         .kind = "double gap, ramp",
         .case_text = std::string(double_gap) + water + ramp(100),
         .accuracies = to_1e8,
         .quick_accuracies = quick,
         .truth = Truth::double_gap_ramp},
        {.name = "box-ramp",
         .title = "water between plates 1 mm apart, ramp 0 to 100 1/s in 35 s",
         .kind = "box, ramp",
         .case_text = std::string(plates) + water + ramp(100),
         .accuracies = to_1e8,
         .quick_accuracies = quick,
         .truth = Truth::start_up_series},
        {.name = "slurry-steady",
         .title = "Herschel-Bulkley slurry in a 1 mm gap, steady at 1, 10, 100 and 1000 1/s",
         .kind = "Herschel-Bulkley, single gap",
         .case_text = std::string(single_gap) + slurry +
                      steady("\"1 1/s\", \"10 1/s\", \"100 1/s\", \"1000 1/s\"") + at_bob_wall,
         .accuracies = {1e-1, 1e-3, 1e-6, 1e-9},
         .quick_accuracies = {1e-3, 1e-9},
         .truth = Truth::steady_gap},
        {.name = "slurry-ramp",
         .title = "Herschel-Bulkley slurry in a 1 mm gap, ramp 0 to 150 1/s in 35 s",
         .kind = "Herschel-Bulkley, single gap",
         .case_text = std::string(single_gap) + slurry + ramp(150) + at_bob_wall,
         .accuracies = to_1e6,
         .quick_accuracies = {1e-1, 1e-2, 1e-3, 1e-4},
         .truth = Truth::finer_run,
         .reference_accuracy = 1e-7},
        {.name = "din-creeping",
         .title = "ISO bob, Newtonian, creeping",
         .kind = "DIN bob, creeping",
         .case_text = std::string(iso_bob) + syrup + steady("\"10 1/s\"") + at_bob_wall +
                      "[solver]\nmodel = \"axisymmetric\"\nsecondary_flow = false\n",
         .accuracies = to_1e6,
         .quick_accuracies = quick,
         .truth = Truth::finer_run,
         .reference_accuracy = 3e-8},
        {.name = "din-slurry",
         .title = "ISO bob, Herschel-Bulkley slurry at 1 1/s, creeping",
         .kind = "Herschel-Bulkley, DIN bob",
         .case_text = std::string(iso_bob) + slurry + steady("\"1 1/s\"") + at_bob_wall +
                      "[solver]\nmodel = \"axisymmetric\"\n",
         .accuracies = {1e-1, 1e-2, 1e-3, 1e-4},
         .quick_accuracies = few,
         .truth = Truth::finer_run,
         .reference_accuracy = 5e-6},
        {.name = "din-secondary-10",
         .title = "ISO bob, water at 10 1/s, secondary flow",
         .kind = "DIN bob, secondary flow",
         .case_text = std::string(iso_bob) + water + steady("\"10 1/s\"") + at_bob_wall,
         .accuracies = to_1e5,
         .quick_accuracies = few,
         .truth = Truth::finer_run,
         .reference_accuracy = 3e-7},
        {.name = "din-secondary-100",
         .title = "ISO bob, water at 100 1/s, secondary flow",
         .kind = "DIN bob, secondary flow",
         .case_text = std::string(iso_bob) + water + steady("\"100 1/s\"") + at_bob_wall,
         .accuracies = to_1e5,
         .quick_accuracies = few,
         .truth = Truth::finer_run,
         .reference_accuracy = 3e-7},
        {.name = "taylor-vortices",
         .title = "water in a 2 mm gap at 60 1/s (onset 36.13 1/s), Taylor vortices",
         .kind = "Taylor vortices",
         .case_text = std::string(wide_gap) + water + steady("\"60 1/s\"") + at_bob_wall +
                      "[solver]\nmodel = \"axisymmetric\"\n",
         .accuracies = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6},
         .quick_accuracies = few,
         .truth = Truth::finer_run,
         .reference_accuracy = 1e-8},
    };
}

std::vector<BenchScene> suspensions() {
    return {
        {.name = "suspension-dilute",
         .title = "spheres in bulk, 1 % by volume",
         .kind = "suspension, dilute",
         .case_text = cube(30) + water + strained(0.5, 0.1) +
                      "[particles]\ndiameter = \"1.5 um\"\ndensity = \"998.2 kg/m^3\"\n"
                      "volume_fraction = 0.01\nboundary = \"lees-edwards\"\n"
                      "hydrodynamics = \"lubrication\"\ncontact = { stiffness = \"1e-2 N/m\" }\n",
         .accuracies = {1e-1, 1e-2, 1e-3},
         .quick_accuracies = {1e-2},
         .truth = Truth::known_value,
         .relative_viscosity = 1.025 + 5.2e-4,
         .relative_viscosity_error = 2.4e-4,
         .source =
             "Einstein and Batchelor & Green, 1 + 2.5 phi + 5.2 phi^2 (7.6 phi^2 in pure strain)",
         .strain = 0.5},
        {.name = "suspension-dense",
         .title = "500 spheres 1 : 1.4 in bulk, 50 % by volume, lubrication, no friction",
         .kind = "suspension, dense",
         .case_text = dense(14.4, 2.0, 1.0, 0.0),
         .accuracies = {1e-1, 1e-2},
         .quick_accuracies = {1e-2},
         .truth = Truth::known_value,
         .relative_viscosity = 15.1,
         .relative_viscosity_error = 0.066,
         .source = "LF_DEM, strain 1 to 4, one realisation",
         .strain = 2.0},
        {.name = "suspension-dense-friction",
         .title = "500 spheres 1 : 1.4 in bulk, 50 % by volume, lubrication, friction 1",
         .kind = "suspension, dense",
         .case_text = dense(14.4, 2.0, 1.0, 1.0),
         .accuracies = {1e-1, 1e-2},
         .quick_accuracies = {},
         .truth = Truth::known_value,
         .relative_viscosity = 82.0,
         .relative_viscosity_error = 0.2,
         .source = "LF_DEM, strain 1 to 4, one realisation",
         .strain = 2.0,
         .long_run = true},
        {.name = "suspension-coupled",
         .title = "the coupled case of the paper: 3310 spheres between walls, drag and contacts",
         .kind = "suspension, coupled",
         .case_text = zirconia(""),
         .accuracies = {1e-1, 1e-2, 1e-3},
         .quick_accuracies = {1e-2},
         .truth = Truth::finer_run,
         .reference_accuracy = 3e-4,
         .strain = 1.0},
        {.name = "suspension-dlvo",
         .title = "the coupled case with double layers",
         .kind = "suspension, DLVO",
         .case_text = zirconia("dlvo = { hamaker = \"6e-20 J\", zeta_potential = \"32 mV\", "
                               "debye_length = \"10 nm\" }\n"),
         .accuracies = {1e-1, 1e-2, 1e-3},
         .quick_accuracies = {1e-2},
         .truth = Truth::finer_run,
         .reference_accuracy = 3e-4,
         .strain = 1.0},
    };
}

} // namespace

const std::vector<BenchScene>& bench_scenes() {
    static const std::vector<BenchScene> scenes = [] {
        std::vector<BenchScene> all = fluids();
        for (BenchScene& scene : suspensions())
            all.push_back(std::move(scene));
        return all;
    }();
    return scenes;
}

} // namespace searle::app::bench
