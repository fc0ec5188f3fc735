#include "app/stress/random_case.hpp"

#include "app/stress/family_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace searle::app {
namespace {

struct Family {
    const char* name;
    RandomCase (*draw)(Draw&);
    bool by_default; ///< false: needs a program that need not be here
};

constexpr Family families[] = {{"fluid", fluid_case, true},
                               {"extreme", extreme_case, true},
                               {"particles", particle_case, true},
                               {"input", input_case, true},
                               {"openfoam", openfoam_case, false}};

} // namespace

std::vector<std::string> stress_families() {
    std::vector<std::string> names;
    for (const Family& family : families)
        names.emplace_back(family.name);
    return names;
}

std::vector<std::string> usual_stress_families() {
    std::vector<std::string> names;
    for (const Family& family : families)
        if (family.by_default)
            names.emplace_back(family.name);
    return names;
}

RandomCase random_case(std::string_view family, std::uint64_t seed, long number) {
    for (const Family& each : families)
        if (family == each.name) {
            Draw draw(seed, static_cast<std::uint64_t>(number));
            return each.draw(draw);
        }
    throw std::invalid_argument(fmt::format("no family {}", family));
}

RandomCase particle_case(Draw& draw) {
    const double diameter = draw.log_between(0.5e-6, 100e-6);
    const double fraction =
        draw.chance(0.1) ? draw.log_between(1e-3, 1e-2) : draw.between(0.01, 0.6);
    const double rate = draw.log_between(0.01, 1e4);
    const double box = diameter * draw.between(6.0, 10.0);
    const double viscosity = draw.log_between(1e-3, 1.0);
    const bool walls = draw.chance(0.5);
    const bool colloid = draw.chance(0.4);
    // As stiff as the shear needs for small overlaps, and two decades to either side.
    const double stiffness =
        6.0 * 3.14159265358979 * viscosity * diameter * rate * draw.log_between(10.0, 1e5);
    const char* level = draw.one_of({"drag", "stresslet", "lubrication"});
    RandomCase result;
    result.kind =
        fmt::format("{} {}{}", walls ? "walls" : "lees-edwards", level, colloid ? " dlvo" : "");
    result.text = fmt::format(
        "[geometry]\ntype = \"box\"\ngap = \"{0:.6g} m\"\nlength = \"{0:.6g} m\"\nwidth = "
        "\"{0:.6g} "
        "m\"\n\n[fluid]\nmodel = \"newtonian\"\nviscosity = \"{1:.6g} Pa.s\"\ndensity = \"1000 "
        "kg/m^3\"\n\n[protocol]\ntype = \"steps\"\nshear_rates = [\"{2:.6g} 1/s\"]\nhold_strain = "
        "{3:.4g}\n\n[solver]\naccuracy = \"1 %\"\n\n[particles]\ndiameter = \"{4:.6g} m\"\ndensity "
        "= "
        "\"{5:.6g} kg/m^3\"\nvolume_fraction = {6:.5g}\nboundary = \"{7}\"\ncontact = {{ stiffness "
        "= "
        "\"{8:.6g} N/m\", restitution = {9:.3g}, friction = {10:.3g} }}\nhydrodynamics = "
        "\"{11}\"\nseed = {12}\n{13}",
        box, viscosity, rate, draw.log_between(0.01, 0.2), diameter, draw.between(1000.0, 6000.0),
        fraction, walls ? "walls" : "lees-edwards", stiffness, draw.between(0.3, 0.95),
        draw.between(0.0, 1.0), level, draw.integer(1, 1'000'000),
        colloid ? fmt::format("dlvo = {{ hamaker = \"{:.4g} J\", zeta_potential = \"{:.4g} mV\", "
                              "debye_length = \"{:.4g} nm\" }}\n",
                              draw.log_between(1e-21, 1e-18), draw.between(5.0, 80.0),
                              draw.log_between(1.0, 30.0))
                : "");
    if (draw.chance(0.2)) { // Hertz, about as stiff
        const std::size_t at = result.text.find("stiffness = ");
        result.text.replace(at, result.text.find(',', at) - at, "model = \"hertz\"");
        result.text += fmt::format("shear_modulus = \"{:.6g} Pa\"\npoisson_ratio = {:.3g}\n",
                                   stiffness / diameter, draw.between(0.0, 0.49));
        result.kind += " hertz";
    }
    return result;
}

RandomCase input_case(Draw& draw) {
    RandomCase result = draw.chance(0.7) ? fluid_case(draw) : particle_case(draw);
    std::string& text = result.text;
    result.kind = "mangled";
    result.physical = false;
    const auto place = [&] {
        return static_cast<std::size_t>(draw.unit() * static_cast<double>(text.size()));
    };
    for (int change = draw.integer(1, 4); change > 0 && !text.empty(); --change) {
        switch (draw.integer(0, 6)) {
        case 0: // a byte
            text[place()] = static_cast<char>(draw.integer(0, 255));
            break;
        case 1: // a piece goes
            text.erase(place(), static_cast<std::size_t>(draw.integer(1, 30)));
            break;
        case 2: { // a piece twice
            const std::string piece =
                text.substr(place(), static_cast<std::size_t>(draw.integer(1, 60)));
            text.insert(place(), piece);
            break;
        }
        case 3: { // a number becomes another
            std::size_t at = place();
            while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) == 0)
                ++at;
            if (at < text.size())
                text.replace(
                    at, 1,
                    draw.one_of({"-1", "0", "1e308", "1e-320", "nan", "inf", "9999999999", "0x1"}));
            break;
        }
        case 4: { // a unit becomes another
            const std::size_t at = text.find(draw.one_of({" Pa", " m\"", " 1/s", " s\"", " kg"}));
            if (at != std::string::npos)
                text.insert(at + 1, draw.one_of({"k", "1/", "m", "", "µ", "Pa"}));
            break;
        }
        case 5: // cut off
            text.resize(place());
            break;
        default: // an unknown key
            text.insert(place(),
                        draw.one_of({"\nx = 1\n", "\n[[sweep.runs]]\n", "\n[sweep]\nvary = {}\n",
                                     "\"\"\"", "\n[mesh]\nangular_cells = 3\n"}));
        }
    }
    return result;
}

} // namespace searle::app
