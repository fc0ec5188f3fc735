#include "solvers/openfoam/transport.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>
#include <string>

// OpenFOAM's viscosity models by their published formulas, evaluated with the numbers that are
// written, against the flow laws themselves.

namespace searle::solvers::openfoam {
namespace {

namespace flow = laws::flow;

/// Entries "name  number;" of a dictionary, the inner ones before the outer `nu`.
std::map<std::string, double> entries_of(const std::string& text) {
    std::map<std::string, double> entries;
    std::istringstream lines(text.substr(text.find('{') == std::string::npos ? 0 : text.find('{')));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name;
        double value{};
        if (words >> name >> value)
            entries[name] = value;
    }
    return entries;
}

double kinematic_viscosity(const std::string& text, double rate) {
    std::map<std::string, double> c = entries_of(text);
    const auto is = [&text](const char* model) { return text.find(model) != std::string::npos; };
    if (is("HerschelBulkley"))
        return std::min(c["nu0"], (c["tau0"] + c["k"] * std::pow(rate, c["n"])) / rate);
    if (is("powerLaw"))
        return std::max(c["nuMin"], std::min(c["nuMax"], c["k"] * std::pow(rate, c["n"] - 1)));
    if (is("Casson"))
        return std::max(
            c["nuMin"],
            std::min(c["nuMax"], std::pow(std::sqrt(c["tau0"] / rate) + std::sqrt(c["m"]), 2)));
    if (is("BirdCarreau"))
        return c["nuInf"] + (c["nu0"] - c["nuInf"]) * std::pow(1 + std::pow(c["k"] * rate, c["a"]),
                                                               (c["n"] - 1) / c["a"]);
    if (is("CrossPowerLaw"))
        return c["nuInf"] + (c["nu0"] - c["nuInf"]) / (1 + std::pow(c["m"] * rate, c["n"]));
    return c["nu"];
}

TEST(Transport, every_law_keeps_its_stress) {
    const flow::AnyFlowLaw laws[] = {flow::Newtonian{1.0016e-3},
                                     flow::Bingham{5.0, 0.02},
                                     flow::PowerLaw{0.5, 0.4},
                                     flow::PowerLaw{0.002, 1.6},
                                     flow::HerschelBulkley{5.0, 0.5, 0.5},
                                     flow::Casson{3.0, 0.01},
                                     flow::CarreauYasuda{10.0, 1e-3, 2.0, 0.3, 1.4},
                                     flow::Cross{10.0, 1e-3, 2.0, 0.3}};
    constexpr double density = 1234.5;
    for (const flow::AnyFlowLaw& law : laws) {
        const std::string text = transport_text(law, density, 1e9);
        for (const double rate : {1e-2, 1.0, 37.0, 1e3})
            EXPECT_NEAR(density * kinematic_viscosity(text, rate) * rate / flow::stress(law, rate),
                        1.0, 1e-12)
                << flow::name_of(law) << " at " << rate << "\n"
                << text;
    }
}

TEST(Transport, laws_with_a_yield_stress_of_zero_are_what_is_left_of_them) {
    const std::string newtonian = transport_text(flow::Newtonian{2.0}, 1000.0, 0.0);
    EXPECT_EQ(transport_text(flow::Bingham{0.0, 2.0}, 1000.0, 0.0), newtonian);
    EXPECT_EQ(transport_text(flow::Casson{0.0, 2.0}, 1000.0, 0.0), newtonian);
    EXPECT_FALSE(needs_viscosity_cap(flow::Bingham{0.0, 2.0}));
    const flow::HerschelBulkley thinning{0.0, 3.0, 0.5};
    EXPECT_TRUE(needs_viscosity_cap(thinning));
    EXPECT_EQ(transport_text(thinning, 1000.0, 50.0),
              transport_text(flow::PowerLaw{3.0, 0.5}, 1000.0, 50.0));
}

TEST(Transport, laws_without_a_bound_at_rest_get_the_cap) {
    EXPECT_TRUE(needs_viscosity_cap(flow::Bingham{5.0, 0.02}));
    EXPECT_TRUE(needs_viscosity_cap(flow::PowerLaw{0.5, 0.4}));
    EXPECT_FALSE(needs_viscosity_cap(flow::PowerLaw{0.5, 1.4}));
    EXPECT_FALSE(needs_viscosity_cap(flow::Newtonian{1e-3}));
    const std::string text = transport_text(flow::HerschelBulkley{5.0, 0.5, 0.5}, 1000.0, 50.0);
    EXPECT_DOUBLE_EQ(1000.0 * kinematic_viscosity(text, 1e-9), 50.0);
}

} // namespace
} // namespace searle::solvers::openfoam
