#pragma once

#include "geometry/instrument.hpp"
#include "rheometry/conversion/conversion.hpp"
#include "rheometry/end_effect.hpp"
#include "rheometry/fields/section_fields.hpp"
#include "rheometry/rheogram.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace searle::rheometry::report {

/// Shear stress in Pa at a shear rate >= 0 in 1/s.
using StressOfRate = std::function<double(double)>;

/// One number of a table: a flow law's parameter, for instance.
struct Parameter {
    std::string key;  ///< as in case files: "yield_stress"
    double value{};   ///< SI
    std::string unit; ///< as in case files: "Pa", "Pa.s^n", "1"
};

/// A fluid in simple shear; describe_fluid() makes it from a flow law.
struct FluidDescription {
    std::string model; ///< "herschel-bulkley", ...
    std::vector<Parameter> parameters;
    /// The law itself, drawn as a line; empty: none is drawn (measured data).
    StressOfRate true_stress;
    std::optional<double> density; ///< kg/m^3
};

/// A thing that was solved or left out, with the number that decided.
struct ValidityNote {
    std::string what; ///< "inertia", "ends", "Taylor vortices", ...
    bool solved{};
    std::string reason; ///< a full sentence
};

/// Onset of Taylor vortices for a cup at rest, Re = R_bob omega d / nu.
struct VortexOnset {
    double critical_reynolds{};
    double reynolds{};            ///< largest of the protocol
    double wave_number{};         ///< axial wave number times gap; 0: not known
    double critical_shear_rate{}; ///< 1/s at the conversion's definition; 0: not known
    std::string basis;            ///< what the viscosity in Re is, and how far the estimate reaches
};

struct StageTime {
    std::string stage;
    double wall_seconds{};
    double cpu_seconds{}; ///< negative: not measured
};

/// A row of words: "time steps" - "1 024".
struct Fact {
    std::string name;
    std::string value;
};

/// The mesh that a solution was found on.
struct MeshDescription {
    std::string picture; ///< one SVG element: the section, patches in colour
    std::string caption; ///< a sentence
    std::vector<Fact> facts;
};

/// Particles in the fluid.
struct ParticlesNote {
    double volume_fraction{};
    bool walls = true;          ///< false: bulk, between images that move (Lees & Edwards)
    bool carries_stress = true; ///< false: drag alone, without the stress of rigid spheres
};

/// Measured points beside the computed ones.
struct MeasuredSeries {
    std::string name;
    std::vector<double> shear_rate;   ///< 1/s
    std::vector<double> shear_stress; ///< Pa, as many as rates
    std::vector<double> stress_error; ///< Pa, as many or none
};

/// A further rheogram in the figures (another model, ramp or instrument).
struct NamedRheogram {
    std::string name;
    Rheogram rheogram;
};

/// Who made the result, and from what. An empty text is left out of the page.
struct Provenance {
    std::string case_file; ///< name only, no path
    std::string case_hash;
    std::string program_version;
    std::string created;      ///< date and time, any format
    std::string engine;       ///< "native"
    std::string model;        ///< "radial transient"
    std::string model_reason; ///< a sentence
};

/// All that report.html shows. All numbers are SI; every text is plain (escaped by the report).
struct ReportInput {
    std::string title;
    Provenance provenance;

    geometry::Instrument instrument;
    FluidDescription fluid;
    Conversion conversion;
    /// A phrase on the protocol: "ramp from 0 to 100 1/s in 35 s".
    std::string protocol;
    /// Line of the case file that each dotted key stands on: {"geometry.bob_radius", 7}.
    std::map<std::string, int, std::less<>> source_lines;

    Rheogram rheogram; ///< in order of time
    /// True when the rows have times (ramps, segments, timed steps).
    bool transient{};
    /// Asked-for relative error of every shear stress; not positive: unknown.
    double accuracy{};

    std::vector<ValidityNote> validity;
    std::optional<VortexOnset> vortex_onset;
    std::vector<std::string> warnings;
    /// Further notes, a paragraph each (what to expect, sources of parameters).
    std::vector<std::string> remarks;
    std::vector<StageTime> timings;
    /// Further rows of the table on the solution: steps, unknowns, torque balance.
    std::vector<Fact> solver_facts;
    /// Absent where the model needs no mesh.
    std::optional<MeshDescription> mesh;

    std::vector<MeasuredSeries> measured;
    std::vector<NamedRheogram> compared_with;

    /// The bytes of rheogram.csv for the download link; empty or too long: the page names the file.
    std::string csv{};
    std::string csv_file_name = "rheogram.csv";

    /// Absent for a fluid without particles.
    std::optional<ParticlesNote> particles{};

    /// End factors of the creeping flow at the rows; empty: they were not solved for.
    std::vector<EndEffect> ends{};
    /// The flow in the section at some rows, in order; empty: none was asked for.
    std::vector<fields::SectionFields> fields{};
};

/// A box without walls, which stands for the bulk of a suspension.
[[nodiscard]] inline bool is_periodic(const ReportInput& input) {
    return input.particles && !input.particles->walls;
}

/// One run of a sweep.
struct OverlayRun {
    std::string name;
    std::string link; ///< relative address of its own report; empty: none
    /// Values of the swept keys, as many as OverlayInput::swept_keys.
    std::vector<std::string> swept_values;
    FluidDescription fluid;
    Conversion conversion;
    Rheogram rheogram;
    bool transient{};
    double accuracy{};
    double wall_seconds{};
    std::vector<std::string> warnings;
    std::optional<ParticlesNote> particles{}; ///< absent for a fluid without particles
};

/// All that the page over a sweep shows.
struct OverlayInput {
    std::string title;
    Provenance provenance;
    std::vector<std::string> swept_keys;
    std::vector<OverlayRun> runs;
    std::vector<MeasuredSeries> measured;
    std::vector<std::string> warnings;
    std::vector<std::string> remarks;
};

} // namespace searle::rheometry::report
