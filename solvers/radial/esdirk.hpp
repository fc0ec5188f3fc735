#pragma once

#include <array>

namespace searle::solvers::radial {

/// ESDIRK4(3)6L[2]SA of Kennedy & Carpenter 2003, Appl. Numer. Math. 44, 139 (implicit half of
/// ARK4(3)6L[2]SA): order 4 with an embedded order 3, stage order 2, L-stable, stiffly accurate, so
/// that the stress at a step's end satisfies the flow law exactly. The first stage is explicit.
/// Order conditions: tests/solvers/esdirk_test.cpp.
struct Esdirk {
    static constexpr int stages = 6;
    static constexpr double diagonal = 0.25;
    static constexpr std::array<double, 6> time{0.0,         0.5,         83.0 / 250.0,
                                                31.0 / 50.0, 17.0 / 20.0, 1.0};
    static constexpr std::array<std::array<double, 6>, 6> weight{{
        {0, 0, 0, 0, 0, 0},
        {0.25, 0.25, 0, 0, 0, 0},
        {8611.0 / 62500.0, -1743.0 / 31250.0, 0.25, 0, 0, 0},
        {5012029.0 / 34652500.0, -654441.0 / 2922500.0, 174375.0 / 388108.0, 0.25, 0, 0},
        {15267082809.0 / 155376265600.0, -71443401.0 / 120774400.0, 730878875.0 / 902184768.0,
         2285395.0 / 8070912.0, 0.25, 0},
        {82889.0 / 524892.0, 0, 15625.0 / 83664.0, 69875.0 / 102672.0, -2260.0 / 8211.0, 0.25},
    }};
    static constexpr std::array<double, 6> embedded{
        4586570599.0 / 29645900160.0, 0,
        178811875.0 / 945068544.0,    814220225.0 / 1159782912.0,
        -3700637.0 / 11593932.0,      61727.0 / 225920.0};
};

} // namespace searle::solvers::radial
