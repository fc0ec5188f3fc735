#pragma once

#include "geometry/din_bob.hpp"
#include "solvers/meridional/flow_system.hpp"

#include <functional>
#include <memory>

namespace searle::solvers::meridional {

/// How finely a section is divided.
struct FlowResolution {
    int degree{};      ///< of the velocity
    double smallest{}; ///< element next to the rotor, over the width of the gap
    double largest{};  ///< longest side of an element, over the bob's radius
    double beside{};   ///< longest side along the cylinder, over the width of the gap
};

/// A section divided into elements, and a flow on it.
class FlowLevel {
public:
    FlowLevel(const geometry::DinBob& bob, const FlowResolution& resolution);
    /// @param mesh  the section between `lines`
    FlowLevel(axisymmetric::SectionLines lines, axisymmetric::SectionMesh mesh, int degree);
    FlowLevel(const FlowLevel&) = delete;
    FlowLevel& operator=(const FlowLevel&) = delete;

    /// The rotor turns, everything else is at rest.
    void start_from_rest();
    /// The creeping flow, which is swirl alone, starting from the swirl of the present state: the
    /// minimum of a convex energy, found from any start. False where the last digits are missing.
    bool solve_creeping(const axisymmetric::EnergyDensity& law, double tolerance);
    /// Takes the velocity of another level by interpolation; its lines need not be this level's.
    void start_from(const FlowLevel& other);

    /// Newton's method from the present state to the steady flow. False where it does not converge
    /// (the state is then what it was).
    /// @param tolerance  of the velocity over that of the rotor, > 0
    /// @param before_step  called before each factorisation; may throw, the state is then what it
    /// was
    bool solve_steady(const FlowMaterial& material, double tolerance,
                      const std::function<void()>& before_step = {});

    /// Torque by the rotor on the fluid in steady flow, over 2 pi stress scale radius^3.
    [[nodiscard]] double steady_torque(const FlowMaterial& material) const;

    [[nodiscard]] const FlowState& state() const { return state_; }
    void set_state(FlowState state) { state_ = std::move(state); }
    [[nodiscard]] const FlowSpace& space() const { return space_; }
    [[nodiscard]] FlowSystem& system() { return system_; }
    [[nodiscard]] const axisymmetric::SectionLines& lines() const { return lines_; }
    [[nodiscard]] const axisymmetric::SectionMesh& mesh() const { return mesh_; }

private:
    axisymmetric::SectionLines lines_;
    axisymmetric::SectionMesh mesh_;
    FlowSpace space_;
    FlowSystem system_;
    std::unique_ptr<axisymmetric::EnergyMinimiser> minimiser_; ///< made when first asked for
    FlowState state_;
};

/// The lines of a DIN bob's section at a resolution: graded to the rotor's edges, nowhere longer
/// than the largest side.
[[nodiscard]] axisymmetric::SectionLines flow_lines(const geometry::DinBob& bob,
                                                    const FlowResolution& resolution);

} // namespace searle::solvers::meridional
