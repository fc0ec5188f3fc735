#include "app/solved_case.hpp"
#include "app/verify/check.hpp"
#include "laws/colloid/dlvo.hpp"
#include "laws/colloid/double_layer.hpp"
#include "laws/colloid/hamaker.hpp"
#include "laws/contact/contact_law.hpp"
#include "laws/contact/rayleigh_time.hpp"
#include "laws/drag/di_felice.hpp"
#include "laws/drag/ergun_wen_yu.hpp"
#include "laws/lubrication/near_contact.hpp"
#include "solvers/particles/motion.hpp"
#include "solvers/particles/pair_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace searle::app::verify {
namespace {

namespace colloid = laws::colloid;
namespace contact = laws::contact;
using namespace solvers::particles;

constexpr double pi = std::numbers::pi;
constexpr double kelvin_298 = 1.380649e-23 * 298.0;

template <class Layer>
colloid::Dlvo<Layer> zirconia(double hamaker) {
    colloid::Dlvo<Layer> dlvo;
    dlvo.attraction.hamaker = hamaker;
    dlvo.layer.permittivity = 80.1 * colloid::vacuum_permittivity;
    dlvo.layer.potential = 32e-3;
    dlvo.layer.inverse_thickness = 1.0 / 10e-9;
    dlvo.minimum_separation = 0.3e-9;
    dlvo.cutoff = 100e-9;
    return dlvo;
}

/// Barriers and secondary minima in kT, in half units of the tabled digits.
template <class Layer>
double off_the_table(const std::array<std::array<double, 3>, 2>& rows) {
    double worst = 0.0;
    for (const auto& [hamaker, barrier, minimum] : rows) {
        const auto curve = colloid::dlvo_curve(zirconia<Layer>(hamaker), 0.75e-6, 0.75e-6);
        worst = std::max({worst, std::abs(curve.barrier / kelvin_298 - barrier) / 0.5,
                          std::abs(curve.secondary_minimum / kelvin_298 - minimum) / 0.05});
    }
    return worst;
}

Found dlvo_table() {
    return {std::max(
        off_the_table<colloid::WeakOverlap>({{{1e-19, 222, -15.0}, {6e-20, 342, -7.7}}}),
        off_the_table<colloid::ConstantPotential>({{{1e-19, 136, -15.0}, {6e-20, 224, -7.7}}}))};
}

/// The attraction against the energy's central difference, and both limits of the energy.
Found hamaker_limits() {
    const colloid::Hamaker<double> law{6e-20};
    constexpr double a = 0.75e-6;
    double worst = 0.0;
    for (const double h : {1e-9, 1e-7, 1e-5}) {
        const double step = 1e-4 * h;
        const double slope = (law.energy(h + step, a, a) - law.energy(h - step, a, a)) / (2 * step);
        worst = std::max(worst, relative(law.attraction(h, a, a), slope));
    }
    worst = std::max(worst, 1e-3 * relative(law.energy(1e-13, a, a), -6e-20 * a / (12 * 1e-13)));
    return {worst};
}

Found debye_of_a_millimole() {
    return {std::abs(colloid::debye_length(78.5, 298.15, 1.0) - 9.61e-9)};
}

constexpr double radius = 1e-3;
constexpr double density = 2500.0;

/// Two equal spheres that meet head on, by the program's own contacts and steps.
class HeadOn {
public:
    HeadOn(const contact::AnyContact& law, double speed)
        : forces_(make_pair_forces(law, NoColloid{}, 1)) {
        pair_.add(0.5, 0.5, 0.5, radius, density);
        pair_.add(0.5 + 2.0 * radius, 0.5, 0.5, radius, density);
        pair_.vx[0] = 0.5 * speed;
        pair_.vx[1] = -0.5 * speed;
        list_.rebuild(pair_, box_);
    }
    void advance(double step) {
        if (list_.is_stale_after(pair_, kick_and_drift(pair_, step, 0.0, 1), 0.0))
            list_.rebuild(pair_, box_);
        clear_forces(pair_);
        forces_->evaluate(pair_, box_, list_, step, false);
        kick(pair_, step, 1);
    }
    [[nodiscard]] double mass() const { return 0.5 * pair_.mass[0]; } ///< reduced
    [[nodiscard]] double overlap() const { return 2.0 * radius - (pair_.x[1] - pair_.x[0]); }
    [[nodiscard]] double separating_speed() const { return pair_.vx[1] - pair_.vx[0]; }

private:
    ParticleStore pair_;
    ShearBox box_{.length_x = 1.0, .length_y = 1.0, .length_z = 1.0};
    NeighbourList list_{0.0, 0.2 * radius};
    std::unique_ptr<PairForces> forces_;
};

/// Largest error of the restitution for three of them, at steps of 1/100, 1/200 and 1/400 of a
/// contact.
Found restitution() {
    std::vector<double> errors;
    for (const int finer : {1, 2, 4}) {
        double worst = 0.0;
        for (const double asked : {1.0, 0.9, 0.3}) {
            const contact::Hooke law{.normal_stiffness = 1e3,
                                     .damping_ratio = contact::damping_ratio(asked)};
            HeadOn pair(law, 0.1);
            const double step = 0.01 / finer * law.duration(pair.mass());
            for (int k = 0; k < 110 * finer; ++k)
                pair.advance(step);
            worst = std::max(worst, std::abs(pair.separating_speed() / 0.1 - asked));
        }
        errors.push_back(worst);
    }
    return {errors[2], order_of(errors[1], errors[2])};
}

/// How long elastic spheres touch, by the program's own contacts and steps.
Found hertz_duration() {
    // (4/5) sqrt(pi) Gamma(2/5) / Gamma(9/10) times the deepest overlap over the speed.
    constexpr double constant = 2.9432749;
    constexpr double speed = 0.1;
    const contact::Hertz law{.shear_modulus = 1e7, .poisson_ratio = 0.3};
    std::vector<double> errors;
    for (const double share : {0.02, 0.01, 0.005}) {
        HeadOn pair(law, speed);
        const double expected =
            constant * law.deepest_overlap(speed, 0.5 * radius, pair.mass()) / speed;
        const double step = share * expected;
        double before = 0.0;
        double found = 0.0;
        for (int k = 0; k < static_cast<int>(1.5 / share); ++k) {
            pair.advance(step);
            if (before > 0.0 && pair.overlap() <= 0.0)
                found = step * (k + before / (before - pair.overlap()));
            before = pair.overlap();
        }
        errors.push_back(std::abs(found / expected - 1.0));
    }
    return {errors[2], order_of(errors[1], errors[2])};
}

/// Tangential over Coulomb's limit, before and after sliding begins.
Found coulomb() {
    constexpr double friction = 0.3;
    const contact::Hooke law{
        .normal_stiffness = 1e3, .tangential_stiffness = 1e3 * 2 / 7, .friction = friction};
    ParticleStore pair;
    pair.add(0.5, 0.5, 0.5, radius, density);
    pair.add(0.5 + 1.99 * radius, 0.5, 0.5, radius, density);
    ShearBox box{.length_x = 1.0, .length_y = 1.0, .length_z = 1.0};
    NeighbourList list(0.0, 0.2 * radius);
    list.rebuild(pair, box);
    const auto forces = make_pair_forces(law, NoColloid{}, 1);
    pair.vy[1] = 1e-3;
    const double normal = 1e3 * 0.01 * radius;
    double worst = 0.0;
    for (const double travelled : {0.1, 0.5, 0.99, 1.5, 3.0}) {
        for (auto* spring : {&list.spring_x, &list.spring_y, &list.spring_z})
            spring->assign(1, 0.0);
        clear_forces(pair);
        forces->evaluate(pair, box, list,
                         travelled * friction * normal / law.tangential_stiffness / 1e-3, false);
        worst =
            std::max({worst, std::abs(pair.fy[1] / (-friction * normal) - std::min(travelled, 1.0)),
                      std::abs(pair.fx[1] / normal - 1.0)});
    }
    return {worst};
}

Found rayleigh() {
    // physics of the paper's zirconia: E 200 GPa, Poisson's ratio 0.3, 1.5 um: 6.9e-10 s.
    return {std::abs(contact::rayleigh_time(0.75e-6, 5700.0, 200e9 / 2.6, 0.3) - 6.9e-10)};
}

Found drag_limits() {
    const laws::drag::DiFelice felice{.viscosity = 1e-3, .density = 1000.0};
    const laws::drag::ErgunWenYu wen{.viscosity = 1e-3, .density = 1000.0};
    const double stokes = 6.0 * pi * 1e-3 * 1e-6;
    return {std::max(relative(felice.coefficient(1e-6, 0.0, 1.0), 0.96 * stokes),
                     relative(wen.coefficient(1e-6, 0.0, 1.0), stokes))};
}

Found lubrication() {
    using namespace laws::lubrication;
    constexpr double xi = 5e-5;
    const Film at = film(xi, 1.0, 1.0, 1.0, Squeeze::both);
    const double log = std::log(1.0 / xi);
    return {std::max({relative(at.squeeze / (6 * pi), 0.25 / xi + 9.0 / 40.0 * log),
                      relative(at.shear / (6 * pi), log / 6.0),
                      relative((at.shear + at.pump) / (8 * pi), 0.2 * log)})};
}

SolvedCase solved(const std::string& text, const std::string& name) {
    return solve_case(plan_case(read_cases_text(text, name).front(), StageClock()), {});
}

std::string water_box(const char* side, const char* protocol) {
    return fmt::format("[geometry]\ntype = \"box\"\ngap = \"{0}\"\nlength = \"{0}\"\nwidth = "
                       "\"{0}\"\n[fluid]\nmodel = \"newtonian\"\nviscosity = \"1 mPa.s\"\ndensity "
                       "= \"1000 kg/m^3\"\n[protocol]\n{1}\n",
                       side, protocol);
}

/// 153 spheres that only have their stresslets.
Found einstein() {
    constexpr double volume_fraction = 153 * 1.7671458676442587e-18 / 2.7e-14;
    const SolvedCase found =
        solved(water_box("30 um", "type = \"steps\"\nshear_rates = [\"100 1/s\"]\nhold_strain = "
                                  "0.3\ndiscard_strain = 0.1") +
                   fmt::format("[particles]\ndiameter = \"1.5 um\"\ndensity = \"1000 kg/m^3\"\n"
                               "volume_fraction = {:.15g}\nboundary = \"lees-edwards\"\n"
                               "hydrodynamics = \"stresslet\"\ndrag = \"stokes\"\n",
                               volume_fraction),
               "einstein.toml");
    const double ratio = found.rheogram.points.at(0).shear_stress / (1e-3 * 100.0);
    return {relative((ratio - 1.0) / (2.5 * volume_fraction), 1.0)};
}

/// Dilute spheres with drag alone leave the fluid its plane ramp, 1 + d^2 / (3 nu t).
Found coupled_ramp() {
    const SolvedCase found =
        solved(water_box("50 um", "type = \"ramp\"\nfrom = \"0 1/s\"\nto = \"180 1/s\"\nduration = "
                                  "\"20 ms\"\npoints = 2") +
                   "[particles]\ndiameter = \"1.5 um\"\ndensity = \"1000 kg/m^3\"\n"
                   "volume_fraction = 1e-4\nhydrodynamics = \"drag\"\ndrag = \"stokes\"\n"
                   "[coupling]\ncells = [4, 32, 4]\n",
               "ramp.toml");
    double worst = 0.0;
    for (const rheometry::RheogramPoint& point : found.rheogram.points)
        worst = std::max(
            worst, relative(point.shear_stress,
                            1e-3 * point.shear_rate * (1.0 + 2.5e-9 / (3.0 * 1e-6 * point.time))));
    return {worst};
}

} // namespace

std::vector<Check> particle_checks() {
    const std::string laws = "tests/laws/particle_laws_test.cpp";
    const std::string contacts = "tests/suspension/particles_contact_test.cpp";
    const std::string inertial = "tests/suspension/inertial_motion_test.cpp";
    return {
        {.name = "dlvo-barriers",
         .subject = "DLVO, zirconia, both double layers, two Hamaker constants",
         .against = "tabled barriers (222, 342, 136, 224 kT) and secondary minima; error in half "
                    "units of the last digit",
         .tolerance = 1.0,
         .origin = "half the values' last digits",
         .file = laws,
         .test = "Dlvo.zirconia_has_the_tabulated_barriers",
         .run = dlvo_table},
        {.name = "hamaker-derivative",
         .subject = "Hamaker's attraction of two spheres",
         .against = "central differences of its energy, and the energy at contact",
         .tolerance = 1e-6,
         .origin = "the difference's step, (1e-4)^2, and rounding",
         .file = laws,
         .test = "Hamaker.attraction_is_the_derivative_of_the_energy",
         .run = hamaker_limits},
        {.name = "debye-length",
         .subject = "Debye length of 1 mmol/l, 1:1, 25 degC; error in m",
         .against = "9.61 nm (Israelachvili 2011, eq. 14.37)",
         .tolerance = 0.02e-9,
         .origin = "the textbook's digits",
         .file = laws,
         .test = "DebyeLength.of_one_millimole_is_that_of_the_textbook",
         .run = debye_of_a_millimole},
        {.name = "contact-restitution",
         .subject = "contacts in time: restitution of head-on pairs, e = 1, 0.9, 0.3",
         .against = "e = exp(-pi gamma / sqrt(4 k m - gamma^2))",
         .tolerance = 3e-3,
         .origin = "velocity Verlet with 400 steps a contact, which ends between two steps",
         .least_order = 0.7,
         .file = contacts,
         .test = "HookeContact.a_head_on_pair_separates_with_its_restitution",
         .run = restitution},
        {.name = "contact-hertz",
         .subject = "contacts in time: duration of a head-on contact of elastic spheres",
         .against = "2.943275 times the deepest overlap over the speed (Landau & Lifshitz, Theory "
                    "of Elasticity, section 9)",
         .tolerance = 3e-5,
         .origin = "velocity Verlet with 200 steps a contact",
         .least_order = 1.6,
         .file = "tests/suspension/hertz_contact_test.cpp",
         .test = "HertzContact.a_head_on_pair_has_hertzs_duration_and_depth",
         .run = hertz_duration},
        {.name = "contact-coulomb",
         .subject = "contacts: tangential force before and after sliding",
         .against = "k_t s up to friction times the normal force",
         .tolerance = 3e-11,
         .origin = "rounding of the places over the overlap",
         .file = contacts,
         .test = "HookeContact.sliding_friction_is_coulombs",
         .run = coulomb},
        {.name = "rayleigh-time",
         .subject = "Rayleigh time of zirconia; error in s",
         .against = "6.9e-10 s",
         .tolerance = 5e-12,
         .origin = "half the value's last digit",
         .file = laws,
         .test = "RayleighTime.of_zirconia_is_that_of_the_paper",
         .run = rayleigh},
        {.name = "drag-limits",
         .subject = "drag at rest: Di Felice, Ergun-Wen-Yu",
         .against = "0.96 of Stokes' (4.8^2/24), and Stokes'",
         .tolerance = 1e-12,
         .origin = "rounding",
         .file = laws,
         .test = "DiFelice.has_its_finite_limit_at_rest",
         .run = drag_limits},
        {.name = "lubrication-coefficients",
         .subject = "lubrication of equal spheres: squeeze, shear, rotation",
         .against = "Jeffrey and Onishi 1984",
         .tolerance = 1e-11,
         .origin = "rounding",
         .file = "tests/laws/lubrication_test.cpp",
         .test = "NearContact.equal_spheres_have_jeffrey_and_onishis_coefficients",
         .run = lubrication},
        {.name = "suspension-einstein",
         .subject = "suspension in bulk, isolated stresslets: intrinsic viscosity",
         .against = "Einstein, 2.5",
         .tolerance = 2e-3,
         .origin = "the fluid's steps",
         .file = inertial,
         .test = "InertialMotion.isolated_stresslets_give_einsteins_viscosity",
         .run = einstein},
        {.name = "suspension-fluid-ramp",
         .subject = "coupled fluid between walls, nearly without particles: ramp from rest",
         .against = "1 + d^2 / (3 nu t)",
         .tolerance = 1e-3,
         .origin = "the accuracy asked of steps and grid (default 1e-3)",
         .file = inertial,
         .test = "InertialMotion.pure_fluid_follows_the_plane_ramp_to_second_order",
         .run = coupled_ramp},
    };
}

} // namespace searle::app::verify
