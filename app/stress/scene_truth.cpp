#include "app/stress/scene_truth.hpp"

#include "laws/flow/flow_law.hpp"
#include "solvers/radial/annular_gap.hpp"
#include "verification/newtonian_start_up.hpp"
#include "verification/precise_gap_speed.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>

namespace searle::app {
namespace {

using solvers::radial::AnnularGap;

/// Torque of a steady gap, corrected by its error in 50 digits.
double precise_gap_torque(const AnnularGap& gap, const laws::flow::AnyFlowLaw& law, double speed,
                          double height) {
    const solvers::radial::SteadyGapFlow flow = steady_gap_flow(gap, law, std::abs(speed));
    const double error = verification::steady_stress_error(law, gap.ratio_squared_minus_one(),
                                                           std::abs(speed), flow.inner_wall_stress);
    return std::copysign(flow.torque_per_length * height * (1.0 + error), speed);
}

/// Rounding of what the corrected torque is put together from.
double rounding(double torque) {
    return 64.0 * std::numeric_limits<double>::epsilon() * std::abs(torque);
}

std::vector<AnnularGap> gaps_of(const geometry::Instrument& instrument, double& height) {
    if (const auto* single = std::get_if<geometry::ConcentricCylinders>(&instrument)) {
        height = single->height;
        return {{single->bob_radius, single->cup_radius}};
    }
    const auto& twice = std::get<geometry::DoubleGap>(instrument);
    height = twice.height;
    return {{twice.radii[0], twice.radii[1]}, {twice.radii[2], twice.radii[3]}};
}

SceneTruth steady_truth(const SolvedCase& solved) {
    const solvers::Scene& scene = solved.source.scene;
    SceneTruth truth{{}, {}, TruthBasis::digits};
    for (const rheometry::TorqueRow& row : solved.solution.history.rows) {
        double torque = 0.0;
        if (const auto* box = std::get_if<geometry::Box>(&scene.instrument)) {
            torque =
                std::copysign(laws::flow::stress(scene.fluid.law, std::abs(row.speed) / box->gap),
                              row.speed) *
                box->wall_area();
        } else {
            double height = 0.0;
            for (const AnnularGap& gap : gaps_of(scene.instrument, height))
                torque += precise_gap_torque(gap, scene.fluid.law, row.speed, height);
        }
        truth.torque.push_back(torque);
        truth.error.push_back(rounding(torque));
    }
    return truth;
}

/// The exact series of a Newtonian ramp from rest; empty where this is none.
SceneTruth series_truth(const SolvedCase& solved) {
    const solvers::Scene& scene = solved.source.scene;
    const auto* law = std::get_if<laws::flow::Newtonian>(&scene.fluid.law);
    const auto* ramp = std::get_if<rheometry::Ramp>(&scene.protocol.program);
    if (law == nullptr || ramp == nullptr || ramp->from.value != 0.0)
        return {};
    const double viscosity = law->viscosity / scene.fluid.density;
    constexpr int modes = 400;
    std::optional<verification::NewtonianStartUp> series;
    double gap = 0.0;
    if (const auto* box = std::get_if<geometry::Box>(&scene.instrument)) {
        gap = box->gap;
        series = verification::NewtonianStartUp::plane(gap, viscosity, modes);
    } else if (const auto* single = std::get_if<geometry::ConcentricCylinders>(&scene.instrument)) {
        gap = single->gap();
        series = verification::NewtonianStartUp::annulus(single->bob_radius, single->cup_radius,
                                                         viscosity, modes);
    } else {
        return {};
    }
    const double resolved = 30.0 * gap * gap / (viscosity * std::pow(std::numbers::pi * modes, 2));
    SceneTruth truth{{}, {}, TruthBasis::series};
    for (const rheometry::TorqueRow& row : solved.solution.history.rows) {
        if (row.time < resolved)
            return {};
        const double torque = row.steady_torque * series->viscosity_ratio(row.time);
        truth.torque.push_back(torque);
        truth.error.push_back(1e-9 *
                              std::abs(torque)); // of the series' modes and of the steady torque
    }
    return truth;
}

/// A run of a tenth of the error; around a bob's ends, where that is dear, of a third.
SceneTruth finer_truth(const SolvedCase& solved, double seconds) {
    const bool has_ends = geometry::has_ends(solved.source.scene.instrument);
    Case source = solved.source;
    source.scene.solver.engine = solvers::Engine::native;
    source.scene.mesh = {}; // what was forced on OpenFOAM
    source.scene.solver.accuracy =
        std::max(1e-10, (has_ends ? 0.3 : 0.1) * source.scene.solver.accuracy);
    const std::clock_t begin = std::clock();
    const auto in_time = [begin, seconds](double, std::string_view) {
        if (static_cast<double>(std::clock() - begin) > seconds * CLOCKS_PER_SEC)
            throw solvers::Interrupted();
    };
    const SolvedCase finer = solve_case(plan_case(std::move(source), StageClock()), in_time);
    SceneTruth truth{{}, {}, TruthBasis::finer_run};
    for (const rheometry::TorqueRow& row : finer.solution.history.rows) {
        truth.torque.push_back(row.torque);
        truth.error.push_back(row.torque_error);
    }
    return truth;
}

} // namespace

std::string_view name_of(TruthBasis basis) {
    switch (basis) {
    case TruthBasis::digits:
        return "50 digits";
    case TruthBasis::series:
        return "exact series";
    case TruthBasis::finer_run:
        return "a finer run";
    case TruthBasis::none:
        break;
    }
    return "";
}

SceneTruth truth_of(const SolvedCase& solved, double seconds) {
    const solvers::Scene& scene = solved.source.scene;
    const auto* steps = std::get_if<rheometry::Steps>(&scene.protocol.program);
    const bool is_steady = steps != nullptr && !steps->hold && !steps->hold_strain;
    if (!solved.plan.vortices && !geometry::has_ends(scene.instrument)) {
        if (is_steady)
            return steady_truth(solved);
        SceneTruth series = series_truth(solved);
        if (!series.torque.empty())
            return series;
    }
    return finer_truth(solved, seconds);
}

} // namespace searle::app
