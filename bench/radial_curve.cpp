// Run time against error of the transient radial solver: the 35 s ramp 0 to 100 1/s in a 14/15 mm
// gap, 100 rows, water and the slurry (5 Pa, 0.5 Pa s^n, n = 0.5), asked accuracy 1e-1 ... 1e-9.
// Water is judged by the exact series, the slurry by the solver's own run at 2e-10, whose error bar
// is printed. Usage: bench_radial_curve [folder for radial_curve.csv and radial_curve.svg = .]

#include "rheometry/report/plot.hpp"
#include "solvers/radial/annular_gap.hpp"
#include "solvers/radial/transient_levels.hpp"
#include "verification/newtonian_start_up.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

using namespace searle;
using solvers::radial::RotorGap;

namespace {

constexpr double bob = 0.014;
constexpr double cup = 0.015;
constexpr double density = 998.2;
constexpr double duration = 35.0;
constexpr int rows = 100;

rheometry::SpeedHistory ramp() {
    const double delta = cup / bob;
    const double speed = 100.0 * (delta * delta - 1.0) / (2.0 * delta * delta);
    rheometry::SpeedHistory history;
    history.pieces = {{0.0, duration, 0.0, speed}};
    for (int k = 1; k <= rows; ++k) {
        history.row_times.push_back(duration * k / rows);
    }
    return history;
}

std::vector<double> exact_water(const laws::flow::Newtonian& water,
                                const rheometry::SpeedHistory& history) {
    const auto exact =
        verification::NewtonianStartUp::annulus(bob, cup, water.viscosity / density, 60);
    std::vector<double> flux;
    for (const double time : history.row_times) {
        flux.push_back(2.0 * water.viscosity * history.speed_at(time) * bob * bob * cup * cup /
                       ((cup - bob) * (cup + bob)) * exact.viscosity_ratio(time));
    }
    return flux;
}

struct CurvePoint {
    double asked, error, bar, milliseconds;
    int elements;
    long steps;
};

} // namespace

int main(int argc, char** argv) {
    const std::string folder = argc > 1 ? argv[1] : ".";
    const rheometry::SpeedHistory history = ramp();
    const RotorGap gap{{.planar = false, .inner = bob, .outer = cup, .density = density}, -1.0};
    const laws::flow::Newtonian water{1.0016e-3};
    const laws::flow::HerschelBulkley slurry{5.0, 0.5, 0.5};
    const auto finest = solvers::radial::solve_levels({&gap, 1}, slurry, history, 2e-10, {});
    fmt::print("slurry's reference: error bar {:.1e}\n\n", finest.worst_relative_error);

    std::ofstream csv(folder + "/radial_curve.csv");
    csv << "fluid,asked,true_error,error_bar,cpu_ms,elements,steps\n";
    rheometry::report::Plot plot;
    plot.id = "radial-curve";
    plot.title = "CPU time against true error, 100-point ramp in a 1 mm gap";
    plot.x.name = rheometry::report::RichText("largest true relative error");
    plot.x.scale = rheometry::report::Scale::logarithmic;
    plot.y.name = rheometry::report::RichText("CPU time (ms)");
    plot.y.scale = rheometry::report::Scale::logarithmic;
    fmt::print("{:8s} {:>9s} {:>11s} {:>11s} {:>10s} {:>9s} {:>7s}\n", "fluid", "asked",
               "true error", "error bar", "CPU ms", "elements", "steps");
    for (const bool newtonian : {true, false}) {
        const laws::flow::AnyFlowLaw law =
            newtonian ? laws::flow::AnyFlowLaw{water} : laws::flow::AnyFlowLaw{slurry};
        const std::vector<double> truth = newtonian ? exact_water(water, history) : finest.torque;
        const std::string name = newtonian ? "water" : "slurry";
        std::vector<CurvePoint> points;
        for (int digit = 1; digit <= 9; ++digit) {
            const double asked = std::pow(10.0, -digit);
            CurvePoint point{asked, 0.0, 0.0, 1e300, 0, 0};
            for (int repeat = 0; repeat < (digit < 7 ? 5 : 1); ++repeat) {
                const std::clock_t begin = std::clock();
                const auto found =
                    solvers::radial::solve_levels({&gap, 1}, law, history, asked, {});
                point.milliseconds =
                    std::min(point.milliseconds,
                             1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
                point.bar = found.worst_relative_error;
                point.elements = found.elements;
                point.steps = found.steps;
                point.error = 0.0;
                for (std::size_t k = 0; k < truth.size(); ++k) {
                    point.error =
                        std::max(point.error, std::abs(found.torque[k] / std::abs(truth[k]) - 1.0));
                }
            }
            fmt::print("{:8s} {:9.0e} {:11.1e} {:11.1e} {:10.2f} {:9d} {:7d}\n", name, point.asked,
                       point.error, point.bar, point.milliseconds, point.elements, point.steps);
            csv << fmt::format("{},{:.0e},{:.3e},{:.3e},{:.3f},{},{}\n", name, point.asked,
                               point.error, point.bar, point.milliseconds, point.elements,
                               point.steps);
            points.push_back(point);
        }
        rheometry::report::Series series;
        series.name = rheometry::report::RichText(newtonian ? "water, exact reference"
                                                            : "Herschel–Bulkley slurry");
        series.colour = newtonian ? 0 : 1;
        series.marker =
            newtonian ? rheometry::report::Marker::circle : rheometry::report::Marker::square;
        series.stroke = rheometry::report::Stroke::solid;
        for (const CurvePoint& point : points) {
            series.x.push_back(point.error);
            series.y.push_back(point.milliseconds);
        }
        plot.series.push_back(series);
    }
    std::ofstream(folder + "/radial_curve.svg") << rheometry::report::svg_file(plot);
    return 0;
}
