#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace searle::solvers::suspension {

/// One size of a mixture of spheres.
struct SizeClass {
    double diameter{}; ///< m, > 0
    double share{};    ///< by volume of all particles, 0 < share <= 1
};

enum class ContactModel {
    hooke, ///< linear springs
    hertz  ///< elastic spheres of the particles' shear modulus and Poisson's ratio
};

/// Soft-sphere contact between particles, and of a particle with a wall of its material.
struct ContactSettings {
    ContactModel model = ContactModel::hooke;
    std::optional<double> stiffness;            ///< normal spring of Hooke, N/m, > 0
    double restitution = 0.9;                   ///< of a head-on pair, 0 < e <= 1
    double friction = 0.3;                      ///< Coulomb coefficient, >= 0
    std::optional<double> tangential_stiffness; ///< N/m; absent: follows from `stiffness`
    std::optional<double> damping; ///< normal dashpot, kg/s; absent: from `restitution`
    double rolling_friction = 0.0; ///< coefficient, >= 0
};

enum class DoubleLayer { weak_overlap, constant_potential };

/// Attraction after Hamaker and repulsion of the electric double layers.
struct ColloidSettings {
    DoubleLayer double_layer = DoubleLayer::weak_overlap;
    double hamaker{};                     ///< Hamaker constant, J, >= 0
    double zeta_potential{};              ///< V
    std::optional<double> debye_length;   ///< m, > 0; this or `ionic_strength`
    std::optional<double> ionic_strength; ///< mol/m^3, > 0
    double relative_permittivity = 80.1;  ///< of the fluid, >= 1
    double minimum_separation = 0.3e-9;   ///< surface distance below which both terms stay, m, > 0
    double cutoff = 100e-9;               ///< surface distance beyond which both are 0, m
};

enum class ParticleBoundary { walls, lees_edwards };
enum class Drag { stokes, di_felice, ergun_wen_yu };
enum class Hydrodynamics { automatic, drag, stresslet, lubrication };
enum class Integrator { automatic, explicit_steps, implicit_drag, overdamped };

/// The section [particles].
struct ParticleSettings {
    std::optional<double> diameter;   ///< m, > 0; this or `diameters`
    std::vector<SizeClass> diameters; ///< shares sum to 1
    /// Standard deviation of ln(diameter) by number about each size as median; 0: none.
    double spread = 0.0;
    double density{};         ///< kg/m^3, > 0
    double volume_fraction{}; ///< 0 < phi < 0.74
    ParticleBoundary boundary = ParticleBoundary::walls;
    std::optional<ContactSettings> contact; ///< absent: not computed
    std::optional<ColloidSettings> dlvo;    ///< absent: not computed
    Drag drag = Drag::di_felice;
    Hydrodynamics hydrodynamics = Hydrodynamics::automatic;
    bool brownian = false;
    double temperature = 293.15; ///< K, > 0
    Integrator integrator = Integrator::automatic;
    std::int64_t seed = 1;               ///< of all random numbers, >= 0
    std::optional<double> gravity;       ///< m/s^2; absent: off
    std::optional<double> shear_modulus; ///< Pa; for Hertz and the Rayleigh time
    std::optional<double> poisson_ratio; ///< for Hertz and the Rayleigh time
    std::optional<double> time_step;     ///< s; absent: the program chooses
};

enum class CouplingModel { a, b };

/// The section [coupling].
struct CouplingSettings {
    std::array<int, 3> cells{8, 8, 8}; ///< along flow, gap and vorticity
    CouplingModel model = CouplingModel::a;
    std::optional<int> interval; ///< particle steps per fluid step; absent: the program chooses
};

} // namespace searle::solvers::suspension
