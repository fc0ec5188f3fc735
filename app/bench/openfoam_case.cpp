#include "app/bench/openfoam_case.hpp"

#include "geometry/mesh_build.hpp"
#include "geometry/mesh_format/write_mesh.hpp"
#include "solvers/openfoam/file_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <variant>

namespace searle::app::bench {
namespace {

namespace fs = std::filesystem;

/// The wedge of peers that are quick and accurate: chords cost 1.3e-5 of the torque.
constexpr double wedge_angle = std::numbers::pi / 180.0;

std::string head(const char* kind, const char* object) {
    return fmt::format("FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n", kind,
                       object);
}

void put(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    if (!stream.flush())
        throw std::runtime_error(file.string() + ": cannot be written");
}

bool is_steady(const FoamCase& foam) { return foam.solver == "simpleFoam" || foam.steady_swirl; }

std::string control(const FoamCase& foam) {
    return head("dictionary", "controlDict") +
           fmt::format(
               "application {0}; startFrom startTime; startTime 0; stopAt endTime;\nendTime {1}; "
               "deltaT {2}; writeControl timeStep; writeInterval 1000000000; writeFormat ascii;\n"
               "writePrecision 12; timePrecision 12; runTimeModifiable false;\nfunctions\n{{\n"
               "torque {{ type forces; libs (forces); patches (\"bob.*\" shaft); rho rhoInf; "
               "rhoInf "
               "{3};\nCofR (0 0 0); log false; writeControl {4}; writeInterval {5}; executeControl "
               "{4}; executeInterval {5}; }}\n}}\n",
               foam.solver, foam.end_time, foam.step, foam.density,
               is_steady(foam) ? "timeStep" : "runTime",
               is_steady(foam) ? 1.0 : foam.torque_interval);
}

std::string schemes(const FoamCase& foam) {
    // Second order throughout; a steady flow is found with a bounded convection.
    return head("dictionary", "fvSchemes") +
           fmt::format("ddtSchemes {{ default {}; }}\ngradSchemes {{ default Gauss linear; }}\n"
                       "divSchemes {{ default none; div(phi,U) {}Gauss linear; "
                       "div((nuEff*dev2(T(grad(U))))) Gauss linear; }}\n"
                       "laplacianSchemes {{ default Gauss linear corrected; }}\n"
                       "interpolationSchemes {{ default linear; }}\nsnGradSchemes {{ default "
                       "corrected; }}\n",
                       is_steady(foam) ? "steadyState" : "backward",
                       is_steady(foam) ? "bounded " : "");
}

std::string solution(const FoamCase& foam) {
    std::string text =
        head("dictionary", "fvSolution") +
        "solvers\n{\np { solver PCG; preconditioner DIC; tolerance 1e-8; relTol " +
        (is_steady(foam) ? "0.05" : "0") +
        "; }\npFinal { $p; relTol 0; }\nU { solver PBiCGStab; preconditioner DILU; tolerance 1e-9; "
        "relTol " +
        (is_steady(foam) ? "0.05" : "0") + "; }\nUFinal { $U; relTol " +
        (is_steady(foam) ? "0.01" : "0") + "; }\n}\n";
    if (foam.solver == "simpleFoam")
        return text +
               fmt::format("SIMPLE {{ consistent yes; nNonOrthogonalCorrectors 0; pRefCell 0; "
                           "pRefValue 0;\nresidualControl {{ p 1e-5; U {}; }} }}\n"
                           "relaxationFactors {{ equations {{ U {}; }} fields {{ p {}; }} }}\n",
                           foam.cautious ? "1e-5" : "1e-6", foam.cautious ? 0.95 : 0.9,
                           foam.cautious ? 0.5 : 1.0);
    const bool swirl_alone = foam.swirl_corrections > 0;
    return text +
           fmt::format("PISO {{ nCorrectors 2; nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue "
                       "0; }}\nPIMPLE {{ nOuterCorrectors {}; nCorrectors {}; "
                       "turbOnFinalIterOnly no; nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue "
                       "0; }}\n",
                       swirl_alone ? foam.swirl_corrections : 2, swirl_alone ? 0 : 2);
}

std::string transport(const FoamCase& foam) {
    const std::string start = head("dictionary", "transportProperties");
    if (const auto* simple = std::get_if<laws::flow::Newtonian>(&foam.law))
        return start + fmt::format("transportModel Newtonian; nu {:.12g};\n",
                                   simple->viscosity / foam.density);
    const auto& law = std::get<laws::flow::HerschelBulkley>(foam.law);
    // The cap on the viscosity that this model needs: that of 1e-2 1/s.
    return start + fmt::format("transportModel HerschelBulkley;\nHerschelBulkleyCoeffs {{ nu0 "
                               "{:.12g}; tau0 {:.12g}; k {:.12g}; n {:.12g}; }}\n",
                               law.yield_stress / foam.density / 1e-2,
                               law.yield_stress / foam.density, law.consistency / foam.density,
                               law.flow_index);
}

std::string rotor_speed(const FoamCase& foam) {
    std::string table;
    for (const auto& [time, speed] : foam.speeds)
        table += fmt::format("({:.12g} {:.12g}) ", time, speed);
    return "{ type rotatingWallVelocity; origin (0 0 0); axis (0 0 1); omega table (" + table +
           "); }";
}

std::string velocity(const FoamCase& foam, std::size_t cells) {
    std::string inside = "uniform (0 0 0)";
    if (foam.disturbance > 0.0) {
        std::mt19937 generator(1);
        std::uniform_real_distribution<double> chance(-foam.disturbance, foam.disturbance);
        inside = fmt::format("nonuniform List<vector> {}\n(\n", cells);
        for (std::size_t k = 0; k < cells; ++k)
            inside += fmt::format("(0 0 {:.6g})\n", chance(generator));
        inside += ")";
    }
    const std::string rotor = rotor_speed(foam);
    return head("volVectorField", "U") + "dimensions [0 1 -1 0 0 0 0]; internalField " + inside +
           ";\nboundaryField\n{\n\"bob.*\" " + rotor + "\nshaft " + rotor +
           "\n\"cup.*|post\" { type noSlip; }\nfree_surface { type slip; }\n\"wedge.*\" { type "
           "wedge; }\n\"slice.*\" { type " +
           (foam.disturbance > 0.0 ? "symmetryPlane" : "empty") + "; }\n}\n";
}

std::string pressure(const FoamCase& foam) {
    // The two gaps of a double gap do not touch: each needs a level of its own for the pressure.
    // In a flow around the axis alone a wall can give it.
    const std::string fixed = std::holds_alternative<geometry::DoubleGap>(foam.instrument)
                                  ? "{ type fixedValue; value uniform 0; }"
                                  : "{ type zeroGradient; }";
    return head("volScalarField", "p") +
           "dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;\nboundaryField\n{\n\"wedge.*\" { "
           "type wedge; }\n\"slice.*\" { type " +
           (foam.disturbance > 0.0 ? "symmetryPlane" : "empty") +
           "; }\n\"bob.*|shaft|cup_floor|free_surface\" { type zeroGradient; }\n\"cup|post\" " +
           fixed + "\n}\n";
}

void make_slices_symmetric(const fs::path& boundary) {
    const std::regex slice(R"((slice_\w+\s*\{\s*type\s+)\w+;(\s*inGroups[^;]*;)?)");
    put(boundary,
        std::regex_replace(solvers::openfoam::text_of(boundary), slice, "$1symmetryPlane;"));
}

} // namespace

std::size_t write_foam_case(const FoamCase& foam, const fs::path& folder) {
    geometry::MeshSettings settings = foam.mesh;
    settings.extent = geometry::MeshExtent::wedge;
    settings.wedge_angle = wedge_angle;
    const geometry::BuiltMesh built =
        geometry::build_mesh(geometry::subject_of(foam.instrument), settings);
    geometry::write_openfoam(built.mesh, folder);
    if (foam.disturbance > 0.0)
        make_slices_symmetric(folder / "constant/polyMesh/boundary");
    const std::size_t cells = built.mesh.cells.size();
    put(folder / "system/controlDict", control(foam));
    put(folder / "system/fvSchemes", schemes(foam));
    put(folder / "system/fvSolution", solution(foam));
    put(folder / "constant/transportProperties", transport(foam));
    put(folder / "constant/turbulenceProperties",
        head("dictionary", "turbulenceProperties") + "simulationType laminar;\n");
    put(folder / "0/U", velocity(foam, cells));
    put(folder / "0/p", pressure(foam));
    return cells;
}

std::vector<std::string> foam_environment() {
    const fs::path place = "/usr/share/openfoam";
    return fs::exists(place / "etc/controlDict")
               ? std::vector<std::string>{"WM_PROJECT_DIR=" + place.string()}
               : std::vector<std::string>{};
}

std::vector<FoamTorque> foam_torques(const fs::path& folder) {
    std::vector<FoamTorque> torques;
    std::istringstream lines(
        solvers::openfoam::text_of(folder / "postProcessing/torque/0/moment.dat"));
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.front() == '#')
            continue;
        for (char& letter : line)
            if (letter == '(' || letter == ')')
                letter = ' ';
        std::istringstream words(line);
        double time = 0.0;
        double x = 0.0;
        double y = 0.0;
        double z = 0.0;
        // Moment of the fluid on the wall of the wedge; the drive's has the other sign.
        if (words >> time >> x >> y >> z)
            torques.push_back({time, -z * 2.0 * std::numbers::pi / wedge_angle});
    }
    return torques;
}

} // namespace searle::app::bench
