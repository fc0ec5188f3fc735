#pragma once

namespace searle::rheometry {

/// What the shear stress of a suspension is made of at one row, Pa. With walls the five parts are
/// those of the force on the moving wall and sum to the row's stress; without walls they are the
/// bulk's. The bulk parts are means over the box.
struct SuspensionStress {
    double fluid{};
    double hydrodynamic{}; ///< drag, stresslets, lubrication
    double contact{};
    double dlvo{};
    double brownian{};
    /// Of the row's stress, >= 0: one standard error of a long average; of a short one larger, so
    /// that twice it still holds the truth with 95 %.
    double statistical_error{};
    double independent_values{}; ///< how many uncorrelated values would tell as much, >= 0
    double bulk_fluid{};
    double bulk_hydrodynamic{};
    double bulk_contact{};
    double bulk_dlvo{};
    double bulk_brownian{};
    double first_normal_difference{};  ///< sigma_xx - sigma_yy of the particles
    double second_normal_difference{}; ///< sigma_yy - sigma_zz of the particles
    double particle_pressure{};
    double contact_number{}; ///< touching partners of a particle, walls included

    [[nodiscard]] double total() const { return fluid + hydrodynamic + contact + dlvo + brownian; }
    [[nodiscard]] double bulk_total() const {
        return bulk_fluid + bulk_hydrodynamic + bulk_contact + bulk_dlvo + bulk_brownian;
    }
};

} // namespace searle::rheometry
