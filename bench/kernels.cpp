// Instructions of a handful of kernels, counted by valgrind's callgrind: the same on every run, so
// that a change that makes one dearer is seen however busy the machine is.
//
//   bench_kernels NAME                    runs a kernel once
//   bench_kernels --count                 counts all of them and prints the figures to store
//   bench_kernels --check kernel_counts   compares with stored figures; 1: dearer than the
//   tolerance, 77: cannot be
//                                         compared here, and says why
//
// Counts depend on the instruction set and the compiler: build with -DSEARLE_NATIVE=OFF (preset
// `counts`).

#include "app/case_reader.hpp"
#include "app/solved_case.hpp"
#include "rheometry/fit/fit.hpp"
#include "rheometry/fit/prediction.hpp"
#include "rheometry/report/number_text.hpp"
#include "rheometry/report/rich_text.hpp"
#include "solvers/axisymmetric/creeping_swirl.hpp"
#include "solvers/meridional/steady_secondary_flow.hpp"
#include "solvers/plan.hpp"
#include "solvers/radial/annular_gap.hpp"
#include "solvers/radial/transient_levels.hpp"
#include "solvers/stability/taylor_threshold.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

namespace {

using namespace searle;
using namespace laws::flow;

/// More than this above the stored figure is a failure: several times what another patch level of
/// the C library's exp, log and pow makes.
constexpr double tolerance = 0.03;
constexpr int cannot_compare = 77;

constexpr const char* water_case =
    "[geometry]\ntype = \"single-gap\"\nbob_radius = \"14 mm\"\ncup_radius = \"15 mm\"\nheight = "
    "\"42 mm\"\n[fluid]\nmodel = \"newtonian\"\nviscosity = \"1.0016 mPa.s\"\ndensity = \"998.2 "
    "kg/m^3\"\n[protocol]\ntype = \"ramp\"\nfrom = \"0 1/s\"\nto = \"100 1/s\"\nduration = \"35 "
    "s\"\npoints = 100\n";

double steady_gap() {
    double sum = 0.0;
    for (int k = 0; k < 200; ++k)
        sum += solvers::radial::steady_gap_flow({0.014, 0.015}, HerschelBulkley{5.0, 0.5, 0.5},
                                                0.01 * (1 + k))
                   .inner_wall_stress;
    return sum;
}

double ramp() {
    rheometry::SpeedHistory history{.pieces = {{0.0, 35.0, 0.0, 6.44}}, .row_times = {}};
    for (int k = 1; k <= 100; ++k)
        history.row_times.push_back(0.35 * k);
    const solvers::radial::RotorGap gap{
        {.planar = false, .inner = 0.014, .outer = 0.015, .density = 998.2}, -1.0};
    return solvers::radial::solve_levels({&gap, 1}, Newtonian{1.0016e-3}, history, 1e-3, {})
        .torque.back();
}

double slurry_ramp() {
    rheometry::SpeedHistory history{.pieces = {{0.0, 35.0, 0.0, 9.66}}, .row_times = {}};
    for (int k = 1; k <= 35; ++k)
        history.row_times.push_back(1.0 * k);
    const solvers::radial::RotorGap gap{
        {.planar = false, .inner = 0.014, .outer = 0.015, .density = 1250.0}, -1.0};
    return solvers::radial::solve_levels({&gap, 1}, HerschelBulkley{5.0, 0.5, 0.5}, history, 1e-3,
                                         {})
        .torque.back();
}

double onset() { return solvers::stability::taylor_threshold_with_modes(0.1, 24).reynolds; }

double creeping_bob() {
    return solvers::axisymmetric::creeping_torque(
               geometry::DinBob{.bob_radius = 1.0, .cup_radius = 1.0847}, Newtonian{1.0}, 1.0,
               {.accuracy = 1e-3})
        .end_factor;
}

double secondary_flow() {
    solvers::meridional::SteadySecondaryFlow flow({.bob_radius = 0.014, .cup_radius = 0.0151858},
                                                  Newtonian{1.0016e-3}, 998.2, 1e-2);
    return flow.at(0.75).factor;
}

double fit_curve() {
    namespace fit = rheometry::fit;
    const fit::Model& law = *fit::model_named("herschel-bulkley");
    const std::array truth{5.0, 0.9, 0.55};
    fit::FlowData data;
    data.rates = fit::spread_rates(0.01, 1000.0, 41);
    data.lines.assign(41, 0);
    for (std::size_t k = 0; k < data.rates.size(); ++k)
        data.stresses.push_back(law.stress(truth, data.rates[k]) * (k % 2 == 0 ? 1.01 : 0.99));
    return fit::fit_flow_curve(law, data, {}).estimates.front().value;
}

double read_case() {
    return app::read_cases_text(water_case, "case.toml").front().scene.fluid.density;
}

double plan() {
    return solvers::make_plan(app::read_cases_text(water_case, "case.toml").front().scene)
        .rows.back()
        .steady_stress;
}

/// All of `run` but its files.
double solve_case() {
    app::Case source = app::read_cases_text(water_case, "case.toml").front();
    return app::solve_case(app::plan_case(std::move(source), app::StageClock()), {})
        .rheogram.points.back()
        .shear_stress;
}

/// A gap that is partly sheared at the slow end, so that layers of all widths have their onset.
double plan_slurry() {
    const std::string text =
        "[geometry]\ntype = \"single-gap\"\nbob_radius = \"14 mm\"\ncup_radius = \"15 mm\"\nheight "
        "= \"42 mm\"\n[fluid]\nmodel = \"herschel-bulkley\"\nyield_stress = \"5 Pa\"\nconsistency "
        "= "
        "\"0.5 Pa.s^n\"\nflow_index = 0.5\ndensity = \"1250 kg/m^3\"\n[protocol]\ntype = "
        "\"steps\"\nshear_rates = { from = \"0.1 1/s\", to = \"1000 1/s\", count = 41, spacing = "
        "\"log\" }\nhold = \"steady\"\n";
    return solvers::make_plan(app::read_cases_text(text, "case.toml").front().scene)
        .rows.back()
        .steady_stress;
}

double numbers() {
    std::size_t size = 0;
    for (int k = 1; k <= 300; ++k)
        size += rheometry::report::significant(0.0123456 * k * k, 5).size();
    return static_cast<double>(size);
}

double escape() {
    std::size_t size = 0;
    for (int k = 0; k < 200; ++k)
        size +=
            rheometry::report::escaped("shear stress 0.1012 Pa at 100 1/s <laminar> & more").size();
    return static_cast<double>(size);
}

using Kernel = double (*)();
const std::map<std::string, Kernel, std::less<>>& kernels() {
    static const std::map<std::string, Kernel, std::less<>> all{{"steady-gap", steady_gap},
                                                                {"ramp-water", ramp},
                                                                {"ramp-slurry", slurry_ramp},
                                                                {"taylor-onset", onset},
                                                                {"creeping-bob", creeping_bob},
                                                                {"fit-curve", fit_curve},
                                                                {"secondary-flow", secondary_flow},
                                                                {"read-case", read_case},
                                                                {"plan", plan},
                                                                {"plan-slurry", plan_slurry},
                                                                {"solve-case", solve_case},
                                                                {"numbers", numbers},
                                                                {"escape", escape}};
    return all;
}

} // namespace

/// What is counted: valgrind is told this name.
extern "C" [[gnu::noinline]] double searle_counted(double (*kernel)()) { return kernel(); }

namespace {

/// Instructions of a kernel; no value when valgrind could not run it.
std::optional<double> count(const std::string& name) {
    const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
    const std::string command =
        fmt::format("valgrind --tool=callgrind --callgrind-out-file=/dev/null "
                    "--toggle-collect=searle_counted '{}' {} 2>&1",
                    self, name);
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::array<char, 512> line{};
    std::optional<double> found;
    while (pipe && std::fgets(line.data(), line.size(), pipe.get()) != nullptr)
        if (const std::string_view text = line.data(); text.find("Collected :") != text.npos)
            found = std::strtod(line.data() + text.find(':') + 1, nullptr);
    return found && *found > 0.0 ? found : std::nullopt;
}

/// What counts rest on beside the code.
std::string circumstances() { return fmt::format("g++ {}.{} baseline", __GNUC__, __GNUC_MINOR__); }

std::string why_not() {
    if (std::system("valgrind --version > /dev/null 2>&1") != 0)
        return "valgrind is not installed";
#ifdef __AVX__
    return "this build is tuned for its own processor; configure with -DSEARLE_NATIVE=OFF (preset "
           "counts)";
#else
    if (__builtin_cpu_supports("fma") == 0)
        return "this processor has no FMA, so the C library takes other functions";
    return "";
#endif
}

int skip(const std::string& reason) {
    fmt::print("not compared: {}\n", reason);
    return cannot_compare;
}

int check(const char* file) {
    std::ifstream stored(file);
    std::string first;
    if (!stored || !std::getline(stored, first)) {
        fmt::print(stderr, "{}: cannot be read\n", file);
        return 1;
    }
    if (const std::string reason = why_not(); !reason.empty())
        return skip(reason);
    if (first != "# " + circumstances())
        return skip(
            fmt::format("the figures are of '{}', this is '{}'", first.substr(2), circumstances()));
    std::map<std::string, double> figures;
    std::string name;
    for (double figure = 0.0; stored >> name >> figure;)
        figures[name] = figure;
    int dearer = 0;
    for (const auto& [kernel, run] : kernels()) {
        const auto figure = figures.find(kernel);
        const std::optional<double> counted = count(kernel);
        if (figure == figures.end() || !counted) {
            fmt::print("{}: {}\n", kernel, counted ? "no stored figure" : "could not be counted");
            ++dearer;
            continue;
        }
        const double change = *counted / figure->second - 1.0;
        const bool failed = change > tolerance;
        dearer += failed ? 1 : 0;
        fmt::print("{:<14} {:>12.0f}, stored {:>12.0f}: {:+.2f} %{}\n", kernel, *counted,
                   figure->second, 100.0 * change,
                   failed                ? "  DEARER"
                   : change < -tolerance ? "  cheaper: store the new figure"
                                         : "");
    }
    return dearer == 0 ? 0 : 1;
}

} // namespace

int main(int words, char** word) {
    const std::string_view first = words > 1 ? word[1] : "";
    if (first == "--check" && words == 3)
        return check(word[2]);
    if (first == "--count" && words == 2) {
        if (const std::string reason = why_not(); !reason.empty())
            return skip(reason);
        fmt::print("# {}\n", circumstances());
        for (const auto& [name, run] : kernels())
            fmt::print("{} {:.0f}\n", name, count(name).value_or(0.0));
        return 0;
    }
    const auto chosen = kernels().find(first);
    if (chosen == kernels().end() || words != 2) {
        fmt::print(stderr, "usage: bench_kernels NAME | --count | --check FILE; kernels:");
        for (const auto& [name, run] : kernels())
            fmt::print(stderr, " {}", name);
        fmt::print(stderr, "\n");
        return 2;
    }
    fmt::print("{:.17g}\n", searle_counted(chosen->second));
    return 0;
}
