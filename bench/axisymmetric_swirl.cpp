// The DIN bob's target figures: error, bracket and CPU time of creeping and transient swirl.
#include "solvers/axisymmetric/creeping_swirl.hpp"
#include "solvers/axisymmetric/swirl_response.hpp"

#include <fmt/format.h>

#include <ctime>

namespace {

using namespace searle;
namespace flow = laws::flow;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void creeping(const char* name, const flow::AnyFlowLaw& law, double accuracy, bool certified) {
    const geometry::DinBob bob{.bob_radius = 1.0, .cup_radius = 1.0847};
    const double start = cpu_seconds();
    const auto found = solvers::axisymmetric::creeping_torque(
        bob, law, 1.0, {.accuracy = accuracy, .certified = certified});
    const double per = found.end_factor / found.torque;
    fmt::print(
        "{:34} {:7.0e} c_L {:.7f} +- {:.1e}  bracket {:.7f} ... {:.7f}  {:6.3f} s  {} levels, "
        "{} unknowns, {} Newton steps\n",
        name, accuracy, found.end_factor, found.error * per, found.lower * per, found.upper * per,
        cpu_seconds() - start, found.levels, found.unknowns, found.newton_steps);
}

} // namespace

int main() {
    creeping("Newtonian", flow::Newtonian{1.0}, 1e-3, false);
    creeping("Newtonian", flow::Newtonian{1.0}, 1e-5, true);
    creeping("Newtonian", flow::Newtonian{1.0}, 1e-8, false);
    creeping("power law n = 0.5", flow::PowerLaw{1.0, 0.5}, 1e-3, true);
    creeping("power law n = 0.5", flow::PowerLaw{1.0, 0.5}, 1e-5, true);
    creeping("Herschel-Bulkley 10/1/0.5", flow::HerschelBulkley{10.0, 1.0, 0.5}, 1e-3, false);
    creeping("Herschel-Bulkley 10/1/0.5, bracket", flow::HerschelBulkley{10.0, 1.0, 0.5}, 1e-3,
             true);
    searle::rheometry::SpeedHistory ramp;
    ramp.pieces = {{0.0, 35.0, 0.0, 100.0 / 12.187215}};
    for (int k = 1; k <= 100; ++k) {
        ramp.row_times.push_back(0.35 * k);
    }
    for (const double accuracy : {1e-3, 1e-5}) {
        const double start = cpu_seconds();
        const auto swirl = solvers::axisymmetric::transient_swirl(geometry::DinBob{0.014, 0.0152},
                                                                  1.0016e-3, 998.2, ramp, accuracy);
        fmt::print(
            "water ramp, 100 points, accuracy {:.0e}: worst error {:.1e}, {:.3f} s, {} modes\n",
            accuracy, swirl.worst_relative_error, cpu_seconds() - start, swirl.modes);
    }
}
