#include "solvers/openfoam/dictionaries.hpp"

#include "solvers/openfoam/transport.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace searle::solvers::openfoam {
namespace {

std::string header(std::string_view kind, std::string_view place, std::string_view object) {
    return fmt::format("FoamFile\n{{\n    version     2.0;\n    format      ascii;\n"
                       "    class       {};\n    location    \"{}\";\n    object      {};\n}}\n\n",
                       kind, place, object);
}

bool is_box(const CaseFacts& facts) {
    return std::holds_alternative<geometry::Box>(facts.scene.instrument);
}

bool turns(const geometry::Patch& patch) {
    return patch.kind == geometry::PatchKind::wall &&
           (patch.name.starts_with("bob") || patch.name == "shaft");
}

/// The drive's speed over OpenFOAM's time: pairs, with two of almost the same time at a jump.
std::vector<std::pair<double, double>> speed_table(const CaseFacts& facts) {
    std::vector<std::pair<double, double>> table;
    if (facts.plan.steady) {
        for (std::size_t row = 0; row < facts.plan.speeds.speeds.size(); ++row) {
            const double speed = facts.plan.speeds.speeds[row];
            table.emplace_back(start_of_row(facts.plan, row) + (row > 0 ? 0.5 : 0.0), speed);
            table.emplace_back(end_of_row(facts.plan, row), speed);
        }
        return table;
    }
    const rheometry::SpeedHistory& history = facts.plan.history;
    const double hold = facts.plan.hold;
    if (hold > 0.0)
        table.emplace_back(0.0, history.initial_speed);
    for (const rheometry::SpeedHistory::Piece& piece : history.pieces) {
        const double start = hold + piece.start_time;
        const bool jumps = !table.empty() && table.back().second != piece.start_speed;
        if (table.empty() || jumps)
            table.emplace_back(jumps ? start + 1e-3 * facts.time_step : start, piece.start_speed);
        else if (table.back().first < start)
            table.emplace_back(start, piece.start_speed);
        table.emplace_back(hold + piece.end_time, piece.end_speed);
    }
    if (const double end = end_time(facts); end > table.back().first)
        table.emplace_back(end, table.back().second);
    return table;
}

std::string rotor_condition(const CaseFacts& facts) {
    const std::string margin = "        ";
    std::string rows;
    for (const auto& [time, speed] : speed_table(facts))
        rows += is_box(facts) ? fmt::format("{}    ({:.17g} ({:.17g} 0 0))\n", margin, time, speed)
                              : fmt::format("{}    ({:.17g} {:.17g})\n", margin, time, speed);
    if (is_box(facts))
        return fmt::format("type            uniformFixedValue;\n{0}uniformValue    table\n{0}(\n"
                           "{1}{0});\n",
                           margin, rows);
    return fmt::format("type            rotatingWallVelocity;\n{0}origin          (0 0 0);\n"
                       "{0}axis            (0 0 1);\n{0}omega           table\n{0}(\n{1}{0});\n",
                       margin, rows);
}

/// The condition of a patch that is neither wall nor open, for every field.
std::string_view geometric_condition(geometry::PatchKind kind) {
    switch (kind) {
    case geometry::PatchKind::wedge:
        return "wedge";
    case geometry::PatchKind::periodic:
        return "cyclic";
    case geometry::PatchKind::flat:
        return "empty";
    case geometry::PatchKind::wall:
    case geometry::PatchKind::free_surface:
    case geometry::PatchKind::axis:
    case geometry::PatchKind::end_face:
        break;
    }
    return "";
}

template <class Condition>
std::string boundary_text(const geometry::Mesh& mesh, const Condition& condition_of) {
    std::string text = "boundaryField\n{\n";
    for (const geometry::Patch& patch : mesh.patches) {
        const std::string_view geometric = geometric_condition(patch.kind);
        text += fmt::format("    {}\n    {{\n        ", patch.name);
        text += geometric.empty() ? condition_of(patch)
                                  : fmt::format("type            {};\n", geometric);
        text += "    }\n";
    }
    return text + "}\n";
}

/// At rest but for a part in 1e9 of the rotor's speed: OpenFOAM compares the flux through the
/// boundary, which is round-off, with the flux inside, and stops where that is exactly zero.
std::string fluid_at_rest(const CaseFacts& facts) {
    const double fastest = facts.plan.steady ? std::abs(facts.plan.speeds.speeds.front())
                                             : facts.plan.history.fastest_speed();
    const double lever = is_box(facts) ? 1.0 : 1e-2;
    const double speed = 1e-9 * lever * std::max(fastest, 1e-30);
    return is_box(facts) ? fmt::format("internalField   uniform ({:.3g} 0 0);\n\n", speed)
                         : fmt::format("internalField   uniform (0 {:.3g} 0);\n\n", speed);
}

/// What Taylor vortices grow from: one vortex between the ends of the slice, weak against the
/// rotor.
std::string disturbance_field(const CaseFacts& facts);

std::string function_object(const CaseFacts& facts, std::string_view name,
                            const std::vector<std::string>& patches) {
    return fmt::format(
        "    {}\n    {{\n        type            forces;\n        libs            (forces);\n"
        "        patches         ({});\n        rho             rhoInf;\n"
        "        rhoInf          {:.17g};\n        CofR            (0 0 0);\n"
        "        executeInterval 1;\n        writeControl    timeStep;\n"
        "        writeInterval   1;\n        log             no;\n    }}\n",
        name, fmt::join(patches, " "), facts.scene.fluid.density);
}

} // namespace

std::vector<std::string> rotor_patches(const geometry::Mesh& mesh) {
    std::vector<std::string> names;
    for (const geometry::Patch& patch : mesh.patches)
        if (turns(patch))
            names.push_back(patch.name);
    return names;
}

std::vector<std::string> cup_patches(const geometry::Mesh& mesh) {
    std::vector<std::string> names;
    for (const geometry::Patch& patch : mesh.patches)
        if (patch.kind == geometry::PatchKind::wall && !turns(patch))
            names.push_back(patch.name);
    return names;
}

double end_time(const CaseFacts& facts) {
    if (facts.plan.steady)
        return end_of_row(facts.plan, facts.plan.speeds.speeds.size() - 1);
    // OpenFOAM ends up to half a step early: whole steps reach over the last row.
    const double duration = facts.plan.hold + facts.plan.history.duration();
    return std::ceil(duration / facts.time_step * (1 - 1e-9)) * facts.time_step;
}

std::string velocity_text(const CaseFacts& facts) {
    const std::string inside =
        facts.plan.vortices ? disturbance_field(facts) : fluid_at_rest(facts);
    return header("volVectorField", "0", "U") + "dimensions      [0 1 -1 0 0 0 0];\n\n" + inside +
           boundary_text(facts.mesh, [&facts](const geometry::Patch& patch) -> std::string {
               if (turns(patch))
                   return rotor_condition(facts);
               return patch.kind == geometry::PatchKind::wall ? "type            noSlip;\n"
                                                              : "type            slip;\n";
           });
}

std::string pressure_text(const CaseFacts& facts) {
    return header("volScalarField", "0", "p") +
           "dimensions      [0 2 -2 0 0 0 0];\n\ninternalField   uniform 0;\n\n" +
           boundary_text(facts.mesh, [](const geometry::Patch&) -> std::string {
               return "type            zeroGradient;\n";
           });
}

std::string transport_properties(const CaseFacts& facts) {
    return header("dictionary", "constant", "transportProperties") +
           transport_text(facts.scene.fluid.law, facts.scene.fluid.density,
                          facts.plan.viscosity_cap);
}

std::string turbulence_properties() {
    return header("dictionary", "constant", "turbulenceProperties") + "simulationType  laminar;\n";
}

std::string control_text(const CaseFacts& facts) {
    const double end = end_time(facts);
    // Fields are for a restart, and for a look at the end; the torque is written in each step. Of
    // rows that are runs of their own the interval is set before each.
    const bool row_by_row = runs_row_by_row(facts.plan);
    const double interval = row_by_row ? facts.plan.iterations : end / writes_in_a_run;
    return header("dictionary", "system", "controlDict") +
           fmt::format(
               "application     {};\nstartFrom       latestTime;\nstartTime       0;\n"
               "stopAt          endTime;\nendTime         {:.17g};\n"
               "deltaT          {:.17g};\nwriteControl    runTime;\nwriteInterval   {:.17g};\n"
               "purgeWrite      {};\nwriteFormat     ascii;\nwritePrecision  15;\n"
               "writeCompression off;\ntimeFormat      general;\ntimePrecision   12;\n"
               "runTimeModifiable true;\n\n"
               "OptimisationSwitches\n{{\n    fileModificationSkew 0;\n}}\n\n",
               name_of(facts.plan.application), end, facts.time_step, interval,
               row_by_row ? 0 : 2) +
           "functions\n{\n" + function_object(facts, "torque_bob", rotor_patches(facts.mesh)) +
           function_object(facts, "torque_cup", cup_patches(facts.mesh)) + "}\n";
}

std::string schemes_text(const CaseFacts& facts) {
    return header("dictionary", "system", "fvSchemes") +
           fmt::format("ddtSchemes\n{{\n    default         {};\n}}\n\n"
                       "gradSchemes\n{{\n    default         Gauss linear;\n}}\n\n"
                       "divSchemes\n{{\n    default         none;\n"
                       "    div(phi,U)      {}Gauss linear;\n"
                       "    div((nuEff*dev2(T(grad(U))))) Gauss linear;\n}}\n\n"
                       "laplacianSchemes\n{{\n    default         Gauss linear corrected;\n}}\n\n"
                       "interpolationSchemes\n{{\n    default         linear;\n}}\n\n"
                       "snGradSchemes\n{{\n    default         corrected;\n}}\n",
                       facts.plan.steady ? "steadyState" : "backward",
                       facts.plan.steady ? "bounded " : "");
}

namespace {

/// The sections PISO, PIMPLE, SIMPLE and relaxationFactors.
/// @param common  entries that all three have
std::string algorithms_text(const CaseFacts& facts, const std::string& common) {
    const bool has_section = !facts.plan.swirl_alone;
    // A time step is far beyond the cells' diffusion times, where PISO's splitting of pressure and
    // velocity does not hold and SIMPLEC's does. Where the swirl alone is to be found, no pressure
    // acts on it: none is corrected, the flux stays that of the start, next to nothing, and what is
    // left of the momentum equation is exact.
    const int corrections = has_section ? facts.plan.pressure_corrections : 0;
    // In time even a factor of 1 makes OpenFOAM add to the diagonal what keeps it dominant, which
    // in a step's last correction is an error (9 % of the torque of a water ramp): none for UFinal,
    // and none at all for the programs without outer corrections.
    const bool relaxes = facts.plan.application == FoamApplication::simple_foam ||
                         facts.plan.application == FoamApplication::pimple_foam;
    const double factor = relaxes ? facts.plan.relaxation : 0.0;
    const std::string of_pressure =
        facts.plan.pressure_relaxation < 1.0
            ? fmt::format("    fields\n    {{\n        p               {};\n    }}\n",
                          facts.plan.pressure_relaxation)
            : "";
    const std::string relaxation =
        factor > 0.0 ? fmt::format("relaxationFactors\n{{\n{}    equations\n    {{\n"
                                   "        U               {};\n    }}\n}}\n",
                                   of_pressure, factor)
                     : "";
    return fmt::format(
        "PISO\n{{\n    nCorrectors     3;\n{0}}}\n\n"
        "PIMPLE\n{{\n    consistent      {1};\n    nOuterCorrectors {2};\n"
        "    nCorrectors     {3};\n    turbOnFinalIterOnly no;\n{0}}}\n\n"
        "SIMPLE\n{{\n    consistent      yes;\n{0}"
        "    residualControl\n    {{\n        U               {5:.3g};\n    }}\n}}\n\n{4}",
        common, has_section ? "yes" : "no", facts.plan.outer_corrections, corrections, relaxation,
        facts.plan.residual);
}

} // namespace

std::string solution_text(const CaseFacts& facts) {
    const bool has_section = !facts.plan.swirl_alone;
    const bool steady = facts.plan.steady;
    // Conjugate gradients are quicker than several grids up to about this many cells, where the
    // pressure is only to be brought a part of the way.
    constexpr std::size_t many_cells = 20'000;
    // The two gaps of a double gap are two systems, of which one has no reference pressure:
    // singular yet consistent, which conjugate gradients can take and an incomplete factorisation
    // cannot.
    const bool is_double_gap =
        std::holds_alternative<geometry::DoubleGap>(facts.scene.instrument) && !has_section;
    const bool has_many = has_section && (!steady || facts.mesh.cells.size() > many_cells);
    // Steady rows of a section end after as many iterations on any number of processes, if nothing
    // in them depends on the partition: an incomplete factorisation does.
    const bool is_any_partition = steady && has_section;
    const std::string_view pressure =
        has_many ? "solver          GAMG;\n        smoother        DIC;"
        : is_double_gap || is_any_partition
            ? "solver          PCG;\n        preconditioner  diagonal;"
            : "solver          PCG;\n        preconditioner  DIC;";
    // A steady row takes the rest of each system, and what cells that are not orthogonal add, in
    // its next iteration.
    const std::string algorithm = fmt::format("    nNonOrthogonalCorrectors {};\n"
                                              "    pRefCell        0;\n    pRefValue       0;\n",
                                              has_section && !steady ? 1 : 0);
    return header("dictionary", "system", "fvSolution") +
           fmt::format("solvers\n{{\n    p\n    {{\n        {0}\n"
                       "        tolerance       1e-10;\n        relTol          {1};\n    }}\n"
                       "    pFinal\n    {{\n        $p;\n        relTol          0;\n    }}\n"
                       "    U\n    {{\n        solver          PBiCGStab;\n"
                       "        preconditioner  {3};\n        tolerance       1e-11;\n"
                       "        relTol          {2};\n    }}\n"
                       "    UFinal\n    {{\n        $U;\n    }}\n}}\n\n",
                       pressure, steady ? "0.1" : "0", steady ? "0.01" : "0",
                       is_any_partition ? "diagonal" : "DILU") +
           algorithms_text(facts, algorithm);
}

std::string decomposition_text(const CaseFacts& facts) {
    const int count = facts.scene.solver.processors;
    const bool has_section = geometry::has_ends(facts.scene.instrument) || facts.plan.vortices;
    // Across the axis where the section has an extent there, else across the gap.
    const std::string divisions = has_section     ? fmt::format("1 1 {}", count)
                                  : is_box(facts) ? fmt::format("1 {} 1", count)
                                                  : fmt::format("{} 1 1", count);
    return header("dictionary", "system", "decomposeParDict") +
           fmt::format("numberOfSubdomains {};\n\nmethod          simple;\n\n"
                       "simpleCoeffs\n{{\n    n               ({});\n    delta           0.001;\n"
                       "}}\n",
                       count, divisions);
}

namespace {

std::string disturbance_field(const CaseFacts& facts) {
    // Of the stream function r psi = sin(k z) f(r): closed cells, free of divergence up to the
    // grid's error, which the first pressure correction removes.
    const auto& gap = std::get<geometry::ConcentricCylinders>(facts.scene.instrument);
    const double height = facts.plan.vortex_height;
    const double speed =
        facts.scene.solver.disturbance * facts.plan.history.fastest_speed() * gap.bob_radius;
    std::string text =
        fmt::format("internalField   nonuniform List<vector>\n{}\n(\n", facts.mesh.cells.size());
    for (std::size_t cell = 0; cell < facts.mesh.cells.size(); ++cell) {
        double x = 0.0;
        double y = 0.0;
        double z = 0.0;
        const auto corners = facts.mesh.cells.corners(cell);
        for (const std::uint32_t node : corners) {
            x += facts.mesh.points[node].x / static_cast<double>(corners.size());
            y += facts.mesh.points[node].y / static_cast<double>(corners.size());
            z += facts.mesh.points[node].z / static_cast<double>(corners.size());
        }
        const double r = std::hypot(x, y);
        const double s = std::clamp((r - gap.bob_radius) / gap.gap(), 0.0, 1.0);
        constexpr double pi = 3.14159265358979324;
        const double f = std::pow(s * (1.0 - s), 2) * 16.0;
        const double slope = 32.0 * s * (1.0 - s) * (1.0 - 2.0 * s);
        const double u = -speed * f * std::cos(pi * z / height) * gap.gap() / height * pi;
        const double w = speed * slope * std::sin(pi * z / height);
        text += fmt::format("({:.9g} {:.9g} {:.9g})\n", u * x / r, u * y / r, w);
    }
    return text + ")\n;\n\n";
}

} // namespace

} // namespace searle::solvers::openfoam
