#include "app/verify/verify_text.hpp"

#include "app/versions.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace searle::app::verify {
namespace {

std::string order_text(const Found& found) {
    return std::isfinite(found.order) ? fmt::format("{:.1f}", found.order) : "";
}

/// Text for a cell of a Markdown table.
std::string cell(std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
        text.insert(at, 1, '\\');
    return text;
}

std::string link(const std::string& file, const std::string& test) {
    return fmt::format("[{}](../{})", test, file);
}

} // namespace

const std::vector<SuiteOnly>& suite_only() {
    static const std::vector<SuiteOnly> rows{
        {"secondary flow: manufactured flows with every term, three degrees",
         "exact: orders k + 1 (velocity), k (pressure), 2k (torque)",
         "tests/solvers/meridional_manufactured_test.cpp",
         "ManufacturedSecondaryFlow.errors_fall_with_the_orders_of_the_elements_up_to_the_axis"},
        {"creeping swirl: manufactured flows, three degrees", "exact: the degree as order",
         "tests/solvers/axisymmetric_swirl_test.cpp",
         "ManufacturedSwirl.error_falls_with_the_degree_as_order"},
        {"swirl in time around a bob, yield stress included",
         "a slice of the radial solver, modes exact in time, the steady torque",
         "tests/solvers/swirl_history_test.cpp",
         "SwirlHistory.of_a_longer_bob_adds_the_slice_of_the_radial_solver"},
        {"torque of turbulent flow past the onset of Taylor vortices", "Wendt's measurements",
         "tests/solvers/vortex_torque_test.cpp",
         "VortexTorque.is_what_wendt_measured_far_past_the_onset"},
        {"Taylor vortices in time at three radius ratios", "onset of the linear theory",
         "tests/solvers/meridional_vortices_test.cpp",
         "TaylorOnset.time_steps_find_the_onset_of_linear_theory_at_three_radius_ratios"},
        {"growth in time of disturbances of power-law, Carreau and Herschel-Bulkley fluids",
         "onset of the linear theory of their own flow", "tests/solvers/meridional_onset_test.cpp",
         "OnsetOfFluids.time_steps_find_the_onset_of_linear_theory"},
        {"onset of vortices of 300 random fluids and gaps", "the energy method: never below it",
         "tests/solvers/stability_layer_onset_test.cpp",
         "LayerOnset.energy_method_never_excludes_a_linear_onset"},
        {"growth of disturbances by eigenvalues", "growth in time",
         "tests/solvers/meridional_vortices_test.cpp",
         "FlowStability.arnoldi_and_time_steps_give_the_same_growth"},
        {"vortices that grow in time", "the steady vortices",
         "tests/solvers/meridional_vortices_test.cpp", "VortexRun.grows_into_the_steady_vortices"},
        {"time steps: all conditions of order four, and damping", "the conditions",
         "tests/solvers/esdirk_test.cpp",
         "Esdirk.weights_fulfil_all_eight_conditions_of_order_four"},
        {"bounds and errors of the creeping torque", "finer runs, energy bounds",
         "tests/solvers/axisymmetric_swirl_test.cpp",
         "CreepingSwirl.bounds_close_in_on_the_result_and_errors_hold"},
        {"fits: ten certified problems (NIST StRD)", "certified values, eight digits",
         "tests/rheometry/fit_certified_problems_test.cpp",
         "FitCertifiedProblems.values_have_eight_digits"},
        {"fits: intervals", "how often they hold the truth",
         "tests/rheometry/fit_flow_curve_test.cpp",
         "FitFlowCurve.intervals_hold_the_truth_as_often_as_they_say"},
        {"particles: pairs of the neighbour list", "a search over all pairs",
         "tests/suspension/particles_neighbours_test.cpp",
         "NeighbourList.finds_the_pairs_that_a_search_over_all_finds"},
        {"coupling: momentum of particles, fluid and walls", "conserved to rounding",
         "tests/suspension/inertial_motion_test.cpp",
         "InertialMotion.conserves_momentum_of_particles_fluid_and_walls_to_round_off"},
        {"thermal motion", "Einstein's diffusion coefficient",
         "tests/suspension/inertial_motion_test.cpp",
         "InertialMotion.diffuses_with_einsteins_coefficient"},
        {"dense suspensions", "LF_DEM's viscosities, within their spread",
         "tests/suspension/overdamped_motion_test.cpp",
         "OverdampedMotion.dense_spheres_have_lf_dems_viscosity"},
        {"films between particles and walls: force on the wall", "mean stress of the box",
         "tests/suspension/films_at_walls_test.cpp",
         "FilmsAtWalls.the_wall_feels_the_mean_stress_of_the_box"},
        {"films between particles and walls: inertia of a ramp",
         "series; second order in cells, first in steps",
         "tests/suspension/films_at_walls_test.cpp",
         "FilmsAtWalls.the_fluid_between_walls_has_the_inertia_of_a_ramp"},
        {"local volumes of particles, sheared and between walls",
         "points counted to the nearest; lattices exact; their sum the box",
         "tests/suspension/local_volumes_test.cpp",
         "LocalVolumes.are_those_of_the_points_that_are_nearest"},
        {"statistical errors", "scatter of correlated means",
         "tests/suspension/correlated_series_test.cpp",
         "CorrelatedSeries.errors_hold_the_truth_down_to_four_correlation_times"}};
    return rows;
}

std::string check_line(const CheckResult& result) {
    const Check& check = *result.check;
    std::string line = fmt::format(
        "{} {:<34} error {:>8.1e}  allowed {:>7.1e}{}", result.passed ? "pass" : "FAIL", check.name,
        result.found.error, check.tolerance,
        check.least_order > 0.0
            ? fmt::format("  order {} (at least {})", order_text(result.found), check.least_order)
            : "");
    if (!result.fault.empty())
        line += "  " + result.fault;
    if (!result.passed)
        line += fmt::format("\n     {}; against {}\n     the test: {} in {}", check.subject,
                            check.against, check.test, check.file);
    return line + "\n";
}

std::string verification_page(const std::vector<CheckResult>& results) {
    std::string text = fmt::format(
        "# Verification\n\nMade by `searle verify --markdown`; a test compares its rows with the "
        "program's. `searle verify` does these checks\non your machine in seconds, and exits with "
        "1 when one fails. Errors are relative where no unit is said.\n\nSearle {}: {} of {} "
        "passed.\n\n| check | what | against | error | allowed | because of | order | test |\n"
        "|---|---|---|---|---|---|---|---|\n",
        program_version(), std::ranges::count(results, true, &CheckResult::passed), results.size());
    for (const CheckResult& result : results) {
        const Check& check = *result.check;
        const std::string order =
            check.least_order > 0.0
                ? fmt::format("{} (≥ {})", order_text(result.found), check.least_order)
                : "";
        text += fmt::format("| {} | {} | {} | {:.1e}{} | {:.1e} | {} | {} | {} |\n", check.name,
                            cell(check.subject), cell(check.against), result.found.error,
                            result.passed ? "" : " **failed**", check.tolerance, cell(check.origin),
                            order, link(check.file, check.test));
    }
    text += "\n## In the test suite alone\n\nThese need more resolutions, or statistics, and take "
            "longer; `searle test` makes them.\n\n| what | against | test |\n|---|---|---|\n";
    for (const SuiteOnly& row : suite_only())
        text += fmt::format("| {} | {} | {} |\n", cell(row.subject), cell(row.against),
                            link(row.file, row.test));
    return text;
}

} // namespace searle::app::verify
