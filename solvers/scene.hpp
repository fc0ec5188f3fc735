#pragma once

#include "geometry/instrument.hpp"
#include "geometry/mesh_settings.hpp"
#include "geometry/profile.hpp"
#include "laws/flow/flow_law.hpp"
#include "rheometry/conversion/conversion.hpp"
#include "rheometry/protocol.hpp"
#include "solvers/suspension/suspension_settings.hpp"

#include <optional>
#include <string>

namespace searle::solvers {

struct Fluid {
    laws::flow::AnyFlowLaw law;
    double density{}; ///< kg/m^3, > 0
};

enum class Engine { native, openfoam };
enum class Model { automatic, radial, axisymmetric, three_dimensional };
enum class Switch { automatic, on, off };

/// The OpenFOAM program that solves, for engine = openfoam.
enum class FoamApplication {
    ico_foam,               ///< PISO in time, Newtonian
    non_newtonian_ico_foam, ///< PISO in time
    piso_foam,              ///< PISO in time
    pimple_foam,            ///< PISO in time with outer corrections
    simple_foam             ///< steady
};

struct SolverSettings {
    Engine engine = Engine::native;
    Model model = Model::automatic;
    /// Asked-for relative error of every shear stress, 1e-10 <= accuracy < 1.
    double accuracy = 1e-3;
    Switch secondary_flow = Switch::automatic;
    /// Axial period of Taylor vortices, m; without a value the most unstable one.
    std::optional<double> vortex_wavelength;
    /// What vortices grow from in time: unevenness of the rotor's speed along the axis.
    double disturbance = 1e-3;
    /// OpenFOAM alone: the program; without a value the plan's.
    std::optional<FoamApplication> application;
    /// OpenFOAM alone: processes, >= 1.
    int processors = 1;
    /// OpenFOAM alone: time step of the finest level, s; without a value the plan's.
    std::optional<double> time_step;
    /// OpenFOAM alone: viscosity at which a fluid that does not flow is let flow, Pa s; without a
    /// value the plan's.
    std::optional<double> viscosity_cap;
};

struct OutputSettings {
    bool fields = false;
    /// Rows whose fields are written, evenly spread, >= 1.
    int field_rows = 5;
    /// Of a suspension: strain from frame to frame of its trajectory, > 0; without a value none.
    std::optional<double> trajectory_strain;
};

/// Everything that a case file says, in SI units, valid as checked by the case reader.
struct Scene {
    std::string title;
    geometry::Instrument instrument;
    /// A rotor and cup of any shape, which can be meshed, not solved; the instrument then holds the
    /// cylinders that stress and rate refer to.
    std::optional<geometry::Profile> profile;
    Fluid fluid;
    rheometry::Protocol protocol;
    rheometry::ConversionSettings conversion;
    SolverSettings solver;
    OutputSettings output;
    geometry::MeshSettings mesh;
    /// Particles in the fluid, and how they are coupled with it; none: a fluid alone.
    std::optional<suspension::ParticleSettings> particles;
    suspension::CouplingSettings coupling;
};

} // namespace searle::solvers
