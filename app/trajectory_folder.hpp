#pragma once

#include "solvers/suspension/run_recorder.hpp"

#include <filesystem>
#include <string>

namespace searle::app {

/// The trajectory of a suspension's run: a folder with a file a frame, frame-000000.vtp and so on
/// (VTK's XML for points, which ParaView and OVITO read), and trajectory.pvd, which lists them by
/// time. Each file appears as a whole, so that an interrupted run leaves whole frames; a run that
/// goes on writes the frames after its checkpoint again, which are the same.
class TrajectoryFolder {
public:
    /// Throws OutputPlaceError where the folder holds something else, or, unless a run goes on or
    /// replaces it, an earlier trajectory.
    TrajectoryFolder(std::filesystem::path folder, bool goes_on, bool replace);

    /// A frame that cannot be written (a full disk) is left out; `trouble` then says why.
    void write(const solvers::suspension::Frame& frame);

    [[nodiscard]] const std::string& trouble() const { return trouble_; }

private:
    std::filesystem::path folder_;
    std::string trouble_;
};

/// A frame as VTK's XML for points: positions, radius, local volume (local_volumes.hpp), velocity
/// v, angular velocity omega, id, in SI units and in the order of the ids.
[[nodiscard]] std::string frame_text(const solvers::particles::ParticleStore& particles,
                                     const solvers::particles::ShearBox& box);

} // namespace searle::app
