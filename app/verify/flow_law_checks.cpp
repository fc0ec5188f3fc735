#include "app/verify/check.hpp"
#include "laws/flow/flow_law.hpp"
#include "solvers/radial/annular_gap.hpp"
#include "verification/precise_gap_speed.hpp"

#include <algorithm>
#include <variant>

namespace searle::app::verify {
namespace {

using namespace laws::flow;

/// Steady flow in narrow and wide gaps, slow and fast, against 50 digits.
Found against_fifty_digits(const AnyFlowLaw& law) {
    double worst = 0.0;
    for (const double ratio_squared_minus_one : {4e-3, 0.148, 3.0, 80.0})
        for (const double omega : {1e-4, 0.3, 40.0}) {
            const solvers::radial::AnnularGap gap{0.01,
                                                  0.01 * std::sqrt(1.0 + ratio_squared_minus_one)};
            const auto flow = solvers::radial::steady_gap_flow(gap, law, omega);
            worst = std::max(
                worst, std::abs(verification::steady_stress_error(
                           law, gap.ratio_squared_minus_one(), omega, flow.inner_wall_stress)));
        }
    return {worst};
}

Check of_law(const char* name, const char* title, const AnyFlowLaw& law) {
    return {.name = std::string("gap-") + name,
            .subject = std::string("steady flow in a gap, ") + title,
            .against = "an evaluation with 50 digits by another quadrature, 12 gaps and speeds",
            .tolerance = 1e-10,
            .origin = "what the solver states for its torque",
            .file = "tests/verification/steady_gap_test.cpp",
            .test = "SteadyGap.every_law_is_right_to_1e_minus_11_against_50_digits",
            .run = [law] { return against_fifty_digits(law); }};
}

/// The rate that a stress gives back, for every law.
Found rates_given_back() {
    double worst = 0.0;
    for (const AnyFlowLaw& law :
         {AnyFlowLaw{Newtonian{0.3}}, AnyFlowLaw{Bingham{3.0, 0.2}},
          AnyFlowLaw{PowerLaw{2.0, 0.35}}, AnyFlowLaw{HerschelBulkley{5.0, 0.5, 0.5}},
          AnyFlowLaw{Casson{3.0, 0.05}}, AnyFlowLaw{CarreauYasuda{1.0, 1e-3, 3.0, 0.4, 4.0}},
          AnyFlowLaw{Cross{1.0, 1e-3, 3.0, 0.4}}})
        for (const double at : {1e-2, 1.0, 50.0, 1e5})
            worst = std::max(worst, relative(rate(law, stress(law, at)), at));
    return {worst};
}

} // namespace

std::vector<Check> flow_law_checks() {
    return {
        {.name = "laws-inverse",
         .subject = "flow laws: the rate at a stress, all seven",
         .against = "the rate that the stress was made of",
         .tolerance = 1e-10,
         .origin = "rounding, where the stress is nearly all yield",
         .file = "tests/laws/flow_law_test.cpp",
         .test = "FlowLaws.give_the_rate_back_from_the_excess_stress",
         .run = rates_given_back},
        of_law("newtonian", "Newtonian", Newtonian{0.3}),
        of_law("bingham", "Bingham", Bingham{3.0, 0.2}),
        of_law("power-law", "power law", PowerLaw{2.0, 0.35}),
        of_law("herschel-bulkley", "Herschel-Bulkley", HerschelBulkley{5.0, 0.5, 0.5}),
        of_law("casson", "Casson", Casson{3.0, 0.05}),
        of_law("carreau-yasuda", "Carreau-Yasuda", CarreauYasuda{1.0, 1e-3, 3.0, 0.4, 4.0}),
        of_law("cross", "Cross", Cross{1.0, 1e-3, 3.0, 0.4}),
    };
}

} // namespace searle::app::verify
