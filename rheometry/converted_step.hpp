#pragma once

#include "rheometry/correction/rotor_rate.hpp"
#include "rheometry/rheogram.hpp"
#include "rheometry/tables/measured_data.hpp"

#include <span>
#include <string>
#include <vector>

namespace searle::rheometry {

/// A measured series, converted.
struct ConvertedStep {
    std::string name;
    Rheogram rheogram;   ///< times are NaN where the data have none
    RotorRates at_rotor; ///< row by row as the rheogram
    bool has_time{};
    /// Largest relative difference from the stresses and rates that the export itself holds; NaN
    /// where it holds none.
    double stress_difference{};
    double rate_difference{};
    /// Rows whose regime says that lag, vortices or end flow is in the torque: they have no rate at
    /// the rotor, and do not count for the others'.
    std::size_t disturbed_rows{};
};

/// Lifts a measured series to stresses and rates by the very functions that do it for computed
/// torques, and corrects the rate at the rotor's wall from the whole series if that is a flow
/// curve. Throws std::overflow_error for a row whose stress, rate or viscosity is beyond the range
/// of double precision; its text names the row's line.
[[nodiscard]] ConvertedStep convert_step(const MeasuredStep& step,
                                         const geometry::Instrument& instrument,
                                         const Conversion& conversion);

/// The table that `searle convert` writes: [time_s,] speed, torque, shear rate, shear stress and
/// viscosity as in rheogram.csv, then bob_stress_Pa, bob_rate_true_1_s,
/// bob_rate_standard_error_1_s, branch, [step,] definition, end_factor. 17 significant digits,
/// `nan` where there is no value. Time and step stand there when any of the steps has them.
[[nodiscard]] std::string converted_csv(std::span<const ConvertedStep> steps,
                                        const geometry::Instrument& instrument,
                                        const Conversion& conversion);

} // namespace searle::rheometry
